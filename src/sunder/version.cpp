#include "sunder/version.hpp"

namespace sunder {

Version version() noexcept {
    return {SUNDER_VERSION_MAJOR, SUNDER_VERSION_MINOR, SUNDER_VERSION_PATCH};
}

}  // namespace sunder
