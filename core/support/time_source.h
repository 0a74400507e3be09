#pragma once

#include <chrono>
#include <functional>

namespace esm {

/// Seconds since a moment that stays the same. What limits or measures time asks one that it is given, so
/// that its limits can be tried without waiting.
using TimeSource = std::function<double()>;

/// The machine's own, which is never set back.
inline double steadySeconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace esm
