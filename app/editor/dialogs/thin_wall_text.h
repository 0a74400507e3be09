#pragma once

#include "core/project/project.h"
#include "core/solid/prism_wall.h"

#include <QString>

namespace esm {

/// At how many vertices a wall is thinner than asked for.
QString thinWallText(const WallFit& fit);

/// The same of an organ whose wall often is; empty of any other.
QString thinWallWarning(const Project& project);

} // namespace esm
