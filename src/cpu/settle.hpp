#pragma once
#include <functional>
#include <string>
#include <vector>

#include "core/world.hpp"
#include "cpu/threads.hpp"

namespace sunder::cpu {

/// How a world begins.
struct Start {
    core::State state;
    /// Bodies that something carries, but whose state of rest was not found with the work allowed
    /// for it, or lies within something that has none: their weight may act as an impact.
    std::vector<std::string> restless;
};

/// Is told the share of the work allowed that is done, 0 to 1; most worlds need little of it.
using SettleProgress = std::function<void(double)>;

/// The world as it stands before anything happens. Like World::initialState(), but what something
/// carries (core/standing.hpp) is at rest under its weight, as deformed as that asks for
/// (cpu/relaxation.hpp), and the slow part of each bond's traction is what the bond bears. Without
/// it, weight would be an impact: it would act at once on what bears nothing yet, and what an
/// impact's stress loses to the limit of E is scaled back. What flies, falls or topples begins as
/// described; so do objects that hang. The same bits for any number of threads; bounded work.
Start settledStart(const core::World&, const SettleProgress& progress = {},
                   const Threads& threads = {});

/// What to tell a person of a start, as one sentence; empty where there is nothing.
std::string restlessWarning(const Start&);

}  // namespace sunder::cpu
