#pragma once
#include <cstdint>

#include "core/world.hpp"

/// A world with one body of cubic cells of 0.1 m made of `material`: no gravity, no ground, no
/// anchors, no events.
sunder::WorldDescription block(sunder::IVec3 cells, sunder::Material material);

/// E 1e6 Pa, ν 0.3, 1000 kg/m³, no drag, unbreakable.
sunder::Material softElastic();

/// Breaks by bonds at tractions a hit of a few m/s reaches.
sunder::Material brittle();

/// A change of velocity (m/s) of a patch of 0.25 m radius around `point` (m, from the body's
/// position) at time 0.
sunder::EventDescription hit(int body, const sunder::Vec3& point, const sunder::Vec3& velocity);

/// Uniform numbers in [−1, 1), the same on every machine.
class Random {
  public:
    explicit Random(std::uint64_t seed) : seed_(seed) {}
    double operator()();
    sunder::Vec3 vector();
    sunder::Mat3 matrix();
    sunder::Mat3 rotation();

  private:
    std::uint64_t seed_, counter_ = 0;
};

/// Breaks the bond of `cell` through its +axis face.
void breakBond(sunder::State&, int cell, int axis);
/// Breaks all bonds of `cell`.
void detach(const sunder::World&, sunder::State&, int cell);

/// Nodes that differ from a node they are joined to in any bit of displacement or velocity.
int tornNodes(const sunder::World&, const sunder::State&);

/// The same with numbers that every solver can hold.
sunder::State roundedToSingle(sunder::State state);
/// By how much a node's displacement or velocity differs at most.
double largestDifference(const std::vector<sunder::Vec3>& a, const std::vector<sunder::Vec3>& b);
/// kg·m/s, of nodes and objects without regard to direction: what momenta are compared with.
double momentumScale(const sunder::World&, const sunder::State&);
