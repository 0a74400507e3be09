#pragma once

#include "core/support/words.h"

#include <array>

namespace esm {

/// What one unit of a file's coordinates is.
enum class LengthUnit { Millimetre, Centimetre, Metre };
template<>
inline constexpr auto wordsOf<LengthUnit> = std::array{
    Word{LengthUnit::Millimetre, "mm"}, Word{LengthUnit::Centimetre, "cm"}, Word{LengthUnit::Metre, "m"}};

constexpr double metresPer(LengthUnit unit) {
    switch (unit) {
    case LengthUnit::Millimetre:
        return 0.001;
    case LengthUnit::Centimetre:
        return 0.01;
    case LengthUnit::Metre:
        break;
    }
    return 1;
}

} // namespace esm
