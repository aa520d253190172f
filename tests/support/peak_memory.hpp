#pragma once
#include <cstdint>
#include <functional>

/// Bytes by which the memory that this process has at once rises while `work` runs, to the highest;
/// 0 on systems that do not say.
std::int64_t peakMemory(const std::function<void()>& work);
