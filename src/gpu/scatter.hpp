#pragma once
#include <array>
#include <optional>

#include "core/body_book.hpp"
#include "gpu/bond_pass.hpp"
#include "gpu/contact_pass.hpp"
#include "gpu/event_buffer.hpp"
#include "gpu/feedback.hpp"
#include "gpu/incident_pass.hpp"
#include "gpu/object_pass.hpp"
#include "gpu/released_bodies.hpp"

namespace sunder::gpu {

/// The thesis's GPU method, figure by figure: points scatter nodal forces and stresses into float
/// textures by additive blending (6.4, 7.2), a connectivity pass adds up joined nodes (7.4), node
/// (6.5) and fracture (7.3) updates feed back through transform feedback with ping-pong buffers.
/// Contact is scattered by points, too: one per cell, for its nodes. Nothing is read back while it
/// advances.
///
/// Needs a current GL context for as long as it lives.
class ScatterSolver : public GpuSolver {
  public:
    /// Throws InputError when the world is too large for the device. `world` and `buffers` must
    /// outlive it.
    ScatterSolver(const core::World& world, const WorldBuffers& buffers);

    std::string_view name() const override { return "scatter"; }
    void advance(int steps) override;
    void finish() override;
    core::State state() const override;
    std::unique_ptr<core::StateCopy> makeStateCopy() const override;
    void setState(const core::State& state) override;
    void archive(core::Archive& archive) override;
    void push(const core::Event& event) override;
    void putObject(int object, const core::ObjectState& state) override;
    /// Waits for the GPU: the state goes through the CPU.
    void setPresent(int body, bool present) override;
    bool present(int body) const override { return book_.present(body); }
    void releaseAnchors(int body) override;
    bool released(int body) const override { return book_.released(body); }
    StateView view() override;
    void setIncidents(core::IncidentRing* ring) override;
    /// In the searches that finish() came upon.
    std::int64_t droppedContacts() const override { return droppedContacts_; }
    std::vector<double> contactHaste() const override { return contactHaste_; }

  private:
    /// [current] is read, [1 − current] written.
    struct NodeSide {
        NodeBuffer nodes;
        gl::VertexArray attributes;
    };

    /// What a state has beside the numbers of cells and objects.
    core::State outline() const;
    class LateState;
    void makeElementBuffer();
    void makeTargets();
    void makePrograms();
    /// What a state says of bodies as wholes: those that are not there touch nothing, and their
    /// nodes are as if they were anchored.
    void follow(const core::State& state);
    void writeInverseMasses();
    void bindBodies() const;
    void drawForces(const gl::Program& program, const gl::VertexArray& attributes, int count);
    void updateElements(bool fracture);
    void addContacts();
    void addObjects(bool events, int stepInFrame);
    void lookForIncidents();
    void updateConnectivity();
    void updateNodes(int stepInFrame);

    const core::World& world_;
    const WorldBuffers& buffers_;
    std::int64_t step_ = 0;
    core::BodyBook book_;  ///< all of them are held, and none sleeps
    ReleasedBodies released_;
    int width_, height_;  ///< columns and rows of the float textures

    bool breakable_;
    Feedback feedback_;
    BondPass bonds_;
    EventBuffer events_;
    std::array<NodeSide, 2> nodes_;
    int currentNodes_ = 0;
    gl::Buffer elementBuffer_;
    gl::VertexArray elementAttributes_, noAttributes_;

    gl::Texture forceTexture_, stressTexture_, cumulativeTexture_;
    gl::Framebuffer elementTarget_, cumulativeTarget_;
    std::array<gl::Program, 2> elementPrograms_;  ///< [1] also computes stresses
    gl::Program connectivityProgram_, nodeProgram_;
    GLint stepInFrameUniform_ = -1;
    std::optional<ContactPass> contact_;
    gl::Program contactProgram_;
    std::optional<ObjectPass> objects_;
    std::optional<IncidentPass> incidents_;
    std::int64_t droppedContacts_ = 0;
    std::vector<double> contactHaste_;
};

}  // namespace sunder::gpu
