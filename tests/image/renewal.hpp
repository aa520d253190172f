#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "image/suite.hpp"

/// What tools/update-baselines was asked for.
struct Renewal {
    std::string only = {};  ///< one picture; empty: all
    bool states = false;    ///< stored states too; otherwise only those that are missing
    bool ci = false;        ///< the machine is one that tests changes by itself
};

/// Why nothing may be renewed here; empty: it may.
std::string renewalRefused(const Suite&, const sunder::gl::DeviceInfo&, bool ci);

/// Draws baselines, and stores states, in `folder`: tests/image, or one like it. Returns what it
/// wrote. With another state come all pictures of it. Throws InputError, and nothing is written, on
/// a CI machine, on another driver than made the others, for a picture there is none of.
std::vector<std::filesystem::path> renew(const Suite&, const std::filesystem::path& folder,
                                         const sunder::gl::DeviceInfo&, const Renewal&);
