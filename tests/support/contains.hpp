#pragma once
#include <string>

/// `part` stands somewhere in `text`.
inline bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}
