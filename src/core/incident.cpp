#include "core/incident.hpp"

#include <algorithm>
#include <cmath>

namespace sunder::core {

int stepsPerLook(const World& world) {
    return std::max(1, static_cast<int>(std::lround(1 / (60 * world.step()))));
}

Incident breakOf(const World& world, int bond, std::int64_t step) {
    Incident incident;
    incident.kind = Incident::Kind::Break;
    incident.step = step;
    incident.cell = bond / kBondsPerCell;
    const int axis = bond % kBondsPerCell;
    incident.other = world.neighbour(incident.cell, axis, +1);
    double strength = world.bondStrength(bond);  // Pa
    for (const int cell : {incident.cell, incident.other})
        strength = std::min(strength, world.laws()[world.lawOf(cell)].maxStress);
    const Vec3& size = world.bodies()[world.bodyOf(incident.cell)].cellSize;
    const double interval = world.fractureInterval() * world.step();
    incident.impulse = strength * size.prod() / size[axis] * interval;
    return incident;
}

double blow(double now, double before, double earlier) {
    return now - std::min(before, earlier);
}

std::vector<std::string> materialsOf(const World& world, const Incident& incident) {
    std::vector<std::string> names;
    for (const int cell : {incident.cell, incident.other})
        if (cell >= 0) names.push_back(world.materialOf(cell).name);
    return names;
}

IncidentRing::IncidentRing(std::size_t capacity) : slots_(std::max<std::size_t>(1, capacity)) {}

void IncidentRing::push(const Incident& incident) {
    const auto capacity = static_cast<std::int64_t>(slots_.size());
    slots_[pushed_++ % capacity] = incident;
    if (pushed_ - taken_ <= capacity) return;
    ++taken_;
    ++dropped_;
}

std::vector<Incident> IncidentRing::take() {
    std::vector<Incident> news;
    while (taken_ < pushed_)
        news.push_back(slots_[taken_++ % static_cast<std::int64_t>(slots_.size())]);
    return news;
}

}  // namespace sunder::core
