#pragma once

#include "app/esmc/report.h"
#include "core/model/spring_network.h"
#include "core/solid/filled_body.h"

#include <string>

namespace esm {

/// `lattice` and `spacing`, of prisms `wall_thickness` and `layers`.
void addFilling(Json& json, const LatticeFilling& filling);

/// "cubic lattice, spacing 0.01 m", "wall of prisms, 0.003 m in 1 layer"
std::string fillingText(const LatticeFilling& filling);

/// `crossings`: at how many `places` the surface runs through itself too narrowly for the lattice to see, and
/// the `width` of the widest, m.
void addCrossings(Report& report, const NarrowCrossings& crossings);

/// `wall`: what a wall of prisms came to; its `volume` (m³), at how many vertices it is thinner than asked
/// for (`shortened`), and how thick it is where it is thinnest (`least_thickness`, m), and under how many
/// triangles there is none (`left_out`).
/// @param triangles of the drawn surface
/// Precondition: the network has one.
void addWall(Report& report, const SpringNetwork& network, std::size_t triangles);

/// That a wall is often thinner than asked for; empty where it is not, and of what is no wall.
/// @param triangles as above
std::string thinWallWarning(const SpringNetwork& network, std::size_t triangles);

} // namespace esm
