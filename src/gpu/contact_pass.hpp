#pragma once
#include <cstdint>
#include <optional>

#include "core/archive.hpp"
#include "core/contact.hpp"
#include "core/world.hpp"
#include "gl/timer.hpp"
#include "gpu/pass_timer.hpp"
#include "gpu/texel_target.hpp"

namespace sunder::gpu {

/// How many times as fast as a search can follow, from what glsl/contact/left_out.glsl holds.
double hasteOf(std::int64_t quarterOctaves);
/// The larger of both, body by body.
void raiseHaste(std::vector<double>& haste, const std::vector<double>& by);

/// Contact between cells (core/contact.hpp) for the GPU solvers.
///
/// Every World::contactInterval() steps a search, per sphere. First a look at large voxels,
/// regions, by rendering a point per sphere with MAX blending: what is surrounded by nothing but
/// joined cells of its own body touches nothing and is left out of the rest
/// (glsl/contact/exposed.frag). Then a hashed grid, filled by rendering a point per exposed sphere
/// (glsl/contact/grid.glsl; after Harada's grid in GPU Gems 3, chapter 29, in one pass), and up to
/// 28 partners for each.
///
/// Every step, spheres that have partners are brought up to date, and what pushes them is worked
/// out. Both spheres of a pair work out the same numbers with opposite signs, so momentum is kept
/// to rounding; nothing is blended in an order that matters.
class ContactPass {
  public:
    /// Where the solver keeps nodes and links: glsl/contact/storage.glsl.
    enum class Storage { Textures, Buffers };
    /// columns: of the solver's textures, where it keeps its nodes in any. Throws InputError where
    /// there are too many spheres.
    ContactPass(const core::World& world, int columns, Storage storage);

    /// A cell has so many bits' worth of spheres: as many as any has, rounded up to a power of two.
    static int sphereBits(const core::World& world);

    /// awake: cells whose partners are looked for; held: those that can be touched. As
    /// forget().
    void setCells(std::span<const TexelRange> awake, std::span<const TexelRange> held);
    /// What was found before counts no longer: nodes or links were changed from outside.
    void forget() { due_ = true; }
    /// Before the forces of a step: a search where one is due, otherwise where the spheres are now.
    /// Nodes, links and the world's buffers must be bound.
    void update(std::int64_t step, PassTimer* timer);
    /// Adds what pushes to the forces on the corners of cells, one layer each.
    void push(const TexelTarget& corners);
    /// Works out what pushes each sphere that has partners, for glsl/contact/corner_forces.glsl.
    void push();

    /// What the last search found, and haste, in either direction; waits for the GPU. To be read
    /// once setCells() has been told all, with nodes and the world's buffers bound.
    void archive(core::Archive& archive);

    /// For passes of others with a texel per sphere: a target, a program for one, and running it on
    /// the spheres of awake cells, where any may touch something.
    TexelTarget sphereTarget(const char* what) const;
    gl::Program program(const TexelTarget& target, const char* fragment, gl::Defines defines) const;
    void fillAwake(const TexelTarget& target, const gl::Program& program) const;

    /// What shaders that include glsl/contact/sphere.glsl must be compiled with.
    const gl::Defines& defines() const { return defines_; }
    /// Layer 0, per cell: what the last search found (glsl/contact/search.frag).
    const gl::Texture& summaries() const {
        return summaries_ ? summaries_->texture() : partners_.texture();
    }
    /// Contacts that the last search had no room for. Waits for the GPU; never inside a frame.
    std::int64_t dropped() const;
    /// Layer 0, per cell, x: how much too fast what it met was, in quarter octaves, since
    /// forgetHaste() (glsl/contact/haste.frag).
    const gl::Texture& hastes() const { return hastes_.texture(); }
    void forgetHaste() const;
    /// The same as Solver::contactHaste(). Waits for the GPU.
    std::vector<double> haste() const;

  private:
    static constexpr int kPartnerLayers = 1 + core::kMostPartners / 4;
    int sphereCount() const { return world_.cellCount() << sphereBits_; }
    void search(std::int64_t step, PassTimer* timer);
    void shiftGrid(std::int64_t step);
    void fillRegions();
    void findExposed();
    void findFreeMotions(PassTimer* timer);
    void keepHaste() const;
    void fillGrid();
    void drawHeld(const gl::Program& program) const;
    /// What a sphere has found.
    struct Found {
        int sphere;
        float close, leftOut, touched;  ///< glsl/contact/search.frag
        std::vector<float> partners;
    };
    std::vector<Found> readFound() const;
    void writeFound(const std::vector<Found>& found);
    void archive(core::Archive& archive, Found& found) const;
    /// Where a sphere was at the last search.
    struct Place {
        int sphere;
        vec4 centre, velocity;
    };
    std::vector<Place> readStill(const std::vector<Found>& found) const;
    void writePlaces(const std::vector<Place>& still, bool anyExposed);
    void archiveHaste(core::Archive& archive);
    int archiveSphere(core::Archive& archive, int now) const;

    const core::World& world_;
    int columns_;     ///< of what has a texel per cell
    int sphereBits_;  ///< as many spheres to a cell as any has, rounded up to a power of two
    gl::Defines defines_;
    TexelTarget spheres_;                      ///< glsl/contact/sphere.glsl
    TexelTarget regions_;                      ///< glsl/contact/region.glsl
    TexelTarget exposed_;                      ///< per sphere: glsl/contact/exposed.frag
    TexelTarget grid_;                         ///< glsl/contact/grid.glsl
    TexelTarget partners_;                     ///< per sphere: glsl/contact/search.frag
    std::optional<TexelTarget> summaries_;     ///< per cell, where cells have several spheres
    std::optional<TexelTarget> free_;          ///< glsl/contact/free.frag, where cells are unequal
    TexelTarget hastes_;                       ///< per cell: glsl/contact/haste.frag
    std::optional<TexelTarget> sphereForces_;  ///< unless push() writes to corners at once
    gl::Program sphereProgram_, listedProgram_, regionProgram_, exposedProgram_, gridProgram_,
        searchProgram_, freeProgram_, summaryProgram_, hasteProgram_, pushProgram_, cornerProgram_;
    gl::VertexArray noAttributes_;
    gl::Query anyExposed_;  ///< at the last search; where none is, the rest is left out

    TexelRanges awakeSpheres_, heldSpheres_, awakeCells_;
    std::vector<TexelRange> held_;  ///< spheres
    bool due_ = true;
};

}  // namespace sunder::gpu
