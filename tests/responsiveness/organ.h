#pragma once

#include "core/project/project.h"

#include <cstddef>

namespace responsiveness {

enum class Tissue { Published, WeaklyDamped };

/// A ball of about so many nodes, one half of which a region has: `auto` steps it by `split2` where it is as
/// viscous as was published, and by an explicit method where it is weakly damped.
esm::Project ballOf(std::size_t nodes, Tissue tissue);
/// A ball drawn with about so many triangles, of which so many nodes are simulated.
esm::Project drawnBallOf(std::size_t triangles, std::size_t nodes);
/// The same, with so many photos laid around it on a page of so many texels, of which the last is masked by a
/// stroke and blended in bands, and a layer of paint over them.
esm::Project photographedBallOf(std::size_t triangles, int photos, int pageSize);

} // namespace responsiveness
