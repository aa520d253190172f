# Run when glad has made `header`: writes `calls`, by which glFoo(...) means, in every source of Sunder's, the function Foo of the
# context that is current on the calling thread (src/gl/functions.hpp). Made for several contexts (--mx), glad's header itself has
# a structure of function pointers and no names beginning with gl.
file(STRINGS ${header} members REGEX "^    PFNGL[A-Z0-9_]+PROC [A-Za-z0-9_]+;$")
set(lines "#pragma once\n// Made by tools/cmake/gl_calls.cmake.\n")
foreach(member IN LISTS members)
  string(REGEX MATCH "PROC ([A-Za-z0-9_]+)" found "${member}")
  string(APPEND lines "#define gl${CMAKE_MATCH_1} (::sunder::gl::functions().${CMAKE_MATCH_1})\n")
endforeach()
list(LENGTH members count)
if(count LESS 400)
  message(FATAL_ERROR "only ${count} functions were found in ${header}; does this version of glad write it differently?")
endif()
file(WRITE ${calls} "${lines}")
