#pragma once

#include "app/editor/workers/inside_finder.h"
#include "core/project/project.h"

#include <QString>

#include <optional>

namespace esm {

/// What a choice of the inside means; of none, a hollow organ.
QString aboutInside(const std::optional<LatticeKind>& kind);

/// Nodes, springs, tetrahedra and memory, about as many until they are made, and what a step of the motion
/// takes.
/// @param vertices of the organ
QString insideCost(const FoundInside& found, std::size_t vertices);

/// What tissue the springs of the whole organ then stand for.
QString insideFirmness(const Project& project, LatticeKind kind);

/// Where the organ leaves no room for what was asked, and what of its surface is passed over; empty where
/// there is neither, and of a wall until it is made.
/// @param triangles of the organ
QString insideNotice(const FoundInside& found, std::size_t triangles);

} // namespace esm
