#pragma once
#if defined(__SANITIZE_THREAD__)
#define SUNDER_THREAD_SANITIZER
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define SUNDER_THREAD_SANITIZER
#endif
#endif

#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <functional>
#include <optional>
#ifdef SUNDER_THREAD_SANITIZER
#include <thread>
#include <vector>
#endif

#include "cpu/crew.hpp"
#include "cpu/threads.hpp"

namespace sunder::cpu {

/// The threads that a solver shares its work out to: a host's, or oneTBB's in an arena of the
/// solver's own, which never has more of them than the machine has cores. They stay together for as
/// long as run() takes (cpu/crew.hpp).
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
        if (size_ > 1) crew_.emplace(size_);
    }

    int size() const { return size_; }

    /// Calls work(), from within which forEach() shares work out; not from within itself.
    template <class Work>
    void run(const Work& work) {
        if (!crew_)
            work();
        else if (host_)
            onHost(work);
        else
            arena_->execute([&] { onArena(work); });
    }

    /// Calls work(0) .. work(count − 1); not from within itself.
    template <class Work>
    void forEach(int count, const Work& work) {
        if (crew_ && count > 1) {
            if (callHelpers_) std::exchange(callHelpers_, nullptr)();
            crew_->forEach(count, work);
            return;
        }
        const FlushDenormals flush;
        for (int i = 0; i < count; ++i) work(i);
    }

  private:
    /// What is thrown must not pass through the host's code.
    template <class Work>
    void lead(const Work& work, std::exception_ptr& thrown) {
        try {
            work();
        } catch (...) {
            thrown = std::current_exception();
        }
        crew_->close();
    }

    /// The first task that the host starts leads, whichever it is: a host may run them one after
    /// the other, and in any order.
    template <class Work>
    void onHost(const Work& work) {
        struct Tasks {
            Team& team;
            const Work& work;
            std::atomic<bool> led{false};
            std::exception_ptr thrown;
        };
        Tasks tasks{*this, work, {}, {}};
        crew_->open();
        const auto task = [](void* data, int) {
            Tasks& t = *static_cast<Tasks*>(data);
            if (t.led.exchange(true))
                t.team.crew_->help();
            else
                t.team.lead(t.work, t.thrown);
        };
        host_->forEach(host_->user, size_, task, &tasks);
        if (tasks.thrown) std::rethrow_exception(tasks.thrown);
    }

    /// Helpers are called once there is work to share: a frame in which all sleeps wakes nobody.
    template <class Work>
    void onArena(const Work& work) {
        std::exception_ptr thrown;
        crew_->open();
#ifdef SUNDER_THREAD_SANITIZER
        // Plain threads, whose start and end the thread sanitizer knows. oneTBB's library is not
        // built for it: there it would see races in how tasks are handed over, and none of ours.
        std::vector<std::thread> helpers;
        callHelpers_ = [&] {
            for (int i = 1; i < 3; ++i) helpers.emplace_back([this] { crew_->help(); });
        };
        lead(work, thrown);
        for (std::thread& helper : helpers) helper.join();
#else
        tbb::task_group helpers;
        callHelpers_ = [&] {
            for (int i = 1; i < arena_->max_concurrency(); ++i)
                helpers.run([this] { crew_->help(); });
        };
        lead(work, thrown);
        helpers.wait();
#endif
        callHelpers_ = nullptr;
        if (thrown) std::rethrow_exception(thrown);
    }

    const TaskSystem* host_;
    int size_ = 1;
    std::optional<tbb::task_arena> arena_;
    std::optional<Crew> crew_;
    std::function<void()> callHelpers_;  ///< where nobody has yet
};

}  // namespace sunder::cpu
