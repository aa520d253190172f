#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/archive.hpp"
#include "core/contact.hpp"
#include "core/incident_watch.hpp"
#include "cpu/cpu_body.hpp"
#include "cpu/cpu_contact_grid.hpp"

namespace sunder::cpu {

/// Calls work(0) .. work(count − 1), in any order and in as many threads as it likes.
using ForEach = std::function<void(int count, const std::function<void(int)>& work)>;

inline float distance2(const std::array<float, 3>& a) {
    return a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
}

inline float dot(const std::array<float, 3>& a, const std::array<float, 3>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Contact between the cells of all bodies (core/contact.hpp).
///
/// A search has two stages. The list of *candidates*, spheres that may come near each other within
/// the next few searches, is renewed only when one of them has used up the way allowed for; each
/// search then picks from it the pairs that the model asks for. What comes out does not depend on
/// how old the candidates are. Lattice neighbours that no joined node holds together are always
/// candidates.
///
/// Every cell works out its side of each of its pairs; both sides run the same operations with the
/// operands ordered by number, so their forces are opposite to the bit.
class Contact {
  public:
    /// `bodies`: all of the world's, in its order; both must outlive it.
    Contact(const core::World& world, std::vector<const BodyArrays*> bodies);

    struct BodyStatus {
        bool held = true, awake = true;
        std::uint32_t relinks = 0;  ///< changes when link masks did
    };
    void search(std::span<const BodyStatus> status, const ForEach& forEach);
    /// Pairs are unknown: the state was set, or bodies came or went.
    void forget() { due_ = true; }
    bool due() const { return due_; }
    /// No body is awake.
    void rest();
    /// The pairs that the last search found, and where their spheres are, which follows from the
    /// bodies' arrays: those are to be what they were. Candidates are found anew. A body that slept
    /// at the last search sleeps still, or another one is due.
    void archive(core::Archive& archive, const std::vector<bool>& held, const ForEach& forEach);

    /// Whether the body has a listed pair.
    bool touching(int body) const { return bodies_[body].touching; }
    /// Whether an awake cell of another body hit this sleeping one, at the last search.
    bool hit(int body) const { return bodies_[body].hit; }

    struct Box {
        std::array<float, 3> low, high;  ///< m
    };
    /// Around all cells of a body that is held, as the last search found it.
    Box boundsOf(int body) const { return {bodies_[body].low, bodies_[body].high}; }

    /// Awake bodies that have pairs, in groups that have none with each other.
    const std::vector<std::vector<int>>& islands() const { return islands_; }
    /// A body's share of the lists that follow() and push() go through.
    struct Range {
        int from = 0, to = 0;
    };
    Range tilesOf(int body) const { return bodies_[body].tiles; }
    Range cellsOf(int body) const { return bodies_[body].cells; }
    /// Of those, what lies in a stretch of the body's vectors.
    Range tilesOf(int body, int first, int end) const;
    Range cellsOf(int body, int first, int end) const;
    /// Once nodes have moved: follow(). Then, while forces of elements are known: push(), which
    /// adds to them. A search leaves nothing to follow.
    void follow(Range tiles);
    void push(Range cells);
    /// Where cells are unequal, to be called for all cells that push each other before push(), once
    /// the forces of elements are known; elsewhere there is nothing to do.
    bool wantsFreeMotions() const { return world_.unequalCells(); }
    void findFreeMotions(Range cells);
    /// Gets to know what is pushed; null: nobody does.
    void setWatch(core::IncidentWatch* watch) { watch_ = watch; }

    std::size_t bytes() const;

  private:
    struct BodyContact {
        const BodyArrays* arrays;
        int first;    ///< number of its first sphere; sphere s of cell c is first + s·stride + c
        int stride;   ///< cells, padded
        int spheres;  ///< of each cell
        float radius, edge;                                       ///< m
        std::array<std::array<float, core::kCorners>, 8> weight;  ///< [sphere][corner]
        bool present = false;                                     ///< all cells are
        BodyStatus status;
        bool settled = false;  ///< asleep, and its spheres known
        bool broken = false;   ///< some lattice neighbours are not joined
        bool relink = true;
        bool self = false;                        ///< its cells may touch each other
        bool near = false;                        ///< may have pairs now
        bool inGrid = false, selfInGrid = false;  ///< when candidates were last searched for
        bool touching = false, hit = false;
        Range tiles, cells;              ///< of tiles_, of active_
        int island = 0;                  ///< a body of the same island, or itself
        std::array<float, 3> low, high;  ///< m, of its spheres with their reach
        float spread = 0;                ///< m, how different its spheres' displacements are
        struct Loose {
            int a, b;
        };
        std::vector<Loose> loose;  ///< lattice neighbours that no joined node holds together
    };
    struct CellLaw {
        float radius, mass, damping, friction, restitution;
    };
    /// Part of a body's tiles, and what its spheres have come to.
    struct Stretch {
        int body, first, end;
        std::array<float, 3> low, high, lowU, highU;
        float reach;
        bool expired;
    };
    /// The same, lane by lane.
    struct Bounds {
        float low[3][kLanes], high[3][kLanes], lowU[3][kLanes], highU[3][kLanes];
        float reach[kLanes];
        float used[kLanes];  ///< m, of the way allowed for; positive: all and more
    };
    /// Place and reach at the last search, for a first look.
    struct Near {
        float x = 0, y = 0, z = 0, reach = 0;
    };
    struct Pair {
        int a, b;  ///< spheres, a < b
        bool neighbours, crowds, hitsA, hitsB;
    };
    struct ActiveCell {
        int body, cell;
    };
    struct ActiveTile {
        int body, tile;
    };

    template <class Entry>
    static Range within(const std::vector<Entry>& entries, Range all, int Entry::*key, int first,
                        int end);
    void layOut(const core::World& world);
    void centreTile(const BodyContact& body, int tile, int sphere);
    /// touchTime() of core/contact.hpp; infinite where the spheres surely do not touch.
    float touchTime(const std::array<float, 3>& x, const std::array<float, 3>& v,
                    float radii) const;
    bool apart(int sphere, int other) const;
    /// How the bodies of two spheres part that overlap from the start; null: they do not.
    const core::Parting* partingOf(int sphere, int other) const;
    void measure(Stretch& stretch);
    void measureTile(const BodyContact& body, int tile, Bounds& bounds);
    void measureBodies(const ForEach& forEach);
    void findLoose(BodyContact& body) const;
    void findNear();
    bool candidatesHold() const;
    void findCandidates(const ForEach& forEach);
    void pickPairs(const ForEach& forEach);
    void pick(int a, int b, bool neighbours, std::vector<Pair>& pairs) const;
    void archivePair(core::Archive& archive, Pair& pair) const;
    void listPairs();
    void listActive();
    void findIslands();
    std::array<float, 3> pairForce(int a, int b, bool neighbours) const;
    /// N, the force of constraint on `a` from `b` for the whole cell (core/contact.hpp).
    std::array<float, 3> stopOf(int a, int b) const;
    /// World-wide number of a sphere's cell.
    int worldCell(int sphere) const {
        return world_.bodies()[bodies_[bodyOf_[sphere]].arrays->index].cellAt(lattice_[sphere]);
    }

    const core::World& world_;
    std::vector<BodyContact> bodies_;
    std::vector<CellLaw> laws_;
    float step_ = 0, closing_ = 0;  ///< s; closing_·speed: the margin that speed asks for
    float searchInterval_ = 0;      ///< s
    float partingTime_ = 0;         ///< s
    float pushSpeed_ = 0;           ///< m/s
    float sweptSpeed_ = 0;          ///< 1/s: faster than that times the radii is fast
    bool due_ = true;
    core::IncidentWatch* watch_ = nullptr;

    // Per sphere.
    std::array<std::vector<float>, 3> rest_, moved_, velocity_;  ///< m, m, m/s
    std::array<std::vector<float>, 3> before_;  ///< displacement when candidates were searched for
    struct FreeMotion {
        std::array<float, 3> acceleration{};  ///< m/s², without contact
        float inverseContact = 0;             ///< 1/kg
    };
    std::vector<std::uint8_t> listed_;  ///< where cells are unequal, at a cell's first sphere
    std::vector<FreeMotion> free_;  ///< where cells are unequal; of listed spheres that are awake
    std::vector<float> allowed_;    ///< m, reach and way allowed for until the next time
    std::vector<int> bodyOf_, cellOf_;  ///< cellOf_: number of the cell's first sphere
    std::vector<std::uint16_t> lawOf_;
    std::vector<std::uint8_t> there_;  ///< its cell is present
    std::vector<Near> near_;
    std::vector<core::IVec3> lattice_;  ///< its cell's coordinates
    std::vector<int> crowd_;            ///< N, at the cell's first sphere

    std::vector<Stretch> stretches_;
    ContactGrid grid_;
    std::vector<ContactGrid::Candidate> candidates_;
    std::vector<std::vector<Pair>> picked_;  ///< by part
    std::vector<int> begin_;                 ///< per sphere: its first entry in partner_
    std::vector<int> partner_;               ///< 2·sphere + (1: lattice neighbours), ascending
    std::vector<ActiveCell> active_;         ///< cells with partners
    std::vector<std::vector<int>> islands_;
    std::vector<ActiveTile> tiles_;  ///< and the tiles that hold some
};

}  // namespace sunder::cpu
