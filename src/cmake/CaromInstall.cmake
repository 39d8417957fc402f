# install(), export and the package files for find_package(carom).
include(CMakePackageConfigHelpers)

set(carom_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/carom)

install(TARGETS carom EXPORT caromTargets)
install(DIRECTORY include/carom TYPE INCLUDE FILES_MATCHING PATTERN "*.hpp" PATTERN game_engine EXCLUDE)
install(EXPORT caromTargets NAMESPACE carom:: DESTINATION ${carom_package_dir})

configure_package_config_file(src/cmake/caromConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/caromConfig.cmake
  INSTALL_DESTINATION ${carom_package_dir})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/caromConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/caromConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/caromConfigVersion.cmake
  src/cmake/FindHDF5C.cmake src/cmake/FindMPFI.cmake src/cmake/FindMPFR.cmake DESTINATION ${carom_package_dir})

# The program, if it was built.
if(TARGET carom_program)
  set_target_properties(carom_program PROPERTIES INSTALL_RPATH $ORIGIN/../${CMAKE_INSTALL_LIBDIR})
  install(TARGETS carom_program OPTIONAL)
endif()
