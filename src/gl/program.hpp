#pragma once
#include <string>
#include <utility>
#include <vector>

#include "gl/objects.hpp"
#include "gl/shader_assembly.hpp"

namespace sunder::gl {

struct ProgramDescription {
    std::string vertex = {};    ///< file under glsl/, as are the next three; empty: none
    std::string geometry = {};  ///< empty: none
    std::string fragment = {};  ///< empty: none
    std::string compute = {};   ///< alone, in GLSL 4.30; empty: none
    Defines defines = {};
    std::vector<std::string> feedback = {};  ///< transform feedback varyings, interleaved
    std::vector<std::pair<std::string, int>> attributes = {};  ///< name, location
    ShaderSource source = currentShaders();
};

/// A linked program. Compile and link errors throw std::runtime_error with the driver's log, file
/// names in place of numbers.
class Program {
  public:
    Program() = default;
    explicit Program(const ProgramDescription&);
    GLuint id() const { return handle_.id(); }
    explicit operator bool() const { return id() != 0; }
    void use() const;
    /// −1 when the linker dropped it; GL ignores writes there.
    GLint uniform(const char* name) const;
    /// Sampler `name` reads texture unit `unit`. Uses the program.
    void bindSampler(const char* name, int unit) const;
    /// Does nothing when the linker dropped the block.
    void bindUniformBlock(const char* name, int binding) const;

  private:
    Handle<deleteProgram> handle_;
};

}  // namespace sunder::gl
