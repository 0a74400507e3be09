#pragma once

#include <chrono>

namespace esm {

/// Longer than keys and wheel rest within one movement: what follows is another edit.
constexpr std::chrono::milliseconds pauseBetweenGestures{600};

} // namespace esm
