#pragma once
#if defined(__SANITIZE_THREAD__)
#define SUNDER_THREAD_SANITIZER
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define SUNDER_THREAD_SANITIZER
#endif
#endif

#ifdef SUNDER_THREAD_SANITIZER
#include <thread>
#include <vector>
#endif
#include <tbb/parallel_for.h>

namespace sunder::cpu {

#ifdef SUNDER_THREAD_SANITIZER

/// The same with plain threads, whose start and end the thread sanitizer knows. oneTBB's library is
/// not built for it: there it would see races in how tasks are handed over, and none of ours.
template <class Work, class Partitioner = tbb::auto_partitioner>
void parallelFor(int count, const Work& work, const Partitioner& = {}) {
    constexpr int kThreads = 3;
    std::vector<std::thread> threads;
    for (int first = 0; first < kThreads; ++first)
        threads.emplace_back([&work, first, count] {
            for (int i = first; i < count; i += kThreads) work(i);
        });
    for (std::thread& thread : threads) thread.join();
}

#else

/// Calls work(0) .. work(count − 1), shared out to the threads of the arena.
template <class Work, class Partitioner = tbb::auto_partitioner>
void parallelFor(int count, const Work& work, const Partitioner& partitioner = {}) {
    tbb::parallel_for(0, count, work, partitioner);
}

#endif

}  // namespace sunder::cpu
