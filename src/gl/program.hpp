#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gl/objects.hpp"

namespace sunder::gl {

/// Where shader text comes from: name ("physics/polar.glsl") to text, or nullopt.
using ShaderSource = std::function<std::optional<std::string>(std::string_view name)>;

/// The files under glsl/, as compiled in.
ShaderSource embeddedShaders();

using Defines = std::vector<std::pair<std::string, std::string>>;

/// The full text of a shader: `#version 410 core`, the defines, then the file with each `#include "name"` (names relative to
/// glsl/) replaced once, with #line directives. `files` receives the name behind each source-string number.
/// Throws std::runtime_error naming the file and line of an include that is not there.
std::string assembleShader(const ShaderSource&, std::string_view name, const Defines&,
                           std::vector<std::string>& files);

struct ProgramDescription {
    std::string vertex;
    std::string geometry = {};  ///< empty: none
    std::string fragment = {};  ///< empty: none
    Defines defines = {};
    std::vector<std::string> feedback = {};  ///< transform feedback varyings, interleaved
    std::vector<std::pair<std::string, int>> attributes = {};
    ShaderSource source = embeddedShaders();
};

/// A linked program. Compile and link errors throw std::runtime_error with the driver's log, file names in place of numbers.
class Program {
  public:
    Program() = default;
    explicit Program(const ProgramDescription&);
    GLuint id() const { return handle_.id(); }
    void use() const;
    /// −1 when the linker dropped it; GL ignores writes there.
    GLint uniform(const char* name) const;
    /// Sampler `name` reads texture unit `unit`. Uses the program.
    void bindSampler(const char* name, int unit) const;
    void bindUniformBlock(const char* name, int binding) const;

  private:
    Handle<deleteProgram> handle_;
};

}  // namespace sunder::gl
