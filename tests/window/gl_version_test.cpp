// macOS has OpenGL 4.1 and GLSL 4.10, and nothing newer will come to it.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include "catch.hpp"
#include "gl/functions.hpp"
#include "gl/shader_assembly.hpp"

namespace fs = std::filesystem;
using namespace sunder;

namespace {

/// The version a shader asks for, such as 410; 0: none.
int versionOf(const std::string& text) {
    static const std::regex directive("(^|\\n)[ \\t]*#[ \\t]*version[ \\t]+([0-9]+)");
    std::smatch found;
    return std::regex_search(text, found, directive) ? std::stoi(found[2]) : 0;
}

/// Asks for what the driver may have besides its version.
bool wantsExtension(const std::string& text) {
    static const std::regex directive("(^|\\n)[ \\t]*#[ \\t]*extension\\b");
    return std::regex_search(text, directive);
}

}  // namespace

// Of extensions there are some (third_party/dependencies.cmake): with their functions, state that a
// host's newer context has is set to what OpenGL 4.1 takes for granted. Sunder computes without.
TEST_CASE("no entry point newer than OpenGL 4.1 is loaded") {
#ifndef GL_VERSION_4_1
    FAIL("the loader that glad has made does not know OpenGL 4.1");
#endif
#ifdef GL_VERSION_4_2
    FAIL("glad has made a loader for more than OpenGL 4.1: see third_party/dependencies.cmake");
#endif
}

TEST_CASE("no shader asks for more than GLSL 4.10") {
    CHECK(versionOf("// old\n # version 430 core\n") == 430);
    CHECK(wantsExtension("\n#extension GL_ARB_compute_shader : enable"));
    int stages = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(SUNDER_SHADERS)) {
        if (!entry.is_regular_file()) continue;
        const std::string name = entry.path().lexically_relative(SUNDER_SHADERS).generic_string();
        INFO(name);
        std::ifstream file(entry.path(), std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        CHECK(versionOf(text) <= 410);
        CHECK(!wantsExtension(text));
        if (name.ends_with(".glsl") || name.ends_with(".h")) continue;
        std::vector<std::string> files;
        CHECK(versionOf(gl::assembleShader(gl::embeddedShaders(), name, {}, files)) == 410);
        ++stages;
    }
    CHECK(stages > 20);
}
