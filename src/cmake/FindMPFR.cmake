# MPFR and GMP, which it is built on: the target MPFR::mpfr.
find_path(MPFR_INCLUDE_DIR mpfr.h)
find_library(MPFR_LIBRARY mpfr)
find_library(GMP_LIBRARY gmp)
mark_as_advanced(MPFR_INCLUDE_DIR MPFR_LIBRARY GMP_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(MPFR REQUIRED_VARS MPFR_LIBRARY GMP_LIBRARY MPFR_INCLUDE_DIR)

if(MPFR_FOUND AND NOT TARGET MPFR::mpfr)
  add_library(MPFR::mpfr INTERFACE IMPORTED)
  target_include_directories(MPFR::mpfr INTERFACE ${MPFR_INCLUDE_DIR})
  target_link_libraries(MPFR::mpfr INTERFACE ${MPFR_LIBRARY} ${GMP_LIBRARY})
endif()
