#pragma once
#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "cpu/processor.hpp"

namespace sunder::cpu {

/// Threads that stay together for a whole frame and meet at every pass of every substep: one leads,
/// and hands out one pass after the other; the others spin until there is one. To start a task
/// takes a task system longer than a pass of a small wall does.
///
/// It cannot hang, however many threads come, and whenever they do. A pass is cut into portions,
/// and each is claimed before it is worked on. Nobody waits for a portion that is not claimed: who
/// has waited for a moment claims it himself. So the leader only ever waits for threads in the
/// middle of a portion, which wait for nothing, and helpers only for the leader. A helper that
/// comes late finds others at its portions, one that comes after the end has nothing to do, and a
/// leader without helpers does all the work alone.
///
/// Portions keep their threads from pass to pass, so that a body's state stays in the cache of the
/// thread that works on it.
class Crew {
  public:
    explicit Crew(int size)
        : portions_(static_cast<std::size_t>(kPortionsEach) * static_cast<std::size_t>(size)) {}

    /// Begins when no thread of the last time is left.
    void open() {
        present_.store(1, std::memory_order_relaxed);
        pass_.store(packed(number_, 0), std::memory_order_release);
    }
    /// Lets helpers go.
    void close() { pass_.store(kClosed, std::memory_order_release); }

    /// By any thread but the leader: helps until the crew is closed.
    void help() {
        const int rank = present_.fetch_add(1, std::memory_order_relaxed);
        std::uint64_t last = 0;
        for (int waited = 0;;) {
            const std::uint64_t pass = pass_.load(std::memory_order_acquire);
            if (pass == kClosed) return;
            if (pass != last) {
                last = pass;
                waited = 0;
                workOnOwn(pass, rank);
            } else if (++waited == kPatience) {
                workOnAny(pass);
            } else {
                pause(waited);
            }
        }
    }

    /// By the leader, between open() and close(): calls work(0) .. work(count − 1).
    template <class Work>
    void forEach(int count, const Work& work) {
        struct Call {
            const Work& work;
            long long count, portions;
        };
        const int portions = std::min(count, static_cast<int>(portions_.size()));
        const Call call{work, count, portions};
        data_.store(&call, std::memory_order_relaxed);
        call_.store(
            [](const void* data, int portion) {
                const Call& c = *static_cast<const Call*>(data);
                const auto at = [&](int i) { return static_cast<int>(c.count * i / c.portions); };
                for (int i = at(portion); i < at(portion + 1); ++i) c.work(i);
            },
            std::memory_order_relaxed);
        const std::uint64_t pass = packed(++number_, portions);
        pass_.store(pass, std::memory_order_release);
        workOnOwn(pass, 0);
        waitFor(pass);
        if (failed_.load(std::memory_order_relaxed)) rethrow();
    }

  private:
    static constexpr int kPortionsEach = 4;
    /// Spins before a thread takes what is another's: less than a microsecond or two.
    static constexpr int kPatience = 64;
    /// Spins before a thread that waits offers its processor to others at each further one.
    static constexpr int kSpins = 512;
    static constexpr std::uint64_t kClosed = ~std::uint64_t{0};

    /// The numbers of the last pass in which it was claimed and finished.
    struct alignas(64) Portion {
        std::atomic<std::uint64_t> claimed{0}, finished{0};
    };

    /// Number of a pass and of its portions, in one word, so that no thread ever sees the number of
    /// one pass and the portions of another.
    static std::uint64_t packed(std::uint64_t number, int portions) {
        return number << 16 | static_cast<std::uint64_t>(portions);
    }
    static std::uint64_t numberOf(std::uint64_t pass) { return pass >> 16; }
    static int portionsOf(std::uint64_t pass) { return static_cast<int>(pass & 0xffff); }

    static void pause(int waited) {
        if (waited > kSpins)
            std::this_thread::yield();
        else
            pauseProcessor();
    }

    void workOnOwn(std::uint64_t pass, int rank) {
        const int portions = portionsOf(pass), present = present_.load(std::memory_order_relaxed);
        work(pass, portions * rank / present, portions * (rank + 1) / present);
    }
    void workOnAny(std::uint64_t pass) { work(pass, 0, portionsOf(pass)); }

    void work(std::uint64_t pass, int first, int end) {
        if (first == end) return;
        const FlushDenormals flush;
        for (int i = first; i < end; ++i) {
            Portion& portion = portions_[static_cast<std::size_t>(i)];
            // The leader goes on only when all portions of a pass have its number. So a claim by a
            // thread that still believes in an earlier pass finds a number that is too large.
            std::uint64_t before = portion.claimed.load(std::memory_order_relaxed);
            if (before >= numberOf(pass) || !portion.claimed.compare_exchange_strong(
                                                before, numberOf(pass), std::memory_order_acq_rel))
                continue;
            try {
                call_.load(std::memory_order_relaxed)(data_.load(std::memory_order_relaxed), i);
            } catch (...) {
                keep(std::current_exception());
            }
            portion.finished.store(numberOf(pass), std::memory_order_release);
        }
    }

    void waitFor(std::uint64_t pass) {
        int waited = 0;
        for (int i = 0; i < portionsOf(pass); ++i)
            while (portions_[static_cast<std::size_t>(i)].finished.load(
                       std::memory_order_acquire) != numberOf(pass))
                if (++waited == kPatience)
                    workOnAny(pass);
                else
                    pause(waited);
    }

    void keep(std::exception_ptr thrown) {
        const std::lock_guard lock(mutex_);
        if (!thrown_) thrown_ = std::move(thrown);
        failed_.store(true, std::memory_order_relaxed);
    }
    void rethrow() {
        failed_.store(false, std::memory_order_relaxed);
        std::rethrow_exception(std::exchange(thrown_, nullptr));
    }

    std::vector<Portion> portions_;
    std::uint64_t number_ = 0;  ///< of the last pass; the leader's
    alignas(64) std::atomic<std::uint64_t> pass_{kClosed};
    std::atomic<const void*> data_{nullptr};
    std::atomic<void (*)(const void*, int)> call_{nullptr};
    std::atomic<int> present_{1};  ///< threads that have come, the leader among them
    alignas(64) std::atomic<bool> failed_{false};
    std::mutex mutex_;
    std::exception_ptr thrown_;
};

}  // namespace sunder::cpu
