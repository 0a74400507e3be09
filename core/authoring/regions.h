#pragma once

#include "core/geometry/surface_spot.h"
#include "core/project/project.h"
#include "core/project/tissue_preset.h"

#include <cstddef>
#include <optional>
#include <string>

namespace esm {

/// Shared by regions that speak the same language.
using SharedSystem = std::shared_ptr<const FuzzySystem>;

/// The colour that is told apart best from those in use.
std::array<std::uint8_t, 3> unusedColour(const std::vector<Region>& regions);

/// A new ellipsoid region on top, a quarter of the organ's size, around a point, with a name and a colour of
/// its own.
void addRegion(Project& project, const Eigen::Vector3d& centre, SharedSystem system = {});

/// Where the list's "Whole organ" row keeps its tissue: a lowest region without an ellipsoid, if there is
/// one.
std::optional<std::size_t> wholeOrganRegion(const Project& project);

/// A fuzzy system for a region; its inputs start in the middle of their ranges, unless the one before had the
/// same. Null takes the system away.
/// Without a region, a region of the whole organ is laid beneath the others first. Gives the region's index.
std::size_t setSystem(Project& project, std::optional<std::size_t> region, SharedSystem system);

/// Gives a region's tissue the preset's words. What is no part of an organ, a region without an ellipsoid or
/// none, takes its mass and tethers too; without a region one is made as by setSystem(). A preset of tethers
/// alone is for the whole organ. Gives the index of the region that the words went to, if any.
std::optional<std::size_t> applyPreset(Project& project, std::optional<std::size_t> region,
                                       const TissuePreset& preset);

/// Lays a region over so many of those above it, or under those below it where `above` is below zero; the
/// whole organ stays beneath.
bool canMoveRegion(const Project& project, std::size_t region, int above);
void moveRegion(Project& project, std::size_t region, int above);

void removeRegion(Project& project, std::size_t region);

/// A copy beside a region with an ellipsoid, just above it in the list: the same tissue, a name and a colour
/// of its own.
void duplicateRegion(Project& project, std::size_t region);

/// Lays a region's ellipsoid flat on the surface around a spot. Without a region, or where it has no
/// ellipsoid, a new one with this system is added as `addRegion` does, round, large enough for a twentieth of
/// the nodes.
void placeRegion(Project& project, std::optional<std::size_t> region, const SurfaceSpot& spot,
                 SharedSystem system = {});

/// Fixes the nodes inside a region's ellipsoid in space. Precondition: it has one.
void fixNodesInside(Project& project, std::size_t region);

double& valueOf(BaseTissue& base, Parameter parameter);

} // namespace esm
