#include "cpu/cpu_objects.hpp"

#include <utility>

namespace sunder::cpu {

using namespace core;

ObjectCells::ObjectCells(const World& world, std::vector<const BodyArrays*> bodies,
                         const Contact& contact)
    : world_(world), bodies_(std::move(bodies)), contact_(contact) {}

ObjectCells::Bounds ObjectCells::bounds(int body) const {
    const Contact::Box box = contact_.boundsOf(body);
    return {Vec3(box.low[0], box.low[1], box.low[2]), Vec3(box.high[0], box.high[1], box.high[2])};
}

ObjectCells::Place ObjectCells::placeOf(int cell) const {
    const int body = world_.bodyOf(cell);
    const IVec3 c = world_.bodies()[body].coordinates(cell);
    return {bodies_[body], bodies_[body]->place(c[0], c[1], c[2])};
}

CellMotion ObjectCells::motion(int cell) const {
    const auto [arrays, local] = placeOf(cell);
    CellMotion motion;
    const Vec3 first = world_.restPosition(kCorners * cell);
    const Mat3& axes = world_.bodies()[world_.bodyOf(cell)].axes;
    for (int corner = 0; corner < kCorners; ++corner) {
        motion.position[corner] = first + axes * world_.cornerOffset(cell, corner);
        for (int axis = 0; axis < 3; ++axis) {
            const std::ptrdiff_t at = tiled(kNodeComponents, 3 * corner + axis, local);
            motion.position[corner][axis] += arrays->displacement[at];
            motion.velocity[corner][axis] = arrays->velocity[at];
        }
    }
    return motion;
}

std::uint8_t ObjectCells::links(int cell, int corner) const {
    const auto [arrays, local] = placeOf(cell);
    return arrays->links[tiled(kCorners, corner, local)];
}

void ObjectCells::push(int cell, const std::array<double, kCorners>& weights, const Vec3& force) {
    const auto [arrays, local] = placeOf(cell);
    for (int corner = 0; corner < kCorners; ++corner)
        for (int axis = 0; axis < 3; ++axis)
            arrays->force[(3 * corner + axis) * arrays->stride + local] +=
                static_cast<float>(weights[corner] * force[axis]);
}

}  // namespace sunder::cpu
