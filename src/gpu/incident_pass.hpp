#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/archive.hpp"
#include "core/incident.hpp"
#include "gl/fence.hpp"
#include "gl/timer.hpp"
#include "gpu/contact_pass.hpp"
#include "gpu/feedback.hpp"
#include "gpu/object_pass.hpp"
#include "gpu/texel_target.hpp"

namespace sunder::gpu {

/// Incidents (core/incident.hpp) for the GPU solvers. With contact, what pushes cells in every step
/// is blended into a texel per sphere. A look captures a record of each incident by transform
/// feedback from a geometry shader, one point per cell, and the CPU takes the records two looks
/// later: nothing waits within a frame.
class IncidentPass {
  public:
    /// storage, columns: where and how the solver keeps its nodes. contact, objects: null where the
    /// world has none. All must outlive it.
    IncidentPass(const core::World& world, ContactPass::Storage storage, int columns,
                 const ContactPass* contact, const ObjectPass* objects, core::IncidentRing& ring);

    /// After the forces of a step are known: adds them up.
    void addPushes();

    bool due(std::int64_t step) const { return step % interval_ == 0; }
    /// The first step after `step` that a look is due at.
    std::int64_t next(std::int64_t step) const { return (step / interval_ + 1) * interval_; }
    /// Takes the records of the look before last and captures those of now. Nodes, bonds and the
    /// world's buffers must be bound. The solver then updates known().
    void look(std::int64_t step);
    /// Takes all records there are; waits for the GPU.
    void finish();
    /// The state was set: what pushed before does not count.
    void forget();
    /// What looks compare with, in either direction, once finish() was called. pass: null where
    /// nobody looks: what was saved of one is left out. One that nothing was saved of stays as it
    /// is.
    static void archive(core::Archive& archive, const core::World& world, IncidentPass* pass);
    /// The bonds' damage at the last look: a texel per cell as in the solver's textures, or a
    /// BondRecord as in its buffers.
    gl::Buffer& known() { return known_; }

  private:
    static constexpr int kLag = 2;  ///< looks
    struct Record {
        float place[3], impulse;
        std::int32_t cell, axis, partner, unused;  ///< glsl/incidents/look.geom
    };
    struct Answer {
        std::int64_t step = -1;  ///< −1: nothing asked, or taken
        gl::Buffer records;
        gl::Query written, found;
        gl::Fence done;
    };

    /// What a sphere was pushed with.
    struct Push {
        int sphere;
        float impulse, rank;  ///< N·s; glsl/incidents/rank.glsl
    };
    std::vector<Push> readPushes(int age) const;
    void writePushes(int age, const std::vector<Push>& pushes);
    /// Per cell, a bit for each bond it owns: not held at the last look.
    std::vector<std::uint8_t> readKnown() const;
    void writeKnown(const std::vector<std::uint8_t>& broken);

    void clear(const TexelTarget& pushes) const;
    void take(Answer& answer);
    core::Incident incidentOf(const Record& record, std::int64_t step) const;

    const core::World& world_;
    const ContactPass* contact_;
    const ObjectPass* objects_;
    core::IncidentRing& ring_;
    int interval_;
    std::size_t room_;         ///< records
    std::size_t knownTexels_;  ///< from one cell's to the next
    Feedback feedback_;
    gl::Buffer known_;
    gl::Texture knownTexture_;
    /// What cells were pushed with, since the last look and in the two before, in turn.
    std::vector<TexelTarget> pushes_;
    int current_ = 0;
    gl::Program lookProgram_, cellProgram_, objectProgram_;
    std::array<Answer, kLag> answers_;
    int next_ = 0;
};

}  // namespace sunder::gpu
