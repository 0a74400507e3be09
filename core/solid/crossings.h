#pragma once

#include "core/solid/closed_body.h"
#include "core/support/progress.h"

#include <cstddef>
#include <vector>

namespace esm {

/// A place where bodies' surfaces run through themselves or each other: triangles that meet, and what lies
/// beyond them on the wrong side.
struct Crossing {
    std::size_t pairs;     ///< of triangles that meet
    Eigen::Vector3d place; ///< its middle, m
    double width;          ///< of a straight tube around it, m
    double spacing;        ///< of the finest lattice of the bodies that meet, m

    /// Narrow enough for a lattice not to see it: no point of it lies deeper than a quarter of the spacing,
    /// and springs may run outside as deep as that anywhere (`deepestChord()`).
    bool isNarrow() const { return width <= 0.5 * spacing; }
};

/// In the order of their first triangles. Of one that is known not to be narrow the width is what is known.
/// @param spacings of each body's lattice, m
/// @throws Cancelled
std::vector<Crossing> crossingsOf(const std::vector<ClosedBody>& bodies, const std::vector<double>& spacings,
                                  const Progress& progress = {});

} // namespace esm
