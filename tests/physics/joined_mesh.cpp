#include "physics/joined_mesh.hpp"

#include "core/tetrahedra.hpp"
#include "physics/physics_worlds.hpp"

using namespace sunder;
using namespace sunder::core;

std::vector<Vec3> JoinedMesh::atPoints(const std::vector<Vec3>& field) const {
    std::vector<Vec3> result(points.size());
    for (std::size_t node = 0; node < pointOf.size(); ++node)
        if (pointOf[node] >= 0) result[pointOf[node]] = field[node];
    return result;
}

JoinedMesh joinedMesh(const World& world) {
    const Body& body = world.bodies()[0];
    const IVec3 sides = body.cells + IVec3::Ones();
    std::vector<int> pointAt(sides.prod(), -1);
    JoinedMesh mesh;
    mesh.pointOf.assign(world.nodeCount(), -1);
    for (int node = 0; node < world.nodeCount(); ++node) {
        const int cell = node / kCorners, corner = node % kCorners;
        if (!world.present(cell)) continue;
        const IVec3 c = body.coordinates(cell) + IVec3(corner & 1, corner >> 1 & 1, corner >> 2);
        int& point = pointAt[c[0] + sides[0] * (c[1] + sides[1] * c[2])];
        if (point < 0) {
            point = static_cast<int>(mesh.points.size());
            mesh.points.push_back(latticePosition(world, node));
            mesh.anchored.push_back(false);
            mesh.mass.push_back(0);
        }
        mesh.anchored[point] = mesh.anchored[point] || world.anchored(node);
        mesh.mass[point] += world.nodeMass(node);
        mesh.pointOf[node] = point;
    }
    for (int cell = 0; cell < world.cellCount(); ++cell) {
        if (!world.present(cell)) continue;
        for (const Tetrahedron& corners : kTetrahedra[world.parity(cell)]) {
            std::array<int, 4>& tetrahedron = mesh.tetrahedra.emplace_back();
            for (int i = 0; i < 4; ++i) tetrahedron[i] = mesh.pointOf[kCorners * cell + corners[i]];
        }
    }
    return mesh;
}
