#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/archive.hpp"
#include "core/rest_islands.hpp"
#include "core/world.hpp"
#include "gl/fence.hpp"
#include "gpu/texel_target.hpp"

namespace sunder::gpu {

/// Finds out which bodies are calm (core/sleep.hpp), and with contact where they are, without
/// holding up a frame: a pass sums up what chunks of cells did, and its result is read two looks
/// later. What it says depends on the number of the step alone, so a run repeats itself to the bit.
class RestMonitor {
  public:
    /// columns: of the textures that nodes and bonds lie in. World and events must outlive it.
    RestMonitor(const core::World& world, int columns, const core::EventSchedule& events);

    /// Steps from one look to the next, about 1/60 s.
    int interval() const { return interval_; }
    /// What a look has found out.
    struct News {
        std::vector<int> hit;       ///< bodies that a cell of another one hits
        std::int64_t dropped = 0;   ///< contacts that found no room, at the last search
        std::vector<double> haste;  ///< Solver::contactHaste(), since the look before that
    };
    /// A few cells of a body: where they were at the look before last, and the speed that none of
    /// their nodes was above since the one before that, m/s.
    struct Chunk {
        core::RestBox box;
        double fastest;
    };
    /// Takes the answer of the look before last and asks the GPU about the `interval()` steps
    /// before `step`; the textures of nodes, bonds and, with contact, summaries must be bound to
    /// their units, and their programs be told to start anew. Waits only where the GPU is two looks
    /// behind.
    News look(std::int64_t step);
    /// A body is changed from outside at `step`: what it did before no longer counts.
    void disturb(int body, std::int64_t step);
    /// Whether a body is there - of others nothing is said -, and whether its anchors have let go.
    void setBody(int body, bool present, bool released);
    /// How long bodies have been calm, and what it has asked the GPU. Waits for it.
    void archive(core::Archive& archive);
    /// Whether it has been calm for long enough to sleep.
    bool ready(int body) const { return bodies_[body].calmSteps >= sleepSteps_; }
    /// With contact, of all bodies, those with cells.
    const std::vector<Chunk>& chunks() const { return known_; }

  private:
    static constexpr int kLag = 2;  ///< looks
    struct Answer {
        std::int64_t step = -1;  ///< −1: not asked yet
        gl::Buffer texels;
        gl::Fence done;
    };
    struct Body {
        TexelRange chunks;
        float calmSpeed2 = 0, creepSpeed2 = 0;  ///< m²/s²
        int calmSteps = 0;
        std::int64_t disturbed = 0;  ///< step
        bool present = true;
    };

    void archive(core::Archive& archive, Answer& answer);
    void ask(Answer& answer, std::int64_t step);
    void takeChunks(const std::vector<vec4>& unrest);
    News take(const Answer& answer, std::int64_t now);

    const core::World& world_;
    const core::EventSchedule& events_;
    int interval_, sleepSteps_;
    int layers_;  ///< of what a chunk says
    std::vector<Body> bodies_;
    TexelRanges all_;
    gl::Buffer chunkBuffer_;
    gl::Texture chunkTexture_;
    TexelTarget unrest_;  ///< per chunk
    gl::Program program_;
    std::array<Answer, kLag> answers_;
    int next_ = 0;
    std::vector<Chunk> known_;
};

}  // namespace sunder::gpu
