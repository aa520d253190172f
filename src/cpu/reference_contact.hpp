#pragma once
#include "core/contact.hpp"
#include "core/incident_watch.hpp"

namespace sunder::cpu {

/// Contact between cells (core/contact.hpp) for the reference solver: a list of the pairs of
/// spheres that may touch, renewed by search(), and their forces.
class ReferenceContact {
  public:
    explicit ReferenceContact(const core::World& world);

    /// `links`: linkMask() per node, as the bonds of `state` are.
    void search(const core::State& state, const std::vector<std::uint8_t>& links);
    /// What the last search found.
    void archive(core::Archive& archive);
    /// What a node would do; an anchored one does nothing.
    struct FreeNode {
        core::Vec3 acceleration{0, 0, 0};  ///< m/s², without contact
        double inverseContact = 0;         ///< 1/kg: C of core/contact.hpp, its part of it
    };
    /// Whether a cell may touch something by the last search.
    const std::vector<bool>& listed() const { return listed_; }
    /// Adds the forces of the listed pairs to the nodes' (N). free: per node, or empty where cells
    /// are not unequal. watch: may be null.
    void addForces(const core::State& state, const std::vector<FreeNode>& free,
                   std::vector<core::Vec3>& force, core::IncidentWatch* watch) const;

  private:
    struct Sphere {
        int cell, number;
        core::Vec3 centre, moved, velocity;
        double reach;  ///< m: radius plus what it may add to a margin
    };
    struct Pair {
        int cellA, sphereA, cellB, sphereB;  ///< cellA < cellB
        bool neighbours;                     ///< on one body's lattice
        auto operator<=>(const Pair&) const = default;
    };

    Sphere sphere(const core::State& state, int cell, int number) const;
    bool neighbours(int cellA, int cellB) const;
    bool joined(int cellA, int cellB, const std::vector<std::uint8_t>& links) const;
    struct FreeSphere {
        core::Vec3 acceleration{0, 0, 0};
        double inverseContact = 0;
    };
    FreeSphere freeSphere(int cell, int number, const std::vector<FreeNode>& free) const;
    /// Force on A.
    core::Vec3 pairForce(const Pair& pair, const core::State& state,
                         const std::vector<FreeNode>& free) const;
    void addToCorners(int cell, int number, const core::Vec3& force,
                      std::vector<core::Vec3>& nodes) const;
    const core::ContactProxy& proxyOf(int cell) const { return proxies_[world_.bodyOf(cell)]; }
    double restitution(int cellA, int cellB) const {
        const auto of = [&](int cell) { return world_.laws()[world_.lawOf(cell)].restitution; };
        return 0.5 * (of(cellA) + of(cellB));
    }
    double dampingOf(int cell) const { return world_.laws()[world_.lawOf(cell)].contactDamping; }

    void listCells();

    const core::World& world_;
    std::vector<core::ContactProxy> proxies_;                               ///< per body
    std::vector<std::vector<std::array<double, core::kCorners>>> weights_;  ///< per body and sphere
    std::vector<Pair> pairs_;                                               ///< sorted
    std::vector<bool> listed_;                                              ///< per cell
    std::vector<int> crowd_;                                                ///< N, per cell
};

}  // namespace sunder::cpu
