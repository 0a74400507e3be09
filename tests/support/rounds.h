#pragma once

#include <cstdint>
#include <cstdlib>

/// Whether the long sets are asked for: `.ci/nightly` sets ESM_LONG_TESTS=1. Asked when tests run, so that
/// they are compiled once for both.
inline bool isLongRun() {
    const char* const asked = std::getenv("ESM_LONG_TESTS");
    return asked && *asked != '\0' && *asked != '0';
}

/// How many rounds a test runs that tries the same with other random numbers each time: `few` wherever every
/// change is tested, `many` in the long sets. The few are the first of the many.
inline int roundsOf(int few, int many) {
    return isLongRun() ? many : few;
}

/// The seed of a round. ESM_TEST_SEED, which is 0 unless somebody sets it, moves the seeds of all rounds, so
/// that each night can try others. A test names the seed where it fails (`SCOPED_TRACE`).
inline std::uint32_t seedOf(int round) {
    const char* const first = std::getenv("ESM_TEST_SEED");
    return static_cast<std::uint32_t>(first ? std::strtoul(first, nullptr, 10) : 0) +
           static_cast<std::uint32_t>(round);
}
