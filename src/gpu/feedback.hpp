#pragma once
#include <initializer_list>

#include "gl/program.hpp"
#include "gpu/world_buffers.hpp"

namespace sunder::gpu {

/// Texture units of the solvers' passes. One meaning each, so that a pass binds only what changed.
enum Unit {
    kCells,
    kBodies,
    kRest,
    kNodes,
    kBonds,
    kEvents,
    kLinks,
    kForces,
    kStresses,
    kCumulative,
    kStrengths,
    kRectangles,
    kChunks,
    kRecords,
    kSpheres,
    kRegions,
    kExposed,
    kGrid,
    kPartners,
    kSummaries,
    kHastes,
    kFreeMotions,
    kSphereForces,
    kObjects,
    kMotion,
    kSleepers,
    kTouchCounts,
    kImpulses,
    kKnownBonds,
    kPushes,
    kPushesBefore,
    kPushesEarlier,
    kPartings,
    kReleased,
    kCellGroups,
    kUnitCount
};

/// Points every sampler and uniform block the program has to its place, and sets what stays the
/// same for a whole run: step, fracture interval, ground, room, how things part, columns of the
/// solver's textures (a power of two).
void setConstants(const gl::Program& program, const core::World& world, int textureColumns);

/// Binds what does not change while a solver advances: another user of the context may have used
/// these units since.
void bindWorld(const WorldBuffers& buffers);

/// A framebuffer with these colour attachments. Throws DeviceError when the driver cannot draw
/// into them.
gl::Framebuffer makeTarget(std::initializer_list<const gl::Texture*> textures);

/// Runs vertex shaders whose outputs are captured in buffers and whose points are not drawn.
class Feedback {
  public:
    Feedback();
    /// `targets`: one per buffer the program's varyings go to. Reads vertex attributes from
    /// `attributes`.
    void run(const gl::Program& program, const gl::VertexArray& attributes,
             std::initializer_list<const gl::Buffer*> targets, int count) const;
    /// The same without attributes: the shader fetches by gl_VertexID.
    void run(const gl::Program& program, std::initializer_list<const gl::Buffer*> targets,
             int count) const;
    /// Of the vertices from number `first` on, each into its place in `target`, `stride` bytes
    /// apart.
    void runPart(const gl::Program& program, const gl::VertexArray& attributes,
                 const gl::Buffer& target, std::size_t stride, int first, int count) const;

  private:
    /// bind: binds the targets' indices.
    template <class Bind>
    void capture(const gl::Program& program, const gl::VertexArray& attributes, const Bind& bind,
                 int targets, int first, int count) const;
    gl::Texture texture_;
    gl::Framebuffer target_;
    gl::TransformFeedback capture_;
    gl::VertexArray noAttributes_;
};

}  // namespace sunder::gpu
