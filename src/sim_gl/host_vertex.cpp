#include "sim_gl/host_vertex.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "gl/shader_assembly.hpp"

namespace sunder::sim_gl {

namespace {

/// Global names and macros of draw/display.vert and of what it includes, but for those that begin
/// with SUNDER_ already. A test finds what is missing here.
// clang-format off
constexpr std::string_view kNames[] = {
    "BlockRecord", "BodyRecord", "BondRecord", "CELL_STRIDE", "CORNER_STRIDE", "DAMAGE_STRIDE",
    "DEPTH_ONLY", "ElementLaw", "EventRecord", "HOST_VERTEX", "Lattice", "LinkRecord", "NodeRecord",
    "ObjectMotion", "ObjectRecord", "PASSED", "PASSED_FLAT", "PartingRecord", "SURFACE",
    "SurfaceLook", "TURNED", "alongAxes", "bodies", "boundaryFace", "cells", "damage",
    "damageStride", "displacementAt", "displacementOf", "displacementStrides", "displacements",
    "displayedVertex", "groupAround", "hidden", "inWorld", "insideFace", "latticeOf", "linkMask",
    "linkMaskOf", "main", "normal", "outsideNormal", "owner", "paintedCell", "patchAxes",
    "patchNormal", "place", "position", "rest", "seed", "start", "surfaceLaw", "tangent",
    "viewProjection"};
// clang-format on
static_assert(std::is_sorted(std::begin(kNames), std::end(kNames)));

/// With sunder_ before each of those, unless it is a member's or in a comment.
std::string renamed(std::string_view text) {
    const auto isWord = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
    };
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
        std::size_t end = i;
        if (text.compare(i, 2, "//") == 0) {
            end = std::min(text.find('\n', i), text.size());
            result += text.substr(i, end - i);
            i = end;
            continue;
        }
        while (end < text.size() && isWord(text[end])) ++end;
        const std::string_view word = text.substr(i, end - i);
        const bool isName = std::binary_search(std::begin(kNames), std::end(kNames), word);
        if (isName && (i == 0 || text[i - 1] != '.')) result += "sunder_";
        result += word;
        if (end < text.size()) result += text[end];
        i = end + 1;
    }
    return result;
}

/// Without `#version` and `#line`: a host's text has them, or has others.
std::string withoutLines(std::string_view text) {
    std::string result;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view line = text.substr(begin, end - begin);
        begin = end + 1;
        if (!line.starts_with("#line") && !line.starts_with("#version")) (result += line) += '\n';
    }
    return result;
}

}  // namespace

std::string hostVertexShader(const gpu::StateView& state, bool turned) {
    const gl::Defines defines =
        gpu::withTurned({{"HOST_VERTEX", "1"},
                         {"SURFACE", "1"},
                         {"DAMAGE_STRIDE", std::to_string(state.damageStride)},
                         {"CELL_STRIDE", std::to_string(state.cellStride)},
                         {"CORNER_STRIDE", std::to_string(state.cornerStride)}},
                        turned);
    const gl::ShaderSource& source = gl::currentShaders();
    std::vector<std::string> files;
    std::string text =
        renamed(withoutLines(gl::assembleShader(source, "draw/display.vert", defines, files)));
    const std::optional<std::string> function = source("draw/host_vertex.glsl");
    if (!function) throw std::runtime_error("there is no shader file draw/host_vertex.glsl");
    return text + *function;
}

std::array<HostTexture, kHostTextures> hostTextures(const gpu::WorldBuffers& buffers,
                                                    const gpu::StateView& state) {
    return {{{"sunder_cells", buffers.cells().id()},
             {"sunder_bodies", buffers.bodies().id()},
             {"sunder_rest", buffers.rest().id()},
             {"sunder_damage", state.damage->id()},
             {"sunder_displacements", state.displacements->id()}}};
}

}  // namespace sunder::sim_gl
