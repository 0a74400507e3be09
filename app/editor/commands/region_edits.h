#pragma once

#include "core/model/project.h"

#include <cstddef>
#include <optional>
#include <string>

namespace esm {

/// A new ellipsoid region on top, a quarter of the organ's size, around a point, with a colour of its own and
/// the simplest of the shipped fuzzy systems.
void addRegion(Project& project, const Eigen::Vector3d& centre);

/// Where the list's "Whole organ" row keeps its tissue: a lowest region without an ellipsoid, if there is
/// one.
std::optional<std::size_t> wholeOrganRegion(const Project& project);

/// A fuzzy system for a region; its inputs start in the middle of their ranges. Null takes the system away.
/// Without a region, a region of the whole organ is laid beneath the others first. Gives the region's index.
std::size_t setSystem(Project& project, std::optional<std::size_t> region,
                      std::shared_ptr<const FuzzySystem> system);

/// Sets or adds one input value.
void setInput(Region& region, const std::string& variable, double value);

/// Exchanges a region with its neighbour `above` (+1) or below (−1) it, where it has one that may move.
bool canMoveRegion(const Project& project, std::size_t region, int above);
void moveRegion(Project& project, std::size_t region, int above);

void removeRegion(Project& project, std::size_t region);

/// Fixes the nodes inside a region's ellipsoid in space. Precondition: it has one.
void fixNodesInside(Project& project, std::size_t region);

double& valueOf(BaseTissue& base, Parameter parameter);

} // namespace esm
