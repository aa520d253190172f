#include "gl/program.hpp"

#include <stdexcept>

#include "gl/device_failure.hpp"

namespace sunder::gl {
namespace {

void deleteShader(GLuint id) {
    glDeleteShader(id);
}
using Shader = Handle<deleteShader>;

/// Log of a shader or a program: glGetShaderiv and glGetShaderInfoLog, or those of programs.
template <class GetInteger, class GetLog>
std::string infoLog(GLuint id, GetInteger getInteger, GetLog getLog) {
    GLint length = 0;
    getInteger(id, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    GLsizei written = 0;
    getLog(id, length, &written, log.data());
    log.resize(static_cast<std::size_t>(written));
    return log;
}

Shader compile(GLenum stage, const std::string& name, const ProgramDescription& description,
               std::vector<std::string>& files) {
    const int version = stage == GL_COMPUTE_SHADER ? 430 : 410;
    const std::string text =
        assembleShader(description.source, name, description.defines, files, version);
    const char* const pointer = text.c_str();
    const GLint length = static_cast<GLint>(text.size());
    Shader shader(glCreateShader(stage));
    glShaderSource(shader.id(), 1, &pointer, &length);
    glCompileShader(shader.id());
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &compiled);
    if (!compiled) {
        if (contextLost()) failContextLost();
        throw std::runtime_error(
            "shader " + name + " does not compile:\n" +
            nameFilesInLog(infoLog(shader.id(), glGetShaderiv, glGetShaderInfoLog), files));
    }
    return shader;
}

void link(GLuint program, const ProgramDescription& description) {
    for (const auto& [name, location] : description.attributes)
        glBindAttribLocation(program, static_cast<GLuint>(location), name.c_str());
    if (!description.feedback.empty()) {
        std::vector<const char*> names;
        for (const std::string& name : description.feedback) names.push_back(name.c_str());
        glTransformFeedbackVaryings(program, static_cast<GLsizei>(names.size()), names.data(),
                                    GL_INTERLEAVED_ATTRIBS);
    }
    glLinkProgram(program);
}

}  // namespace

Program::Program(const ProgramDescription& description) : handle_(glCreateProgram()) {
    std::vector<std::string> files;
    std::vector<Shader> shaders;
    std::string names;
    const auto add = [&](GLenum stage, const std::string& name) {
        if (name.empty()) return;
        shaders.push_back(compile(stage, name, description, files));
        glAttachShader(id(), shaders.back().id());
        names += (names.empty() ? "" : " + ") + name;
    };
    add(GL_VERTEX_SHADER, description.vertex);
    add(GL_GEOMETRY_SHADER, description.geometry);
    add(GL_FRAGMENT_SHADER, description.fragment);
    add(GL_COMPUTE_SHADER, description.compute);

    link(id(), description);
    for (const Shader& shader : shaders) glDetachShader(id(), shader.id());
    GLint linked = GL_FALSE;
    glGetProgramiv(id(), GL_LINK_STATUS, &linked);
    if (!linked) {
        if (contextLost()) failContextLost();
        throw std::runtime_error(
            "program " + names + " does not link:\n" +
            nameFilesInLog(infoLog(id(), glGetProgramiv, glGetProgramInfoLog), files));
    }
}

void Program::use() const {
    glUseProgram(id());
}

GLint Program::uniform(const char* name) const {
    return glGetUniformLocation(id(), name);
}

void Program::bindSampler(const char* name, int unit) const {
    use();
    glUniform1i(uniform(name), unit);
}

void Program::bindUniformBlock(const char* name, int binding) const {
    const GLuint index = glGetUniformBlockIndex(id(), name);
    if (index != GL_INVALID_INDEX) glUniformBlockBinding(id(), index, static_cast<GLuint>(binding));
}

}  // namespace sunder::gl
