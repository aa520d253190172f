#pragma once
#include <array>
#include <initializer_list>
#include <optional>

#include "core/body_book.hpp"
#include "core/body_host.hpp"
#include "gpu/block_pass.hpp"
#include "gpu/cell_pass.hpp"
#include "gpu/contact_pass.hpp"
#include "gpu/event_buffer.hpp"
#include "gpu/feedback.hpp"
#include "gpu/incident_pass.hpp"
#include "gpu/object_pass.hpp"
#include "gpu/released_bodies.hpp"
#include "gpu/rest_monitor.hpp"
#include "gpu/texel_target.hpp"

namespace sunder::gpu {

/// The fast GPU method: every pass fills float textures, ping-pong. One fragment per cell computes
/// its five tetrahedra and writes the forces on its eight nodes; two more gather for four nodes
/// each the forces of the joined copies and write the new state. No geometry shader, no blending,
/// the same result on every run of one driver. Stresses, bonds and links run only on the steps that
/// need them; nothing is read back while it advances. Bodies at rest sleep (core/sleep.hpp): the
/// passes leave their texels out.
///
/// Fragments rather than vertices with transform feedback: on an NVIDIA H200 feedback writes some
/// four thousand million floats a second and no more, which is what a step then takes.
///
/// Needs a current GL context for as long as it lives.
class GatherSolver : public GpuSolver, public core::BodyHost {
  public:
    /// Throws InputError when the world is too large for the device. `world` and `buffers` must
    /// outlive it.
    GatherSolver(const core::World& world, const WorldBuffers& buffers)
        : GatherSolver(world, buffers, Stage::Fragment) {}

    std::string_view name() const override {
        return stage_ == Stage::Fragment ? "gather" : "compute";
    }
    void advance(int steps) override;
    void finish() override;
    core::State state() const override;
    std::unique_ptr<core::StateCopy> makeStateCopy() const override;
    void setState(const core::State& state) override;
    void archive(core::Archive& archive) override;
    void push(const core::Event& event) override;
    void putObject(int object, const core::ObjectState& state) override;
    void setPresent(int body, bool present) override;
    bool present(int body) const override { return book_.present(body); }
    void releaseAnchors(int body) override;
    bool released(int body) const override { return book_.released(body); }
    bool asleep(int body) const override { return book_.asleep(body); }
    bool objectAsleep(int object) const override { return book_.objectAsleep(object); }
    StateView view() override;
    void setIncidents(core::IncidentRing* ring) override;

    std::int64_t droppedContacts() const override { return droppedContacts_; }
    std::vector<double> contactHaste() const override { return contactHaste_; }

    void adopt(const std::vector<int>& bodies, const core::State& state) override;
    void release(const std::vector<int>& bodies, core::State& state) override;
    bool holds(int body) const override { return book_.holds(body); }
    /// Where a body that another solver holds is to be drawn.
    void show(int body, const core::State& state);
    void showObjects(const core::State& state);

  protected:
    /// Throws InputError where the context has not what the stage needs.
    GatherSolver(const core::World& world, const WorldBuffers& buffers, Stage stage);

  private:
    /// A texture buffer that layers are copied to, one after the other, for drawing.
    struct Copy {
        gl::Buffer buffer;
        gl::Texture texture;
        void update(const TexelTarget& from, std::initializer_list<int> layers, const char* what);
    };

    static constexpr int kNodeParts = 2;  ///< a fragment writes four nodes of its cell
    /// The passes for either half of a cell's nodes; an invocation has one node, and so the first
    /// has all of them.
    struct NodePass {
        std::array<CellPass, kNodeParts> parts;
        std::array<GLint, kNodeParts> newWatch, stepInFrame;
    };

    NodePass nodePass(const char* events) const;
    int nodeParts() const { return stage_ == Stage::Fragment ? kNodeParts : 1; }
    void bindInputs() const;
    void bindState() const;
    void write(TexelRange cells, const core::State& state);
    void read(TexelRange cells, core::State& state) const;
    /// What a state has beside the numbers of cells and objects.
    core::State outline() const;
    class LateState;
    /// nodes(layer), bonds(layer): texels of a layer, from the first of `cells` on.
    template <class NodeLayer, class BondLayer>
    void readLayers(TexelRange cells, core::State& state, const NodeLayer& nodes,
                    const BondLayer& bonds) const;
    void archiveCells(core::Archive& archive);
    void archiveLooks(core::Archive& archive);
    /// The book says other things of bodies as wholes.
    void bookChanged();
    void relink(int body);
    /// The links of cells follow from their bonds, wherever they may be read from.
    void writeLinks(const CellSet& cells);
    /// Wakes a body that comes or goes, and what sleeps where these boxes of it are.
    void wakeAround(int body, const std::vector<core::RestBox>& own);
    /// Both halves of the ping-pong: what no pass touches is to be the same in both.
    void writeBoth(TexelRange cells, const core::State& state);
    /// Everything that follows from the state and from who sleeps.
    void follow();
    void watch();
    /// Lets islands fall asleep all of which have been calm for long enough.
    void rest();
    void fallAsleep(const std::vector<int>& bodies);
    void startThrows();
    void wakePushed();
    /// Which bodies an event of every body may reach in the step to come.
    std::vector<bool> blasted() const;
    /// Whether a blast pushes an object within steps from .. to − 1, as far as it stays where it
    /// was known to be.
    bool blastedWithin(int object, std::int64_t from, std::int64_t to) const;
    void findNextWake(std::int64_t from);
    void wakeThreatened();
    /// Wakes a body or an object and what sleeps with it (core/rest_islands.hpp).
    void wake(int member) { woke(book_.wake(member)); }
    void woke(const core::BodyBook::Members& members);
    /// As of the last look; empty where the world has no objects.
    const std::vector<core::ObjectState>& knownObjects() const;
    /// A body's state is another one.
    void changed(int body);
    int bodyCount() const { return static_cast<int>(world_.bodies().size()); }
    int objectCount() const { return static_cast<int>(world_.objects().size()); }
    void bodiesChanged();
    void addContacts();
    void addObjects(bool events, int stepInFrame);
    /// At least one step, at most so many; how many it was.
    int advanceSome(bool events, int stepInFrame, int most);
    void advanceOne(bool events, int stepInFrame);
    /// Several steps in one pass.
    int advanceBlocks(bool events, int stepInFrame, int most);
    void lookForIncidents();
    /// Whether anything changes in a step: bodies that are awake, objects that move.
    bool moving() const;
    void updateBonds();
    void updateLinks();
    void updateNodes(bool events, int stepInFrame);

    const core::World& world_;
    const WorldBuffers& buffers_;
    Stage stage_;
    std::int64_t step_ = 0;
    bool breakable_;
    int columns_;  ///< of all textures
    EventBuffer events_;
    // One texel per cell in all of them.
    std::array<TexelTarget, 2> nodes_;         ///< glsl/gather/node.glsl
    std::array<TexelTarget, 2> bonds_;         ///< BondRecord
    TexelTarget forces_;                       ///< on each corner
    std::vector<TexelTarget> links_;           ///< LinkRecord; two only where blocks_ writes them
    int currentNodes_ = 0, currentBonds_ = 0;  ///< read; the other is written
    int currentLinks_ = 0;
    Copy drawnNodes_, drawnDamage_;
    CellPass forcePass_, stressPass_, bondPass_, linkPass_;
    NodePass plainNodes_, pushedNodes_;
    gl::Program stillBondProgram_;
    std::array<gl::Program, kNodeParts> stillNodePrograms_;
    GLint bondWatchUniform_ = -1;

    core::BodyBook book_;
    ReleasedBodies released_;
    CellSet awake_;
    std::optional<BlockPass> blocks_;
    std::optional<ContactPass> contact_;
    std::optional<ObjectPass> objects_;
    std::int64_t droppedContacts_ = 0;
    std::vector<double> contactHaste_;
    std::optional<IncidentPass> incidents_;
    bool stirred_ = false;  ///< something has moved since the last look for incidents
    RestMonitor monitor_;
    bool newNodeWatch_ = true, newBondWatch_ = true;  ///< no step, no update since the last look
    std::int64_t nextWake_ = 0;  ///< no event acts on what sleeps before this step
};

/// The same with compute shaders for all that is done per cell and node: on GPUs whose rasterisers
/// are the lesser part, several times as fast. Contact, objects and what looks for rest are drawn.
class ComputeSolver : public GatherSolver {
  public:
    /// Throws InputError, naming `gather`, where the context is older than GL 4.3.
    ComputeSolver(const core::World& world, const WorldBuffers& buffers)
        : GatherSolver(world, buffers, Stage::Compute) {}
};

}  // namespace sunder::gpu
