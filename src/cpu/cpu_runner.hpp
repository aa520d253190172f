#pragma once
#include <optional>

#include "cpu/cpu_body_run.hpp"
#include "cpu/cpu_contact.hpp"
#include "cpu/cpu_objects.hpp"
#include "cpu/cpu_solver.hpp"
#include "cpu/team.hpp"

namespace sunder::cpu {

/// The threads, and how bodies are shared out to them.
struct CpuSolver::Runner {
    explicit Runner(const Threads& threads) : team(threads) {}

    std::vector<cpu::Law> laws;
    Team team;
    int largeCells = 0;             ///< a body or island with more of them is split
    std::vector<int> whole, split;  ///< bodies: one thread each; all threads on each in turn
    std::optional<cpu::Contact> contact;
    std::optional<Objects> objects;
    std::optional<cpu::ObjectCells> objectCells;
    std::unique_ptr<core::IncidentWatch> watch;
    core::PassObserver* observer = nullptr;
    std::vector<bool> touching;  ///< per body: something else may touch it
    int restInterval = 0;        ///< steps from one look for rest to the next
    /// Awake bodies that may touch something, in groups that have nothing to do with each other;
    /// with objects, the first are those near one and what hangs on them.
    std::vector<std::vector<int>> islands;
};

}  // namespace sunder::cpu
