#include "core/loss_notes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace sunder::core {
namespace {

std::string outrunNote(const World& world, const std::vector<double>& haste) {
    constexpr int kMostNames = 3;
    std::string names;
    int bodies = 0;
    for (std::size_t body = 0; body < haste.size(); ++body) {
        if (haste[body] <= 1 || ++bodies > kMostNames) continue;
        names += (bodies > 1 ? ", '" : "'") + world.bodies()[body].name + "'";
    }
    if (bodies == 0) return {};
    if (bodies > kMostNames) names += " and " + std::to_string(bodies - kMostNames) + " more";
    const double most = *std::max_element(haste.begin(), haste.end());
    char times[32], substeps[32];
    std::snprintf(times, sizeof times, "%.3g", most);
    std::snprintf(substeps, sizeof substeps, "%.0f", std::ceil(most / (60 * world.step())));
    return "contacts between cells of " + names + " may have been missed: some met " + times +
           " times as fast as the solver looks ahead; substeps = " + substeps +
           ", or the solver cpu, would see them";
}

}  // namespace

std::vector<std::string> lossNotes(const World& world, const Solver& solver) {
    std::vector<std::string> notes;
    if (const std::int64_t dropped = solver.droppedContacts(); dropped > 0)
        notes.push_back("up to " + std::to_string(dropped) +
                        " contacts at a time found no room and were left out; the solver cpu has "
                        "room for all");
    if (std::string note = outrunNote(world, solver.contactHaste()); !note.empty())
        notes.push_back(std::move(note));
    return notes;
}

}  // namespace sunder::core
