#pragma once

#include "core/support/progress.h"
#include "core/texture/atlas/group_profile.h"
#include "core/texture/atlas/patch_layout.h"
#include "core/texture/atlas/unfolding.h"

namespace esm {

/// A group turned so that its smallest box lies along the page.
struct TurnedGroup {
    std::vector<PatchCorners> corners; ///< per triangle, m, from the box's corner
    std::vector<OutlineSide> outline;  ///< the sides that only one triangle has, m
    double length, height;             ///< m, of the box; length ≥ height
    double area;                       ///< m²
};

TurnedGroup turned(const UnfoldedGroup& group);

/// Lays groups one after another at the lowest valley of the border between what is full and what is empty,
/// and chooses of the next tallest that which leaves least room empty there, turned upside down or mirrored
/// where that is better.
/// @param groups tallest first; triangles are numbered group by group
/// @param mostPages beyond which the layout is given up; its height is then an estimate, and it has no
/// corners
PatchLayout layoutGroups(const std::vector<TurnedGroup>& groups, double texelsPerMetre, const PageRoom& page,
                         int mostPages, const Progress& progress = {});

} // namespace esm
