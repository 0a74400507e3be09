#pragma once

#include "core/authoring/systems.h"
#include "core/geometry/surface_spot.h"
#include "core/project/tissue_preset.h"

#include <optional>
#include <string>

namespace esm {

/// The colour that is told apart best from those in use.
std::array<std::uint8_t, 3> unusedColour(const std::vector<Region>& regions);

/// A new ellipsoid region on top, a quarter of the organ's size, around a point, with a name and a colour of
/// its own. Precondition, here and below where a region may be made: `id` is not another's, see nextId().
void addRegion(Project& project, RegionId id, const Eigen::Vector3d& centre, SharedSystem system = {});

/// What the list's "Whole organ" row keeps its tissue in: a lowest region without an ellipsoid; null where
/// there is none.
const Region* wholeOrganRegion(const Project& project);

/// A fuzzy system for a region; inputs keep what they are set to as inputsUnder() has it, and those of a
/// system in clinical units begin where the tissue is. Null takes the
/// system away. The one before stays in the project. Where no region is this one, it is made: of the whole
/// organ, beneath the others.
void setSystem(Project& project, RegionId region, SharedSystem system);

/// Gives a region's tissue the preset's words. What is no part of an organ, a region without an ellipsoid or
/// one that is not there, takes its mass and tethers too. A preset of tethers alone is for the whole organ.
/// Where no region is this one, the words go to the whole organ's, which is made as by setSystem() where
/// there is none. Gives the region that the words went to, if any.
std::optional<RegionId> applyPreset(Project& project, RegionId region, const TissuePreset& preset);

/// Lays a region over so many of those above it, or under those below it where `above` is below zero; the
/// whole organ stays beneath.
bool canMoveRegion(const Project& project, RegionId region, int above);
void moveRegion(Project& project, RegionId region, int above);

/// Nothing where it is not there. Its fuzzy system stays in the project.
void removeRegion(Project& project, RegionId region);

/// A copy beside a region with an ellipsoid, just above it in the list: the same tissue, a name and a colour
/// of its own.
void duplicateRegion(Project& project, RegionId region, RegionId copy);

/// Lays a region's ellipsoid flat on the surface around a spot. Where no region is this one, or it has no
/// ellipsoid, `added` is added with this system as `addRegion` does, round, large enough for a twentieth of
/// the nodes.
void placeRegion(Project& project, RegionId region, RegionId added, const SurfaceSpot& spot,
                 SharedSystem system = {});

/// Fixes the nodes inside a region's ellipsoid in space. Precondition: it has one.
void fixNodesInside(Project& project, RegionId region);

double& valueOf(BaseTissue& base, Parameter parameter);

} // namespace esm
