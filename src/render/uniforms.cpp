#include "render/uniforms.hpp"

#include <glm/gtc/type_ptr.hpp>

namespace sunder::render {

void setUniform(const gl::Program& program, const char* name, const glm::mat4& value) {
    glUniformMatrix4fv(program.uniform(name), 1, GL_FALSE, glm::value_ptr(value));
}

void setUniform(const gl::Program& program, const char* name, const glm::mat3& value) {
    glUniformMatrix3fv(program.uniform(name), 1, GL_FALSE, glm::value_ptr(value));
}

void setUniform(const gl::Program& program, const char* name, const glm::vec2& value) {
    glUniform2fv(program.uniform(name), 1, glm::value_ptr(value));
}

void setUniform(const gl::Program& program, const char* name, const glm::vec3& value) {
    glUniform3fv(program.uniform(name), 1, glm::value_ptr(value));
}

void setUniform(const gl::Program& program, const char* name, const glm::vec4& value) {
    glUniform4fv(program.uniform(name), 1, glm::value_ptr(value));
}

void setUniform(const gl::Program& program, const char* name, float value) {
    glUniform1f(program.uniform(name), value);
}

void setUniform(const gl::Program& program, const char* name, bool value) {
    glUniform1i(program.uniform(name), value ? 1 : 0);
}

}  // namespace sunder::render
