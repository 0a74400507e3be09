#pragma once

#include "core/dynamics/spring_system.h"

namespace esm {

/// How slowly a node is brought to rest by what holds the tissue: tethers and fixed nodes.
struct Settling {
    double waveTime;  ///< s, that a wave takes to the nearest hold: the time of the slowest swing, roughly
    double driftTime; ///< s, that a slow motion takes to come to rest, at most
};

/// One per node; fixed nodes take no time, what nothing holds takes for ever.
std::vector<Settling> settlingOf(const SpringSystem& system);

} // namespace esm
