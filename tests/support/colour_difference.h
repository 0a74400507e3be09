#pragma once

#include <array>
#include <cstdint>

namespace esm {

using LabColour = std::array<double, 3>; ///< CIE L*, a*, b*, D65

LabColour labOf(const std::uint8_t* srgb);

/// How different two colours look: ΔE₀₀ of CIE 142-2001; about 1 can just be told.
double colourDifference(const LabColour& first, const LabColour& second);

} // namespace esm
