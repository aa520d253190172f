#pragma once
#include "core/world.hpp"
#include "gpu/pass_timer.hpp"
#include "gpu/texel_target.hpp"

namespace sunder::gpu {

/// Contact between cells (core/contact.hpp) for the gather solver. Every kContactInterval steps a
/// search: centres of the cells, a hashed grid filled by rendering a point per cell with MAX, MIN
/// and additive blending (glsl/contact/grid.glsl; after Harada's grid in GPU Gems 3, chapter 29, in
/// one pass), and up to twenty partners for each cell. Every step, cells that have partners add
/// what pushes them to the forces on their corners. Both cells of a pair work out the same numbers
/// with opposite signs, so momentum is kept to rounding; nothing is blended in an order that
/// matters.
class ContactPass {
  public:
    /// Throws InputError where a body's cells are longer than thick: a voxel would not hold them
    /// all.
    static void check(const World& world);
    /// columns: of the solver's textures.
    ContactPass(const World& world, int columns);

    /// Nodes, links and the world's buffers must be bound. awake: whose partners are looked for;
    /// held: cells that can be touched.
    void search(const TexelRanges& awake, std::span<const TexelRange> held, PassTimer* timer);
    /// Adds to `forces`, a layer per corner. search() must have run since the awake cells changed.
    void push(const TexelTarget& forces, const TexelRanges& awake) const;
    /// Layer 0 says what was found (glsl/contact/search.frag).
    const gl::Texture& partners() const { return partners_.texture(); }

  private:
    void fillGrid(std::span<const TexelRange> held);

    TexelTarget centres_;   ///< per cell: glsl/contact/spheres.glsl
    TexelTarget grid_;      ///< per voxel: glsl/contact/grid.glsl
    TexelTarget partners_;  ///< per cell: glsl/contact/search.frag
    gl::Program centreProgram_, insertProgram_, searchProgram_, pushProgram_;
    gl::VertexArray noAttributes_;
};

}  // namespace sunder::gpu
