#pragma once

#include "core/geometry/length_unit.h"

#include <QString>

#include <vector>

namespace esm {

/// Lengths (m) beside each other, all in the unit of the largest.
QString lengthsText(const std::vector<double>& metres);

/// Says that no organ has this extent, in a file's unit, and which unit would fit; empty where it may be.
QString doubtfulExtent(double largestExtent, LengthUnit unit);

} // namespace esm
