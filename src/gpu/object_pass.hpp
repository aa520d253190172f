#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/archive.hpp"
#include "core/rest_islands.hpp"
#include "core/sleep.hpp"
#include "core/world.hpp"
#include "gl/fence.hpp"
#include "gpu/contact_pass.hpp"
#include "gpu/texel_target.hpp"
#include "gpu/world_buffers.hpp"

namespace sunder::gpu {

/// The world's objects (core/object_contact.hpp) for the GPU solvers. Their states are texels, one
/// per object. Every World::contactInterval() steps a search captures a list of the cells and
/// objects that may touch, by transform feedback from a geometry shader that emits a point for each
/// pair. Every step the list is drawn three times as points: into a texel per object that counts
/// its touches, one that sums up what it gets, and the forces on the cells; blending adds in the
/// order of the list, so a run repeats itself to the bit. Then a fragment per object moves it.
/// Nothing is read back within a frame; where objects are and how calm is known to the CPU two
/// looks later.
class ObjectPass {
  public:
    /// Where the solver keeps its nodes: glsl/contact/storage.glsl. Forces are drawn into a texel
    /// per cell and a layer per corner (Textures) or a texel per node (Buffers); columns, rows: of
    /// those texels. `world` and `buffers` must outlive it.
    ObjectPass(const core::World& world, const WorldBuffers& buffers, ContactPass::Storage storage,
               int columns, int rows);

    void set(const core::State& state);
    /// Waits for the GPU.
    void read(core::State& state) const;
    /// Copies what read() reads within the GPU; `to` may be empty.
    void copy(gl::Buffer& to) const;
    /// What was copied there, once that is done.
    void read(const gl::Buffer& from, core::State& state) const;
    /// All of it, in either direction; waits for the GPU. asleep: which objects are to be, once all
    /// is read.
    void archive(core::Archive& archive, const std::function<bool(int object)>& asleep);
    /// For drawing, as they are now: StateView::objects.
    const gl::Texture& places();

    /// Puts an object somewhere as step number `step` begins; it is awake.
    void put(int object, const core::ObjectState& state, std::int64_t step);
    /// cells: those that can be touched, from the next search on.
    void setCells(std::span<const TexelRange> cells);
    /// Gives objects what the events of every body at work in a step of this frame add to their
    /// motion, before push(). The events must be bound.
    void accelerate(int stepInFrame);
    /// Finds what may touch, where that is due, and works out the impulses on objects. Nodes, links
    /// and the world's buffers must be bound.
    void push(std::int64_t step);
    /// Adds the forces on cells to the bound target.
    void drawForces() const;
    /// Instead of the forces how hard cells are pushed and by what, into a texel per sphere: the
    /// program, and a point for each pair with it; how they blend is the caller's affair.
    gl::Program impulseProgram(const TexelTarget& target) const;
    void drawPairs(const gl::Program& program) const;
    /// Moves the objects to the end of the step.
    void move();

    /// Asks where the objects are and what they did in the `steps` steps before `step`, and takes
    /// the answer of the look before last.
    void look(std::int64_t step, int steps);
    /// As far as is known.
    const std::vector<core::ObjectState>& known() const { return known_; }
    core::RestIslands::Status restStatus(int object) const;
    bool asleep(int object) const { return asleep_[object]; }
    void setAsleep(const std::vector<int>& objects, bool asleep, std::int64_t step);
    /// An object that is awake is pushed: what it did before `step` no longer counts as calm.
    void disturb(int object, std::int64_t step) { rests_[object] = {0, step}; }
    /// Finds out by how much blasts may have made objects faster since they were last known, and
    /// may until the next look, which is what threatens() and the like ask for.
    void expect(const core::EventSchedule& events, std::int64_t step);
    /// Whether any object moves, or may begin to.
    bool anyAwake() const;
    /// Whether one that moves may come to touch the body, or the object that sleeps, before the
    /// next look.
    bool threatens(int body) const;
    bool threatensObject(int object) const;
    /// Whether cells in the box, none faster than `speed` m/s, may.
    bool threatenedBy(int object, const core::RestBox& box, double speed) const;

  private:
    struct Answer {
        std::int64_t step = -1;  ///< −1: not asked yet
        gl::Buffer texels;
        gl::Fence done;
    };
    static constexpr int kLag = 2;  ///< looks
    struct Rest {
        int calmSteps = 0;
        std::int64_t disturbed = 0;  ///< step
    };

    gl::Program pairProgram(const char* what, const char* geometry, const char* fragment,
                            int columns, int rows) const;
    gl::Program objectProgram(const char* fragment) const;
    void bind() const;
    void search();
    void drawObjects(const gl::Program& program) const;
    void take(const std::vector<vec4>& texels, std::int64_t since, int steps);
    double speedOf(int object) const;
    /// It is there, moves, and is awake.
    bool stirs(int object) const;
    /// m, how far it may come before the next look.
    double reachOf(int object) const;
    void writeSleepers();
    using Pair = std::array<GLint, 4>;  ///< glsl/objects/search.geom
    static constexpr std::size_t kPairBytes = sizeof(Pair);
    /// Of the bound vertex array.
    static void pairAttribute(const gl::Buffer& pairs);
    using Motion = std::vector<vec4>;  ///< layer by layer
    void archive(core::Archive& archive, Motion& motion) const;
    void archive(core::Archive& archive, Answer& answer);
    void archive(core::Archive& archive, Pair& pair) const;
    std::vector<Pair> readPairs() const;
    void writePairs(const std::vector<Pair>& pairs);

    const core::World& world_;
    const WorldBuffers& buffers_;
    ContactPass::Storage storage_;
    int columns_, count_;
    std::array<TexelTarget, 2> motion_;  ///< ObjectMotion
    int current_ = 0;
    TexelTarget touches_;   ///< K
    TexelTarget impulses_;  ///< linear, angular
    ObjectPlaces places_;
    gl::Buffer list_;  ///< pairs: glsl/objects/search.geom
    gl::TransformFeedback capture_;
    gl::VertexArray pairs_, noAttributes_;
    gl::Program searchProgram_, countProgram_, reactionProgram_, forceProgram_, amongProgram_,
        accelerateProgram_, moveProgram_, listedProgram_;
    std::vector<TexelRange> cells_;
    bool searchDue_ = true;
    std::array<Answer, kLag> answers_;
    int next_ = 0;
    std::vector<core::ObjectState> known_;  ///< what the CPU knows of them
    std::int64_t changed_ = 0;              ///< step at which one was put somewhere
    std::vector<Rest> rests_;
    std::vector<bool> asleep_;
    std::vector<double> gains_;  ///< m/s: expect()
    gl::Buffer sleepers_;        ///< a float per object
    gl::Texture sleepersTexture_;
    GLint newWatchUniform_ = -1, stepInFrameUniform_ = -1;
    bool newWatch_ = true;
    int sleepSteps_;
};

}  // namespace sunder::gpu
