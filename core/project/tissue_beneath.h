#pragma once

#include "core/project/project.h"

#include <string>

namespace esm {

/// The least and the greatest of some values.
struct ValueSpan {
    double least, most;
};

/// "16.26 N/m", "5 to 16.26 N/m".
std::string inWords(const ValueSpan& span, const std::string& unit);

/// What the nodes that a region reaches have without it: what it keeps where it sets nothing.
struct TissueBeneath {
    ValueSpan springConstant; ///< N/m, of the nodes
    ValueSpan viscosity;      ///< N·s/m, of the nodes
    double mass; ///< kg, of all these nodes, in the soft rim in proportion to the region's weight
};

/// By the base tissue and the regions that lie beneath; beneath one that is not of the project all do. None
/// where the region reaches no node.
/// @throws InvalidModel when a region sets inputs that its fuzzy system does not have
std::optional<TissueBeneath> tissueBeneath(const Project& project, const Region& region);

/// Of one parameter, with its unit.
std::string inWords(const TissueBeneath& beneath, Parameter parameter);

} // namespace esm
