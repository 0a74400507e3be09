#pragma once

#include "core/support/words.h"

#include <array>

namespace esm {

/// A release of SOFA that scenes can be written for: names of components, and what a solver takes of damping,
/// differ from one to the next.
enum class SofaVersion { December2023, June2024, December2024, June2025, December2025, June2026 };
template<>
inline constexpr auto wordsOf<SofaVersion> =
    std::array{Word{SofaVersion::December2023, "23.12"}, Word{SofaVersion::June2024, "24.06"},
               Word{SofaVersion::December2024, "24.12"}, Word{SofaVersion::June2025, "25.06"},
               Word{SofaVersion::December2025, "25.12"}, Word{SofaVersion::June2026, "26.06"}};
inline constexpr SofaVersion newestSofaVersion = SofaVersion::June2026;

} // namespace esm
