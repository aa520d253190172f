# What is installed, and the packages that tools/package makes of it: a .deb and a tarball, for the release they were built on.
include(GNUInstallDirs)

install(TARGETS sunder RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
install(FILES README.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
if(NOT UNIX OR APPLE)
  return()
endif()

# A tarball is for people who have no package manager look after what the program needs, so it says that itself. tools/package
# writes this between the .deb, whose dependencies it lists, and the tarball.
install(FILES ${CMAKE_BINARY_DIR}/packages/READ-ME-FIRST DESTINATION . COMPONENT program OPTIONAL)
install(FILES tools/cmake/sunder.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT program)
foreach(component program library)
  set(folder ${CMAKE_INSTALL_DOCDIR})
  if(component STREQUAL "library")
    set(folder ${CMAKE_INSTALL_DATADIR}/doc/libsunder-dev)
  endif()
  install(CODE "set(copyright \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${folder}/copyright\")
                set(licence \"${PROJECT_SOURCE_DIR}/LICENSE\")" COMPONENT ${component})
  install(SCRIPT tools/cmake/copyright.cmake COMPONENT ${component})
endforeach()
# tools/package has built the program; the tests, which `all` has too, are in no package.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)

cmake_host_system_information(RESULT release QUERY DISTRIB_INFO)
set(CPACK_GENERATOR DEB TGZ)
set(CPACK_INSTALL_CMAKE_PROJECTS "${CMAKE_BINARY_DIR};sunder;program;/")
set(CPACK_STRIP_FILES ON)
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGE_VENDOR "The Sunder authors")
set(CPACK_PACKAGE_CONTACT "The Sunder authors")
set(CPACK_PACKAGE_DESCRIPTION
    "Sunder breaks walls of wood, brick, concrete, glass and rubber in real time, in a window or into pictures, videos and\n\
reports: tetrahedral finite elements on any GPU that speaks OpenGL 4.1, or on the CPU.")
# Two releases have libraries of other versions, so their packages have other names.
set(CPACK_SYSTEM_NAME ${release_ID}${release_VERSION_ID}-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_DEBIAN_PACKAGE_RELEASE 1~${release_ID}${release_VERSION_ID})
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Beyond what it is linked with: a driver for machines without a GPU, the panels' letters, `--video`, and what GLFW looks for by
# itself: several screens, a mouse's motion as it is, sized pointers, title bars under Wayland.
set(recommended libgl1-mesa-dri fonts-dejavu-core ffmpeg libxrandr2 libxinerama1 libxi6 libxcursor1
  "libdecor-0-plugin-1-gtk | libdecor-0-plugin-1-cairo")
list(JOIN recommended ", " CPACK_DEBIAN_PACKAGE_RECOMMENDS)
include(CPack)
