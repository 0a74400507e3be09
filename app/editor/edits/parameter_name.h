#pragma once

#include "core/project/region.h"

#include <QString>

namespace esm {

/// Whose tissue a parameter speaks of: the organ's before any region, or a region's.
enum class Extent { Base, Region };

QString parameterName(Parameter parameter, Extent extent);

} // namespace esm
