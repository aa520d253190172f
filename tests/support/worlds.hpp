#pragma once
#include <cstdint>

#include "core/world.hpp"

/// A world with one body of cubic cells of 0.1 m made of `material`: no gravity, no ground, no
/// anchors, no events.
sunder::core::WorldDescription block(sunder::core::IVec3 cells, sunder::core::Material material);

/// E 1e6 Pa, ν 0.3, 1000 kg/m³, no drag, unbreakable.
sunder::core::Material softElastic();

/// Breaks by bonds at tractions a hit of a few m/s reaches.
sunder::core::Material brittle();

/// A change of velocity (m/s) of a patch of 0.25 m radius around `point` (m, from the body's
/// position) at time 0.
sunder::core::EventDescription hit(int body, const sunder::core::Vec3& point,
                                   const sunder::core::Vec3& velocity);

/// Uniform numbers in [−1, 1), the same on every machine.
class Random {
  public:
    explicit Random(std::uint64_t seed) : seed_(seed) {}
    double operator()();
    sunder::core::Vec3 vector();
    sunder::core::Mat3 matrix();
    sunder::core::Mat3 rotation();

  private:
    std::uint64_t seed_, counter_ = 0;
};

/// Breaks the bond of `cell` through its +axis face.
void breakBond(sunder::core::State&, int cell, int axis);
/// Breaks all bonds of `cell`.
void detach(const sunder::core::World&, sunder::core::State&, int cell);

/// Nodes that differ from a node they are joined to in any bit of displacement or velocity.
int tornNodes(const sunder::core::World&, const sunder::core::State&);

/// The same with numbers that every solver can hold.
sunder::core::State roundedToSingle(sunder::core::State state);
/// By how much a node's displacement or velocity differs at most.
double largestDifference(const std::vector<sunder::core::Vec3>& a,
                         const std::vector<sunder::core::Vec3>& b);
/// kg·m/s, of nodes and objects without regard to direction: what momenta are compared with.
double momentumScale(const sunder::core::World&, const sunder::core::State&);
