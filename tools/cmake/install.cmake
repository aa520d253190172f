# The library as others find it: headers, CMake's package, pkg-config.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

get_target_property(type sunder_library TYPE)
set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/sunder)
set(exported sunder_library)
if(SUNDER_GL)
  list(APPEND exported sunder_with_gl)
endif()
install(TARGETS ${exported} EXPORT sunder COMPONENT library
  ARCHIVE COMPONENT library LIBRARY COMPONENT library RUNTIME COMPONENT library
  FILE_SET HEADERS COMPONENT library)
install(EXPORT sunder NAMESPACE sunder:: DESTINATION ${config_dir} FILE sunder-targets.cmake COMPONENT library)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/sunder-config.cmake.in ${PROJECT_BINARY_DIR}/sunder-config.cmake
  INSTALL_DESTINATION ${config_dir} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/sunder-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/sunder-config.cmake ${PROJECT_BINARY_DIR}/sunder-config-version.cmake
  DESTINATION ${config_dir} COMPONENT library)

# Who links a static library needs what it was made with, too.
set(pc_private "")
set(pc_flags "")
if(type STREQUAL "STATIC_LIBRARY")
  set(pc_private "-lhwy -ltbb -lstdc++ -lm")
elseif(WIN32)
  set(pc_flags "-DSUNDER_SHARED")
endif()
file(RELATIVE_PATH pc_prefix "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
configure_file(${CMAKE_CURRENT_LIST_DIR}/sunder.pc.in ${PROJECT_BINARY_DIR}/sunder.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/sunder.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT library)
