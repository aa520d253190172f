#pragma once
#include <span>
#include <vector>

#include "core/world.hpp"
#include "gl/program.hpp"
#include "gpu/layout.hpp"
#include "gpu/texel_ranges.hpp"

namespace sunder::gpu {

/// Columns for a texture of `count` texels, up to four times as high as wide: rasterisers work on
/// square blocks, and a software one wastes most of them on a texture of one long row.
int texelColumns(std::int64_t count);

/// Rows that `count` texels take in a texture of `columns`. Throws InputError, naming `what`, where
/// the device's textures are not that large.
int texelRows(std::int64_t count, int columns, const char* what);

/// Records of vec4s, one record per texel, one layer per vec4: what fragments write and later
/// passes read. A program fills up to eight layers at once; more layers are more parts.
class TexelTarget {
  public:
    TexelTarget(int count, int columns, int layers, const char* what);

    /// GL_TEXTURE_2D_ARRAY, RGBA32F.
    const gl::Texture& texture() const { return texture_; }
    /// A program that fill() can run on this target or one of its size, every texel a cell of the
    /// world or whatever the fragment shader takes it for; its constants are set (feedback.hpp).
    gl::Program program(const core::World& world, const char* fragment,
                        gl::Defines defines = {}) const;
    /// Runs a program made by program(): a fragment for every texel in
    /// `ranges`. Its outputs are layers 8·part, 8·part + 1, … .
    void fill(const gl::Program& program, const TexelRanges& ranges, int part = 0) const;

    /// Draws go to the layers of a part, whatever program makes them.
    void bind(int part = 0) const;

    /// Replaces texels from number `first` on.
    void write(int layer, int first, std::span<const vec4> texels);
    /// Waits for the GPU.
    std::vector<vec4> read(int layer, TexelRange range) const;
    /// Copies a layer within the GPU into a buffer, from byte number `offset` on.
    void copy(int layer, const gl::Buffer& buffer, std::size_t offset = 0) const;
    std::size_t layerBytes() const { return sizeof(vec4) * layerTexels(); }
    std::size_t layerTexels() const;
    int columns() const { return columns_; }
    int rows() const { return rows_; }

  private:
    /// Reads will come from that layer.
    void bindForReading(int layer) const;

    int columns_, rows_;
    gl::Texture texture_;
    std::vector<gl::Framebuffer> framebuffers_;  ///< one per part
    gl::VertexArray noAttributes_;
};

}  // namespace sunder::gpu
