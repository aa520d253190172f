# Every dependency: a system package first (apt, see tools/install-packages), else vcpkg (vcpkg.json).
# No third-party code is copied into this repository.

# --- The library ---

find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(hwy 1.0 REQUIRED CONFIG) # SIMD
find_package(TBB REQUIRED CONFIG)     # threads: oneTBB

# toml++: its headers. What else it has is compiled in one place (src/scene/toml_library.cpp), where others would compile all of it or
# need its library.
find_path(TOML_INCLUDE_DIR toml++/toml.h REQUIRED)
add_library(sunder_toml INTERFACE)
target_include_directories(sunder_toml SYSTEM INTERFACE ${TOML_INCLUDE_DIR})

if(NOT SUNDER_GL)
  return()
endif()

# --- Its part on the GPU ---

find_package(glm REQUIRED)

# glad: OpenGL 4.1 core, generated at build time by the `glad` tool (Debian: python3-glad; elsewhere: the Python package glad2).
# A table of functions for each context (--mx), none of the process. Without --reproducible it would fetch the specification from
# the network. The extensions are those that tell of errors and of a lost context, those whose state a host may have set so that
# OpenGL 4.1's own draws come out differently (src/gl/guest_state.cpp), and the two that the solver `compute` needs, which are part
# of OpenGL 4.3; all else does without any of them.
set(SUNDER_GL_EXTENSIONS
  GL_KHR_debug GL_KHR_robustness GL_ARB_robustness
  GL_ARB_compute_shader GL_ARB_shader_image_load_store
  GL_ARB_clip_control GL_ARB_ES3_compatibility GL_ARB_polygon_offset_clamp GL_ARB_query_buffer_object
  GL_EXT_depth_bounds_test GL_EXT_raster_multisample GL_EXT_window_rectangles
  GL_INTEL_conservative_rasterization GL_NV_conservative_raster GL_NV_fragment_coverage_to_color
  GL_NV_representative_fragment_test GL_NV_scissor_exclusive GL_NV_shading_rate_image GL_NV_viewport_swizzle)
find_program(GLAD_EXECUTABLE glad REQUIRED)
set(glad_dir ${PROJECT_BINARY_DIR}/glad)
list(JOIN SUNDER_GL_EXTENSIONS "," gl_extensions)
add_custom_command(
  OUTPUT ${glad_dir}/src/gl.c ${glad_dir}/include/glad/gl.h ${glad_dir}/include/glad/calls.h
  COMMAND ${GLAD_EXECUTABLE} --api gl:core=4.1 --extensions ${gl_extensions} --reproducible --quiet --out-path ${glad_dir} c --mx
  COMMAND ${CMAKE_COMMAND} -Dheader=${glad_dir}/include/glad/gl.h -Dcalls=${glad_dir}/include/glad/calls.h
          -P ${PROJECT_SOURCE_DIR}/tools/cmake/gl_calls.cmake
  DEPENDS ${PROJECT_SOURCE_DIR}/tools/cmake/gl_calls.cmake
  COMMENT "Generating glad (OpenGL 4.1 core)"
  VERBATIM)
add_library(sunder_glad STATIC ${glad_dir}/src/gl.c ${glad_dir}/include/glad/calls.h)
target_include_directories(sunder_glad SYSTEM PUBLIC ${glad_dir}/include)
# A host may have a glad of its own.
target_compile_definitions(sunder_glad PUBLIC
  gladLoadGLContext=sunder_gladLoadGLContext gladLoadGLContextUserPtr=sunder_gladLoadGLContextUserPtr)

if(NOT SUNDER_PROGRAM)
  return()
endif()

# --- The program ---

find_package(Threads REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(glfw3 3.3 REQUIRED) # windows

# stb: headers only; Debian puts them in <stb/...>, vcpkg beside the other headers.
find_path(STB_INCLUDE_DIR stb_image_write.h PATH_SUFFIXES stb REQUIRED)
add_library(sunder_stb INTERFACE)
target_include_directories(sunder_stb SYSTEM INTERFACE ${STB_INCLUDE_DIR})

# Dear ImGui with its backends for GLFW and OpenGL 3: vcpkg has a CMake package; Debian one static library, which leaves stb to
# whoever links it.
find_package(imgui CONFIG QUIET)
if(TARGET imgui::imgui)
  add_library(sunder_imgui ALIAS imgui::imgui)
else()
  find_path(IMGUI_INCLUDE_DIR imgui.h PATH_SUFFIXES imgui REQUIRED)
  find_library(IMGUI_LIBRARY imgui REQUIRED)
  find_library(STB_LIBRARY stb REQUIRED)
  add_library(sunder_imgui INTERFACE)
  target_include_directories(sunder_imgui SYSTEM INTERFACE ${IMGUI_INCLUDE_DIR} ${IMGUI_INCLUDE_DIR}/backends)
  target_link_libraries(sunder_imgui INTERFACE ${IMGUI_LIBRARY} ${STB_LIBRARY} glfw)
endif()

if(SUNDER_CONTEXT STREQUAL "egl")
  find_package(OpenGL REQUIRED COMPONENTS EGL)
elseif(NOT SUNDER_CONTEXT STREQUAL "glfw")
  message(FATAL_ERROR "SUNDER_CONTEXT is '${SUNDER_CONTEXT}'; it must be egl or glfw")
endif()

if(BUILD_TESTING OR NOT DEFINED BUILD_TESTING)
  find_package(Catch2 REQUIRED) # 2.13 (Debian 12) or 3 (vcpkg): tests/catch.hpp hides the difference
endif()
