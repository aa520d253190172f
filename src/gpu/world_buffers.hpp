#pragma once
#include "core/solver.hpp"
#include "gl/objects.hpp"
#include "gl/shader_assembly.hpp"
#include "gpu/pass_timer.hpp"

namespace sunder::gpu {

/// Defines for a shader that asks for a body's axes: with TURNED where any body has others than the
/// world's.
gl::Defines withTurned(gl::Defines defines, bool turned);

/// The part of a world that does not change, on the GPU: every GPU solver and the renderer read it.
class WorldBuffers {
  public:
    explicit WorldBuffers(const core::World&);

    int cellCount() const { return cellCount_; }
    int nodeCount() const { return core::kCorners * cellCount_; }

    /// Texture buffer, RGBA32F, one texel per node: rest position (m); mass of this copy (kg),
    /// negative where the node is anchored, 0 in absent cells.
    const gl::Texture& rest() const { return restTexture_; }
    /// Texture buffer, RGBA32UI, one texel per cell: its record (glsl/shared/layout.h).
    const gl::Texture& cells() const { return cellTexture_; }
    /// Texture buffer, RGBA32F, SUNDER_BODY_TEXELS per body (BodyRecord).
    const gl::Texture& bodies() const { return bodyTexture_; }
    /// Texture buffer, RGBA32F, one texel per cell: strengths of the bonds it owns (Pa);
    /// friction.
    const gl::Texture& strengths() const { return strengthTexture_; }
    /// Texture buffer, RGBA32F, SUNDER_OBJECT_TEXELS per object (ObjectRecord).
    const gl::Texture& objects() const { return objectTexture_; }
    int objectCount() const { return objectCount_; }
    /// Texture buffer, RGBA32F, SUNDER_PARTING_TEXELS per pair of bodies (PartingRecord).
    const gl::Texture& partings() const { return partingTexture_; }
    /// Uniform block ElementLaws.
    const gl::Buffer& laws() const { return lawBuffer_; }
    /// Whether any body's own axes are not the world's.
    bool turned() const { return turned_; }

  private:
    int cellCount_, objectCount_;
    bool turned_;
    gl::Buffer restBuffer_, cellBuffer_, bodyBuffer_, strengthBuffer_, objectBuffer_, lawBuffer_,
        partingBuffer_;
    gl::Texture restTexture_, cellTexture_, bodyTexture_, strengthTexture_, objectTexture_,
        partingTexture_;
};

/// Displacements and velocities on the GPU (NodeRecord): what transform feedback writes and
/// everything else reads.
class NodeBuffer {
  public:
    explicit NodeBuffer(const core::World&);  ///< contents undefined
    const gl::Buffer& buffer() const { return buffer_; }
    /// RGBA32F, 2 texels per node.
    const gl::Texture& texture() const { return texture_; }
    void write(const core::State&);
    void read(core::State&) const;                                     ///< waits for the GPU
    void copy(const NodeBuffer& from) { buffer_.copy(from.buffer_); }  ///< within the GPU

  private:
    std::vector<float> restHeights_;  ///< m, per node; they travel with every record
    gl::Buffer buffer_;
    gl::Texture texture_;
};

/// Damage and slow traction of the bonds that each cell owns (BondRecord).
class BondBuffer {
  public:
    /// Contents undefined. The world must outlive it.
    explicit BondBuffer(const core::World&);
    const gl::Buffer& buffer() const { return buffer_; }
    /// RGBA32F, 2 texels per cell.
    const gl::Texture& texture() const { return texture_; }
    void write(const core::State&);
    void read(core::State&) const;                                     ///< waits for the GPU
    void copy(const BondBuffer& from) { buffer_.copy(from.buffer_); }  ///< within the GPU

  private:
    const core::World& world_;
    gl::Buffer buffer_;
    gl::Texture texture_;
};

/// What a picture is drawn from, whichever solver made it.
struct StateView {
    const gl::Texture* displacements;  ///< texture buffer, RGBA32F; xyz: m from rest
    int cellStride, cornerStride;      ///< texels from one cell's to the next, one corner's
    const gl::Texture* damage;         ///< texture buffer, RGBA32F; as BondRecord::damage
    int damageStride;                  ///< texels from one cell's to the next
    /// Texture buffer, RGBA32F: for every object its position (m; w: 1, or 0: not there), then for
    /// every object its orientation (quaternion). Null where the world has none.
    const gl::Texture* objects = nullptr;
};

/// Where objects are, for drawing: StateView::objects.
class ObjectPlaces {
  public:
    explicit ObjectPlaces(const core::World&);  ///< contents undefined
    /// Null where the world has no objects.
    const gl::Texture* texture() const { return buffer_.size() > 0 ? &texture_ : nullptr; }
    const gl::Buffer& buffer() const { return buffer_; }
    void write(const core::State&);

  private:
    gl::Buffer buffer_;
    gl::Texture texture_;
};

/// A solver whose state lives on the GPU.
class GpuSolver : public core::Solver {
  public:
    /// Valid until the solver advances.
    virtual StateView view() = 0;
    /// Null: none (the default). The timer must outlive its use here.
    virtual void setPassTimer(PassTimer* timer) { passTimer_ = timer; }
    bool setPassObserver(core::PassObserver* observer) override {
        passObserver_ = observer;
        return true;
    }

  protected:
    PassTimer* passTimer_ = nullptr;
    core::PassObserver* passObserver_ = nullptr;
};

/// Brings a CPU solver's state to the GPU for drawing.
class StateUpload {
  public:
    explicit StateUpload(const core::World&);
    StateView upload(const core::State&);

  private:
    NodeBuffer nodes_;
    BondBuffer bonds_;
    ObjectPlaces objects_;
};

}  // namespace sunder::gpu
