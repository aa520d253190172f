#pragma once
#include <tbb/parallel_for.h>

#if defined(__SANITIZE_THREAD__)
#define SUNDER_THREAD_SANITIZER
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define SUNDER_THREAD_SANITIZER
#endif
#endif

#ifdef SUNDER_THREAD_SANITIZER
extern "C" void __tsan_acquire(void*);
extern "C" void __tsan_release(void*);
#endif

namespace sunder::cpu {

/// Tells the thread sanitizer what oneTBB promises, and what it cannot see, as oneTBB's library is
/// built without it: what was done before a fork happens before all work, and all work before what
/// follows the join. Between two pieces of work it promises nothing, so their races are found.
class ForkJoin {
  public:
#ifdef SUNDER_THREAD_SANITIZER
    ForkJoin() {
        __tsan_release(&fork_);
    }
    ~ForkJoin() {
        __tsan_acquire(&join_);
    }
    void begin() {
        __tsan_acquire(&fork_);
    }
    void end() {
        __tsan_release(&join_);
    }

  private:
    char fork_ = 0, join_ = 0;
#else
    ForkJoin() {}
    void begin() {}
    void end() {}
#endif
};

/// Calls work(0) .. work(count − 1), shared out to the threads of the arena.
template <class Work, class Partitioner = tbb::auto_partitioner>
void parallelFor(int count, const Work& work, const Partitioner& partitioner = {}) {
    ForkJoin order;
    tbb::parallel_for(
        0, count,
        [&](int i) {
            order.begin();
            work(i);
            order.end();
        },
        partitioner);
}

}  // namespace sunder::cpu
