#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/event.hpp"
#include "core/object.hpp"
#include "core/types.hpp"

namespace sunder::core {

/// The state a solver advances. Doubles hold every solver's values without loss.
struct State {
    std::int64_t step = 0;
    std::vector<Vec3> displacement;  ///< m, per node, from rest
    std::vector<Vec3> velocity;      ///< m/s, per node
    std::vector<double>
        damage;                ///< per bond; holds below 1, never decreases; kNoBond: no neighbour
    std::vector<double> slow;  ///< Pa, per bond: slow part of its traction
    /// Pa, per cell: slow part of its largest principal stress; 0 unless it breaks by that
    /// (`fracture = "cell"`) and its stiffness is limited.
    std::vector<double> slowStress;
    std::vector<ObjectState> objects;
    /// Events that were given to the solver (Solver::push()) and have not ended.
    std::vector<Event> pushes;
    /// Bodies that are not there (Solver::setPresent()), ascending. Their numbers are those of
    /// World::initialState().
    std::vector<int> absent;
    /// Bodies whose anchors have let go (Solver::releaseAnchors()), ascending.
    std::vector<int> released;

    /// Whether a body is there.
    bool has(int body) const { return !std::binary_search(absent.begin(), absent.end(), body); }
    /// Whether its anchors have let go.
    bool hasReleased(int body) const {
        return std::binary_search(released.begin(), released.end(), body);
    }
};

}  // namespace sunder::core
