#pragma once
#include "gpu/texel_target.hpp"

namespace sunder::gpu {

/// What runs a pass over cells: rasterisation, which GL 4.1 has, or compute shaders, for which it
/// takes GL 4.3. Both come from one source and have one result but for rounding.
enum class Stage { Fragment, Compute };

/// The cells that passes work on, on the GPU: as rectangles of texels for fragments, and for
/// compute shaders in groups of at most SUNDER_CELL_GROUP that follow each other.
class CellSet {
  public:
    /// For at most `most` ranges of texels.
    CellSet(Stage stage, std::size_t most, const char* what);
    /// Ranges must not overlap. columns: of the textures.
    void set(std::span<const TexelRange> ranges, int columns);
    bool empty() const { return rectangles_.rectangles() == 0; }
    const TexelRanges& rectangles() const { return rectangles_; }
    int groups() const { return groups_; }
    /// Texture buffer, RG32I: first cell and number of cells of each group.
    const gl::Texture& groupTexture() const { return groupTexture_; }

  private:
    Stage stage_;
    TexelRanges rectangles_;
    int groups_ = 0;
    gl::Buffer groupBuffer_;
    gl::Texture groupTexture_;
};

/// A pass over cells: a fragment or an invocation for each, or several invocations.
class CellPass {
  public:
    CellPass() = default;
    /// file: under glsl/, with `#ifdef COMPUTE` where the stages differ (gather/cell_texel.glsl).
    /// `target`: what it fills, or one of its size. invocations: to a cell, by compute shaders.
    CellPass(Stage stage, const TexelTarget& target, const core::World& world, const char* file,
             gl::Defines defines = {}, int invocations = 1);
    const gl::Program& program() const { return program_; }
    explicit operator bool() const { return static_cast<bool>(program_); }
    /// Fills the texels of these cells. part: of a target with more than eight layers, which a
    /// compute shader fills all at once.
    void run(const TexelTarget& to, const CellSet& cells, int part = 0) const;

  private:
    Stage stage_ = Stage::Fragment;
    int invocations_ = 1;
    gl::Program program_;
};

/// After a dispatch, for passes that fetch, blend and copy the images it wrote, and for those that
/// write them again.
void finishImages();

/// Throws InputError, naming `gather`, where the current context cannot do it.
void requireCompute();

}  // namespace sunder::gpu
