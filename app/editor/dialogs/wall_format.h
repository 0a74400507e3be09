#pragma once

#include "core/project/wall.h"
#include "widgets/inputs/number_field.h"

namespace esm {

/// How thick a wall of prisms is, m, shown in mm.
inline NumberFormat wallThicknessFormat() {
    NumberFormat format;
    format.unit = QStringLiteral("mm");
    format.shownPerValue = 1000;
    format.minimum = 1e-6;
    format.maximum = thickestWall;
    return format;
}

} // namespace esm
