#pragma once
#include "sunder/tasks.hpp"

namespace sunder::cpu {

inline constexpr int kMaxThreads = 1024;

/// Which threads a solver works with. The bits of its results do not depend on them.
struct Threads {
    Threads(int number = 0) : count(number) {}
    explicit Threads(const TaskSystem* tasks) : host(tasks) {}

    int count = 0;                     ///< 0: one per core
    const TaskSystem* host = nullptr;  ///< instead of our own; must outlive the solver
};

}  // namespace sunder::cpu
