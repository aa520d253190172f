#pragma once
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <optional>

#include "cpu/cpu_body_run.hpp"
#include "cpu/cpu_contact.hpp"
#include "cpu/cpu_objects.hpp"
#include "cpu/cpu_solver.hpp"
#include "cpu/flush_denormals.hpp"
#include "cpu/parallel.hpp"

namespace sunder::cpu {

struct CpuSolver::BodyRun : cpu::BodyRun {
    using cpu::BodyRun::BodyRun;
    bool held = true;
};

/// The threads, and how bodies are shared out to them.
struct CpuSolver::Runner {
    std::vector<cpu::Law> laws;
    int threads = 1;
    /// oneTBB hands out no more threads than the machine has cores unless told to.
    std::optional<tbb::global_control> more;
    std::optional<tbb::task_arena> arena;
    int largeCells = 0;             ///< a body or island with more of them is split
    std::vector<int> whole, split;  ///< bodies: one thread each; all threads on each in turn
    std::optional<cpu::Contact> contact;
    std::optional<Objects> objects;
    std::optional<cpu::ObjectCells> objectCells;
    std::unique_ptr<core::IncidentWatch> watch;
    core::PassObserver* observer = nullptr;
    std::vector<bool> touching;             ///< per body: something else may touch it
    std::optional<core::RestIslands> rest;  ///< with contact
    int restInterval = 0;                   ///< steps from one look for rest to the next
    /// Awake bodies that may touch something, in groups that have nothing to do with each other;
    /// with objects, the first are those near one and what hangs on them.
    std::vector<std::vector<int>> islands;

    /// Calls work(0) .. work(count − 1), shared out to the threads.
    template <class Work>
    void forEach(int count, const Work& work) const {
        const auto guarded = [&](int i) {
            const cpu::FlushDenormals flush;
            work(i);
        };
        if (threads == 1 || count == 1) {
            for (int i = 0; i < count; ++i) guarded(i);
        } else {
            cpu::parallelFor(count, guarded);
        }
    }
    template <class Work>
    void inArena(const Work& work) {
        if (arena)
            arena->execute(work);
        else
            work();
    }
};

}  // namespace sunder::cpu
