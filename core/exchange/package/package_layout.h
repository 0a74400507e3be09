#pragma once

#include "core/model/lattice.h"

#include <cstdint>

/// What writing and reading of the model package agree on; described in `docs/model-package.md`.
namespace esm::package_layout {

constexpr const char* extension = "ESM_spring_mass";
constexpr const char* units = "SI: metre, kilogram, second, newton";

/// The first version whose springs may have values other than their ends' mean.
constexpr int versionOfOwnValues = 6;

/// The first version in which more than three nodes may carry a vertex.
constexpr int versionOfWideBindings = 6;

/// The first version whose triangles may lie stretched in the texture.
constexpr int versionOfStretchedLayouts = 7;

/// The first version in which the body may be filled so: with an even lattice, a graded one or prisms.
constexpr int versionOfFilled(LatticeKind kind) {
    return kind == LatticeKind::Graded || kind == LatticeKind::Prisms ? 9 : 8;
}

/// The first version whose fuzzy systems may say tissue in clinical units.
constexpr int versionOfClinicalUnits = 9;

/// The first version in which fluid may fill parts of the surface.
constexpr int versionOfFillings = 9;

/// The first version in which a wall may resist bending.
constexpr int versionOfHinges = 9;

/// Kinds of springs of a filled body: along an edge of the surface that instruments touch, or beneath it.
constexpr std::uint32_t springOfTheSurface = 0, springWithin = 1;

/// Pixels, width and height of the preview picture.
constexpr int largestPreview = 4096;

} // namespace esm::package_layout
