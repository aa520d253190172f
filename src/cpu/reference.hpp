#pragma once
#include <array>
#include <memory>
#include <optional>

#include "core/elasticity.hpp"
#include "core/incident_watch.hpp"
#include "core/room.hpp"
#include "core/solver.hpp"
#include "core/traction.hpp"
#include "cpu/objects.hpp"
#include "cpu/reference_contact.hpp"

namespace sunder::cpu {

/// The thesis's CPU version: plain loops in double precision, one step after the other. Slow,
/// obvious, and what every other solver is compared with. Shares no code with the GPU's shaders.
class ReferenceSolver : public core::Solver {
  public:
    explicit ReferenceSolver(const core::World& world);

    std::string_view name() const override { return "reference"; }
    void advance(int steps) override;
    core::State state() const override;
    void setState(const core::State& state) override;
    void archive(core::Archive& archive) override;
    void push(const core::Event& event) override;
    void putObject(int object, const core::ObjectState& state) override;
    void setPresent(int body, bool present) override;
    bool present(int body) const override { return state_.has(body); }
    void releaseAnchors(int body) override;
    bool released(int body) const override { return state_.hasReleased(body); }
    void setIncidents(core::IncidentRing* ring) override;

  private:
    struct Element {
        std::array<int, 4> nodes;
        core::Mat3 inverseRest;  ///< D_m⁻¹, 1/m
        double volume;           ///< m³
        int cell;
        int apex;  ///< corner of the cell, or −1 for the central tetrahedron
    };
    class ObjectCells;

    void updateElements(bool fracture);
    /// Deformation gradients of an element and of its rate.
    struct Deformation {
        core::Mat3 F, rate;
    };
    Deformation deformationOf(const Element&) const;
    /// What hangs together with a node, itself among it.
    struct NodeGroup {
        core::Vec3 force{0, 0, 0};  ///< N
        double mass = 0;            ///< kg
        bool anchored = false;
        int listed = 0;  ///< of its cells, those that may touch something
    };
    NodeGroup groupOf(int node) const;
    std::vector<ReferenceContact::FreeNode> freeNodes() const;
    void pushObjects();
    /// Events of every body at work in this step.
    std::vector<core::Blast> blasts() const;
    /// Adds what an event does in this step to eventAcceleration_.
    void addEvent(const core::Event&);
    void updateNodes();
    void updateFracture();
    void breakCells();
    void damageBonds();
    void updateLinks();
    void lookForIncidents();
    bool overstressed(int cell);
    /// What a bond bears, Pa.
    struct Load {
        double equivalent;  ///< dynamic part scaled by S
        double blow;        ///< dynamic part as it is
    };
    Load loadOf(int cell, int axis, const core::ElementLaw&);

    const core::World& world_;
    std::vector<core::Barrier> barriers_;
    std::vector<Element> elements_;
    std::vector<core::Vec3> eventAcceleration_;  ///< m/s², per node, of the step in progress
    core::State state_;
    std::vector<core::Vec3> force_;                 ///< N, per node, of this copy alone
    std::vector<std::uint8_t> links_;               ///< per node, linkMask()
    std::vector<core::CornerStresses> cellStress_;  ///< valid after updateElements(true)
    std::vector<double> principal_;                 ///< Pa, per cell, likewise
    std::optional<ReferenceContact> contact_;
    std::optional<Objects> objects_;
    std::unique_ptr<core::IncidentWatch> watch_;
    bool searchDue_ = true;  ///< the state was set: pairs are unknown
};

}  // namespace sunder::cpu
