# Run when Sunder is installed: writes `copyright`, which begins with `licence`, Sunder's, and goes on with those of the libraries
# whose code becomes part of the program. Their Debian packages have them; what is linked with as a shared library comes with its own.
file(READ ${licence} text)
string(PREPEND text "Sunder\n======\n\n")
foreach(package libeigen3-dev libglm-dev nlohmann-json3-dev libcli11-dev libtomlplusplus-dev libstb-dev libimgui-dev libhwy-dev
        libtbb-dev python3-glad)
  set(file /usr/share/doc/${package}/copyright)
  if(NOT EXISTS ${file})
    message(WARNING "${file} is not there: add the licence of that library to ${copyright} before you pass the program on")
    continue()
  endif()
  file(READ ${file} of_package)
  string(REGEX REPLACE "." "=" line ${package})
  string(APPEND text "\n\nCode of ${package} in it\n================${line}\n\n${of_package}")
endforeach()
file(WRITE ${copyright} "${text}")
