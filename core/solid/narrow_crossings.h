#pragma once

#include "core/solid/closed_body.h"
#include "core/support/progress.h"

#include <cstddef>
#include <vector>

namespace esm {

/// Where the surface runs through itself, too narrowly for the lattice to see it.
struct NarrowCrossings {
    std::size_t places = 0;
    double width = 0; ///< of the widest, m
};

/// @param spacing that the bodies are to be filled with, m; a thin one has a finer lattice
/// @throws InvalidModel where one is wide (`Crossing::isNarrow()`): where, how wide, and the finest spacing
/// that would pass over it; Cancelled
NarrowCrossings narrowCrossingsOf(const std::vector<ClosedBody>& bodies, double spacing,
                                  const Progress& progress = {});

} // namespace esm
