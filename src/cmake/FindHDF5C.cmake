# HDF5's C library, the serial one: the target HDF5C::hdf5.
find_path(HDF5C_INCLUDE_DIR hdf5.h PATH_SUFFIXES hdf5/serial)
find_library(HDF5C_LIBRARY NAMES hdf5_serial hdf5)
mark_as_advanced(HDF5C_INCLUDE_DIR HDF5C_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(HDF5C REQUIRED_VARS HDF5C_LIBRARY HDF5C_INCLUDE_DIR)

if(HDF5C_FOUND AND NOT TARGET HDF5C::hdf5)
  add_library(HDF5C::hdf5 INTERFACE IMPORTED)
  target_include_directories(HDF5C::hdf5 INTERFACE ${HDF5C_INCLUDE_DIR})
  target_link_libraries(HDF5C::hdf5 INTERFACE ${HDF5C_LIBRARY})
endif()
