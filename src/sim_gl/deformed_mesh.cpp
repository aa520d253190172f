#include "sim_gl/deformed_mesh.hpp"

#include <cstddef>
#include <map>
#include <tuple>

#include "gl/vertex_array.hpp"
#include "gpu/wall_state.hpp"

namespace sunder::sim_gl {

using namespace core;

namespace {

std::vector<DeformedMesh::RestVertex> restVertices(const World& world,
                                                   const surface::DisplayMesh& mesh) {
    std::vector<DeformedMesh::RestVertex> vertices;
    vertices.reserve(mesh.vertices().size());
    for (const surface::DisplayVertex& from : mesh.vertices()) {
        const auto cell = static_cast<int>(from.cell);
        const int body = world.bodyOf(cell);
        const Body& of = world.bodies()[body];
        const Vec3 place = of.axes.transpose() * (from.rest.cast<double>() - of.origin);
        const int axis = static_cast<int>(from.code >> (SUNDER_DISPLAY_FACE_BIT + 1) & 3u);
        // Upright where the face is: along x or z, and up; from above, along x and z.
        const double u = place[axis == 0 ? 2 : 0], v = place[axis == 1 ? 2 : 1];
        vertices.push_back({{static_cast<float>(place[0]), static_cast<float>(place[1]),
                             static_cast<float>(place[2])},
                            {static_cast<float>(u), static_cast<float>(v)},
                            world.laws()[world.lawOf(cell)].material,
                            body,
                            cell,
                            (from.code & SUNDER_DISPLAY_FACE_INNER) != 0 ? 1 : 0,
                            0});
    }
    return vertices;
}

}  // namespace

DeformedMesh::DeformedMesh(const World& world, const gpu::WorldBuffers& buffers, bool pieces)
    : buffers_(buffers),
      program_({.vertex = "draw/display.vert",
                .defines = gpu::withTurned({{"SURFACE", "1"}}, buffers.turned()),
                .feedback = {"position", "normal", "tangent"}}) {
    const surface::DisplayMesh mesh(world);
    bodyFirst_.assign(1, 0);
    for (int vertex = 0; const surface::DisplayVertex& of : mesh.vertices()) {
        // One body's after another's.
        bodyFirst_.resize(world.bodyOf(static_cast<int>(of.cell)) + 1, vertex);
        ++vertex;
        if (pieces) cellOf_.push_back(of.cell);
    }
    bodyFirst_.resize(world.bodies().size() + 1, static_cast<int>(mesh.vertices().size()));
    bound_ = gl::makeBuffer(std::span(mesh.vertices()), GL_STATIC_DRAW, "display mesh");
    const std::vector<RestVertex> rest = restVertices(world, mesh);
    rest_ = gl::makeBuffer(std::span(rest), GL_STATIC_DRAW, "surface at rest");
    deformed_ = gl::Buffer(sizeof(Vertex) * rest.size(), nullptr, GL_DYNAMIC_COPY, "surface");
    if (pieces)
        pieces_ = gl::makeBuffer<std::int32_t>(std::vector<std::int32_t>(cellOf_.size()),
                                               GL_DYNAMIC_DRAW, "pieces");
    makeRanges(world, mesh);
    makeArrays();
    gpu::prepareWallState(program_, 0);
}

void DeformedMesh::makeRanges(const World& world, const surface::DisplayMesh& mesh) {
    // By what is opaque, by material, outside first.
    std::map<std::tuple<bool, int, bool>, std::vector<std::uint32_t>> parts;
    const std::vector<std::uint32_t>& indices = mesh.indices();
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        const surface::DisplayVertex& vertex = mesh.vertices()[indices[i]];
        const int material = world.laws()[world.lawOf(static_cast<int>(vertex.cell))].material;
        auto& part = parts[{i >= mesh.opaqueIndices(), material,
                            (vertex.code & SUNDER_DISPLAY_FACE_INNER) != 0}];
        part.insert(part.end(), indices.begin() + static_cast<std::ptrdiff_t>(i),
                    indices.begin() + static_cast<std::ptrdiff_t>(i) + 3);
    }
    std::vector<std::uint32_t> sorted;
    sorted.reserve(indices.size());
    for (const auto& [key, part] : parts) {
        const auto& [transparent, material, inside] = key;
        ranges_.push_back({material, inside, transparent, static_cast<int>(sorted.size()),
                           static_cast<int>(part.size())});
        sorted.insert(sorted.end(), part.begin(), part.end());
    }
    indices_ = gl::makeBuffer(std::span<const std::uint32_t>(sorted), GL_STATIC_DRAW, "surface");
}

void DeformedMesh::makeArrays() {
    using Bound = surface::DisplayVertex;
    std::vector<gl::VertexInput> source{{bound_,
                                         sizeof(Bound),
                                         {{0, 3, GL_FLOAT, offsetof(Bound, rest)},
                                          {1, 3, GL_UNSIGNED_INT, offsetof(Bound, cell)}}}};
    std::vector<gl::VertexInput> drawn{{deformed_,
                                        sizeof(Vertex),
                                        {{kPosition, 3, GL_FLOAT, offsetof(Vertex, position)},
                                         {kNormal, 3, GL_FLOAT, offsetof(Vertex, normal)},
                                         {kTangent, 4, GL_FLOAT, offsetof(Vertex, tangent)}}},
                                       {rest_,
                                        sizeof(RestVertex),
                                        {{kPlace, 3, GL_FLOAT, offsetof(RestVertex, place)},
                                         {kTexCoord, 2, GL_FLOAT, offsetof(RestVertex, texCoord)},
                                         {kMaterial, 1, GL_INT, offsetof(RestVertex, material)},
                                         {kBody, 1, GL_INT, offsetof(RestVertex, body)},
                                         {kCell, 1, GL_INT, offsetof(RestVertex, cell)},
                                         {kInside, 1, GL_INT, offsetof(RestVertex, inside)}}}};
    if (pieces_.size() > 0)
        for (std::vector<gl::VertexInput>* inputs : {&source, &drawn})
            inputs->push_back({pieces_, sizeof(std::int32_t), {{kPiece, 1, GL_INT, 0}}});
    boundArray_ = gl::makeVertexArray(source, &indices_);
    drawnArray_ = gl::makeVertexArray(drawn, &indices_);
}

void DeformedMesh::setPieces(const std::vector<int>& ofCell) {
    std::vector<std::int32_t> pieces;
    pieces.reserve(cellOf_.size());
    for (const std::uint32_t cell : cellOf_) pieces.push_back(ofCell[cell]);
    pieces_.write(0, sizeof(std::int32_t) * pieces.size(), pieces.data());
}

void DeformedMesh::update(const gpu::StateView& state, const std::vector<int>& bodies) const {
    if (bodies.empty()) return;
    program_.use();
    gpu::bindWallState(program_, buffers_, state, 0);
    for (std::size_t i = 0; i < bodies.size();) {
        Part several = part(bodies[i]);
        for (++i; i < bodies.size() && bodies[i] == bodies[i - 1] + 1; ++i)
            several.count += part(bodies[i]).count;
        if (several.count > 0)
            feedback_.runPart(program_, boundArray_, deformed_, sizeof(Vertex), several.first,
                              several.count);
    }
}

}  // namespace sunder::sim_gl
