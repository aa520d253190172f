#include "core/loss_notes.hpp"

namespace sunder {

std::vector<std::string> lossNotes(const Solver& solver) {
    std::vector<std::string> notes;
    if (const std::int64_t dropped = solver.droppedContacts(); dropped > 0)
        notes.push_back("up to " + std::to_string(dropped) +
                        " contacts at a time found no room and were left out; the solver cpu has "
                        "room for all");
    return notes;
}

}  // namespace sunder
