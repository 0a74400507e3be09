#pragma once

#include <chrono>
#include <cstdint>

/// ns, the same for all programs of the machine.
inline std::int64_t steadyTime() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}
