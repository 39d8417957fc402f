# MPFI, intervals on top of MPFR: the target MPFI::mpfi.
find_package(MPFR QUIET)
find_path(MPFI_INCLUDE_DIR mpfi.h)
find_library(MPFI_LIBRARY mpfi)
mark_as_advanced(MPFI_INCLUDE_DIR MPFI_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(MPFI REQUIRED_VARS MPFI_LIBRARY MPFI_INCLUDE_DIR MPFR_FOUND)

if(MPFI_FOUND AND NOT TARGET MPFI::mpfi)
  add_library(MPFI::mpfi INTERFACE IMPORTED)
  target_include_directories(MPFI::mpfi INTERFACE ${MPFI_INCLUDE_DIR})
  target_link_libraries(MPFI::mpfi INTERFACE ${MPFI_LIBRARY} MPFR::mpfr)
endif()
