// sunder_unit_tests --update-states [SCENE]
#include "command.hpp"
#include "states/update.hpp"

static const Command kUpdateStates{"--update-states", updateStates};
