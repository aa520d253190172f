#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sunder::gl {

/// Where shader text comes from: name ("physics/polar.glsl") to text, or nullopt.
using ShaderSource = std::function<std::optional<std::string>(std::string_view name)>;

/// The files under glsl/, as compiled in.
ShaderSource embeddedShaders();

/// Where programs that name no source take their shaders from: embeddedShaders(), unless
/// useShaders() said otherwise of the context that is current on this thread.
const ShaderSource& currentShaders();
/// For the current context, which there must be.
void useShaders(ShaderSource);

using Defines = std::vector<std::pair<std::string, std::string>>;

/// These and one more.
inline Defines with(Defines defines, const char* name, const char* value) {
    defines.push_back({name, value});
    return defines;
}

/// The full text of a shader: `#version 410 core` (or `version`), the defines, then the file with
/// each `#include "name"` (names relative to glsl/) replaced once, with #line directives. Includes
/// are replaced before the preprocessor looks at conditions: keep them out of #if. `#pragma once`
/// is dropped, every file being included once anyway.
///
/// `files` receives the name behind each source-string number. It is appended to: give the stages
/// of one program the same vector, and a number means one file in all of them.
///
/// Throws std::runtime_error naming the file and line of an include that is not there, or of a
/// `#version`.
std::string assembleShader(const ShaderSource&, std::string_view name, const Defines&,
                           std::vector<std::string>& files, int version = 410);

/// A driver's log with file names in place of source-string numbers. Knows the formats of Mesa
/// "3:12(5): error: …", NVIDIA "3(12) : error …" and of Apple, AMD and Intel "ERROR: 3:12: …";
/// leaves other lines alone.
std::string nameFilesInLog(std::string_view log, const std::vector<std::string>& files);

}  // namespace sunder::gl
