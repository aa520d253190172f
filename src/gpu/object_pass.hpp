#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/world.hpp"
#include "gl/fence.hpp"
#include "gpu/texel_target.hpp"
#include "gpu/world_buffers.hpp"

namespace sunder::gpu {

/// The world's objects (core/object_contact.hpp) for the GPU solvers. Their states are texels, one
/// per object. Every kContactInterval steps a search captures a list of the cells and objects that
/// may touch, by transform feedback from a geometry shader that emits a point for each pair. Every
/// step the list is drawn three times as points: into a texel per object that counts its touches,
/// one that sums up what it gets, and the forces on the cells; blending adds in the order of the
/// list, so a run repeats itself to the bit. Then a fragment per object moves it. Nothing is read
/// back within a frame; where objects are is known to the CPU two looks later.
class ObjectPass {
  public:
    /// Where the solver keeps its nodes, and what drawForces() draws into.
    enum class Layout {
        Textures,  ///< glsl/gather/node.glsl; a texel per cell, a layer per corner
        Buffers,   ///< NodeRecord; a texel per node
    };
    /// columns, rows: of the solver's force texture. `world` and `buffers` must outlive it.
    ObjectPass(const World& world, const WorldBuffers& buffers, Layout layout, int columns,
               int rows);

    void set(const State& state);
    /// Waits for the GPU.
    void read(State& state) const;
    /// For drawing, as they are now: StateView::objects.
    const gl::Texture& places();

    /// Objects that step number `step` begins with are thrown. Returns whether any was.
    bool startStep(std::int64_t step);
    bool searchDue() const { return searchDue_; }
    /// Nodes and the world's buffers must be bound, here and below. cells: that can be touched.
    void search(std::span<const TexelRange> cells);
    /// Works out the impulses on objects.
    void push();
    /// Adds the forces on cells to the bound target.
    void drawForces() const;
    /// Moves the objects to the end of the step.
    void move();

    /// Asks where the objects are and takes the answer of the look before last.
    void look(std::int64_t step);
    /// Whether any object moves, as far as is known.
    bool stirring() const;
    /// Whether one that moves may come to touch the body before the next look.
    bool threatens(int body) const;

  private:
    struct Answer {
        std::int64_t step = -1;  ///< −1: not asked yet
        gl::Buffer texels;
        gl::Fence done;
    };
    static constexpr int kLag = 2;                    ///< looks
    static constexpr std::array kLooked = {0, 2, 3};  ///< layers of ObjectMotion

    gl::Program pairProgram(const char* what, const char* geometry, const char* fragment,
                            int columns, int rows) const;
    gl::Program objectProgram(const char* fragment) const;
    void bind() const;
    void drawPairs(const gl::Program& program) const;
    void drawObjects(const gl::Program& program) const;
    double speedOf(int object) const;
    bool present(int object) const { return known_[object].present; }

    const World& world_;
    const WorldBuffers& buffers_;
    Layout layout_;
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
        moveProgram_;
    bool searchDue_ = true;
    std::array<Answer, kLag> answers_;
    int next_ = 0;
    std::vector<ObjectState> known_;  ///< what the CPU knows of them
    std::int64_t thrown_ = 0;         ///< step of the last throw
};

}  // namespace sunder::gpu
