#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/world.hpp"

namespace sunder::core {

/// Something that happened: for sound, particles, game logic.
///
/// A *break* is a bond that gave way. Its impulse is what passed through the bond in the fracture
/// interval in which it did, as if it bore all that it can: its strength times its area times the
/// interval.
///
/// A *contact* is a cell that other cells or objects hit. Its impulse is all that they pushed it
/// with, one beside the other (squeezed from two sides counts twice), less what a lasting load
/// pushed with anyway (blow()); of a body that wakes or changes its solver the load counts once.
/// Cells that get less than kBlowSpeed times their mass are left out. What the floor and the room's
/// walls push with does not count.
struct Incident {
    enum class Kind : std::uint8_t { Contact, Break };
    Kind kind = Kind::Contact;
    std::int64_t step = 0;  ///< of the look that found it: it happened in the stepsPerLook() before
    Vec3 place{0, 0, 0};    ///< m, at that step: centre of the cell, of a break the bond's face
    double impulse = 0;     ///< N·s
    int cell = -1;          ///< of a break the one that owns the bond
    int other = -1;         ///< cell: the bond's other one; of a contact what pushed hardest
    int object = -1;        ///< of a contact, instead of `other`, where an object pushed hardest
};

inline constexpr double kBlowSpeed = 0.25;  ///< m/s

/// Steps from one look for incidents to the next, about 1/60 s.
int stepsPerLook(const World& world);
/// The incident of a bond that broke, but for its place.
Incident breakOf(const World& world, int bond, std::int64_t step);
/// N·s: what is new of an impulse `now`, where the two looks before found `before` and `earlier`.
/// A blow that two looks share counts once, a load that lasts not at all.
double blow(double now, double before, double earlier);
/// Names of the materials of the incident's cells.
std::vector<std::string> materialsOf(const World& world, const Incident& incident);

/// Incidents on their way from a solver to whoever reads them: the newest `capacity`. What is
/// overwritten before it was read counts as dropped.
class IncidentRing {
  public:
    explicit IncidentRing(std::size_t capacity = 4096);

    void push(const Incident& incident);
    /// So many were lost before they came here.
    void drop(std::int64_t count) { dropped_ += count; }

    /// What has come since the last time, oldest first.
    std::vector<Incident> take();
    std::size_t capacity() const { return slots_.size(); }
    std::int64_t dropped() const { return dropped_; }

  private:
    std::vector<Incident> slots_;
    std::int64_t pushed_ = 0, taken_ = 0, dropped_ = 0;
};

}  // namespace sunder::core
