#pragma once

#include "core/project/project.h"
#include "core/support/progress.h"

namespace esm {

/// The same organ at another level of detail, hollow or filled. Its mass, its tissue and its hold on the
/// surroundings stay as they are over the surface: so many times fewer tethers are so many times stronger.
/// What the scene says of a node is said of the new node nearest to it; fixed nodes fix those around them,
/// and of two led nodes that come to the same place the first is led. Splits are left out, and what names a
/// node that they make: other nodes have other edges. Fluids stay in the part where they were. What becomes
/// rigid, or was, takes the default spring constant, viscosity and hold of its level, and loses its forces,
/// led nodes, fluids and the list of recorded nodes. How to step it best has to be measured again, and what
/// was measured of another filling is dropped.
/// @throws InvalidModel when the surface has no such level of detail, or none with room for its fluids;
/// Cancelled
Project withDetail(const Project& project, const Detail& detail, const Progress& progress = {});

/// The same on a network of the project's surface that was made already.
Project withNetwork(const Project& project, std::shared_ptr<const SpringNetwork> network,
                    const Progress& progress = {});

/// The hollow organ with a node for every vertex: an even sheet, unless it is hollow now and its springs all
/// have their tissue's constant.
Detail hollowDetail(const Project& project);

} // namespace esm
