// sunder_gpu_tests --update-states [SCENE]
#include "command.hpp"
#include "gpu/test_context.hpp"
#include "states/update.hpp"

static const Command kUpdateStates{"--update-states", [](const auto& arguments) {
                                       const TestContextOfCommand released;
                                       updateStates(arguments);
                                   }};
