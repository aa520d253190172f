#pragma once
#include "core/solver.hpp"
#include "gl/objects.hpp"

namespace sunder::gpu {

/// The part of a world that does not change, on the GPU: every GPU solver and the renderer read it.
class WorldBuffers {
  public:
    explicit WorldBuffers(const World&);

    int cellCount() const { return cellCount_; }
    int nodeCount() const { return kCorners * cellCount_; }

    /// Texture buffer, RGBA32F, one texel per node: rest position (m), mass of this copy (kg; 0 in absent cells).
    const gl::Texture& rest() const { return restTexture_; }
    /// Texture buffer, R32UI, one texel per cell: law | body << SUNDER_LAW_BITS.
    const gl::Texture& cells() const { return cellTexture_; }
    /// Texture buffer, RGBA32F, SUNDER_BODY_TEXELS per body (BodyRecord).
    const gl::Texture& bodies() const { return bodyTexture_; }
    /// Uniform block ElementLaws.
    const gl::Buffer& laws() const { return lawBuffer_; }

  private:
    int cellCount_;
    gl::Buffer restBuffer_, cellBuffer_, bodyBuffer_, lawBuffer_;
    gl::Texture restTexture_, cellTexture_, bodyTexture_;
};

/// What a picture is drawn from, whichever solver made it: texture buffers of NodeRecord and BondRecord.
struct StateView {
    const gl::Texture* nodes;  ///< RGBA32F, 2 texels per node
    const gl::Texture* bonds;  ///< RGBA32F, 2 texels per cell
};

/// A solver whose state lives on the GPU.
class GpuSolver : public Solver {
  public:
    virtual StateView view() const = 0;
};

/// Brings a CPU solver's state to the GPU for drawing.
class StateUpload {
  public:
    explicit StateUpload(const World&);
    StateView upload(const State&);

  private:
    gl::Buffer nodes_, bonds_;
    gl::Texture nodeTexture_, bondTexture_;
};

}  // namespace sunder::gpu
