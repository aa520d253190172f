#pragma once
#include <string>
#include <utility>

namespace sunder::app {

/// Width and height of "1280x720". Throws InputError on behalf of --size.
std::pair<int, int> parsePictureSize(const std::string& text);

}  // namespace sunder::app
