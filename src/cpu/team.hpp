#pragma once
#if defined(__SANITIZE_THREAD__)
#define SUNDER_THREAD_SANITIZER
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define SUNDER_THREAD_SANITIZER
#endif
#endif

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <exception>
#include <mutex>
#include <optional>
#ifdef SUNDER_THREAD_SANITIZER
#include <thread>
#include <vector>
#endif

#include "cpu/flush_denormals.hpp"
#include "cpu/threads.hpp"

namespace sunder::cpu {

/// The threads that a solver shares its work out to: a host's, or oneTBB's in an arena of the
/// solver's own, which never has more of them than the machine has cores.
class Team {
  public:
    explicit Team(const Threads& threads) : host_(threads.host) {
        size_ = threads.count;
        if (host_)
            size_ = std::clamp(host_->concurrency(host_->user), 1, kMaxThreads);
        else if (size_ < 1)
            size_ = tbb::this_task_arena::max_concurrency();
        // More than there are cores, oneTBB would refuse with a warning; work is split for all of
        // them.
        const int cores = tbb::this_task_arena::max_concurrency();
        if (!host_ && size_ > 1) arena_.emplace(std::min(size_, cores));
    }

    int size() const { return size_; }

    /// Calls work(), from within which forEach() shares work out.
    template <class Work>
    void run(const Work& work) {
        if (arena_)
            arena_->execute(work);
        else
            work();
    }

    /// Calls work(0) .. work(count − 1). `even`: all of them take about as long, so that each may
    /// be a task of its own.
    template <class Work>
    void forEach(int count, const Work& work, bool even = false) const {
        const auto guarded = [&work](int i) {
            const FlushDenormals flush;
            work(i);
        };
        if (size_ == 1 || count <= 1)
            for (int i = 0; i < count; ++i) guarded(i);
        else if (host_)
            onHost(count, guarded);
        else
            onArena(count, guarded, even);
    }

  private:
    /// What is thrown in a task must not pass through the host's code.
    template <class Work>
    void onHost(int count, const Work& work) const {
        struct Tasks {
            const Work& work;
            int count, parts;
            std::mutex mutex;
            std::exception_ptr thrown;
        };
        // A host's tasks may cost more than a small body does.
        Tasks tasks{work, count, std::min(count, 4 * size_), {}, {}};
        const auto part = [](void* data, int index) {
            Tasks& t = *static_cast<Tasks*>(data);
            const auto at = [&t](int i) {
                return static_cast<int>(static_cast<long long>(t.count) * i / t.parts);
            };
            try {
                for (int i = at(index); i < at(index + 1); ++i) t.work(i);
            } catch (...) {
                const std::lock_guard lock(t.mutex);
                if (!t.thrown) t.thrown = std::current_exception();
            }
        };
        host_->forEach(host_->user, tasks.parts, part, &tasks);
        if (tasks.thrown) std::rethrow_exception(tasks.thrown);
    }

#ifdef SUNDER_THREAD_SANITIZER
    /// With plain threads, whose start and end the thread sanitizer knows. oneTBB's library is not
    /// built for it: there it would see races in how tasks are handed over, and none of ours.
    template <class Work>
    void onArena(int count, const Work& work, bool) const {
        constexpr int kThreads = 3;
        std::vector<std::thread> threads;
        for (int first = 0; first < kThreads; ++first)
            threads.emplace_back([&work, first, count] {
                for (int i = first; i < count; i += kThreads) work(i);
            });
        for (std::thread& thread : threads) thread.join();
    }
#else
    template <class Work>
    void onArena(int count, const Work& work, bool even) const {
        if (even)
            tbb::parallel_for(0, count, work, tbb::simple_partitioner());
        else
            tbb::parallel_for(0, count, work);
    }
#endif

    const TaskSystem* host_;
    int size_ = 1;
    std::optional<tbb::task_arena> arena_;
};

}  // namespace sunder::cpu
