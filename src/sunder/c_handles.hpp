#pragma once
#include <vector>

#include "sunder/sunder.h"
#include "sunder/sunder.hpp"

// What C's handles are.

struct sunder_desc {
    sunder::WorldDesc desc;
};

struct sunder_world {
    sunder::World world;
    std::vector<sunder_incident> incidents;
    std::vector<std::byte> saved;
};

/// A library without its part on the GPU makes none.
struct sunder_device {
    virtual ~sunder_device() = default;
    virtual sunder::Device& device() = 0;
};

namespace sunder {

/// Keeps the message for sunder_message().
sunder_status fail(const Error&) noexcept;

template <class T>
sunder_status statusOf(const Result<T>& result) noexcept {
    return result ? SUNDER_OK : fail(result.error());
}

}  // namespace sunder
