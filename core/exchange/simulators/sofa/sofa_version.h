#pragma once

#include "core/support/words.h"

#include <array>

namespace esm {

/// A release of SOFA that scenes can be written for: names of components, and what a solver takes of damping,
/// differ from one to the next.
enum class SofaVersion { V23_12, V24_06, V24_12, V25_06, V25_12, V26_06 };
template<>
inline constexpr auto wordsOf<SofaVersion> =
    std::array{Word{SofaVersion::V23_12, "23.12"}, Word{SofaVersion::V24_06, "24.06"},
               Word{SofaVersion::V24_12, "24.12"}, Word{SofaVersion::V25_06, "25.06"},
               Word{SofaVersion::V25_12, "25.12"}, Word{SofaVersion::V26_06, "26.06"}};
inline constexpr SofaVersion newestSofaVersion = SofaVersion::V26_06;

} // namespace esm
