# Toolchain for ARM 64 on another machine: Debian's cross compiler, libraries that tools/arm has put into build-arm/root,
# and an emulator for the tests.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)

get_filename_component(root ${CMAKE_CURRENT_LIST_DIR}/../../build-arm/root ABSOLUTE)
# The compiler brings headers and libraries of the system itself; all others come from there, none from this machine.
set(CMAKE_FIND_ROOT_PATH ${root})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
foreach(kind LIBRARY INCLUDE PACKAGE)
  set(CMAKE_FIND_ROOT_PATH_MODE_${kind} ONLY)
endforeach()
# Libraries that libraries need.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-Wl,-rpath-link,${root}/usr/lib/aarch64-linux-gnu")

# By its path: a test may have a PATH without it.
find_program(SUNDER_QEMU qemu-aarch64-static)
if(SUNDER_QEMU)
  set(CMAKE_CROSSCOMPILING_EMULATOR ${SUNDER_QEMU} -L ${root})
endif()
