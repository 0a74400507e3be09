#pragma once

#include "core/geometry/length_unit.h"

#include <string_view>
#include <vector>

/// Mesh files seldom say which unit they are in. How large the organ would be tells.
namespace esm {

/// Whether organs and bodies have this size: 1 mm to 3 m.
bool isPlausibleSize(double metres);

struct FittingUnit {
    LengthUnit unit;
    double size; ///< m, with this unit
};
/// The units in which so many of a file's units are a plausible size, the smallest first.
std::vector<FittingUnit> fittingUnits(double extent);

/// The unit that a file is most likely in. The size is plausible with it wherever it is with any.
/// @param extent the largest side of the box around the surface, in the file's unit
/// @param fileEnding in small letters, without the dot
LengthUnit recommendedUnit(double extent, std::string_view fileEnding);

} // namespace esm
