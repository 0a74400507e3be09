#pragma once

#include "core/model/tissue_model.h"

#include <cstddef>
#include <vector>

namespace esm {

/// A node that the surrounding tissue can hold, and over how much of the surface, over the mean of them.
struct OuterNode {
    std::uint32_t node;
    double size;
};
/// In order: all nodes of a surface, each as much as any other, or of an even sheet by its area; of a lattice
/// those at its surface, by a third of the area around them; of a wall those of its outer side.
std::vector<OuterNode> outerNodes(const SpringNetwork& network);

/// The tethers of a rule: at the first node that they can hold and at each `every`-th after it, each as
/// strong as its node has surface.
std::vector<Tether> tethersOf(const TetherRule& rule, const std::vector<OuterNode>& outer);
/// How many those are of so many nodes.
std::size_t tetherCount(const TetherRule& rule, std::size_t outerNodes);
/// How many a scene's rules make.
std::size_t tetherCountOf(const SpringNetwork& network, const Scene& scene);

/// The rule that holds an organ of other nodes as strongly altogether: what tethers hold it with is their
/// number times their constant.
TetherRule asStrong(TetherRule rule, std::size_t outerBefore, std::size_t outerAfter);

/// The part of a spring's constant and viscosity for a tether at each node with which a poke takes along the
/// same part of the organ however fine its mesh is. Precondition: the network has springs.
/// @param mesh that is drawn, whose area and size are those of the organ
double tetherShare(const SpringNetwork& network, const TriangleMesh& mesh);

/// Tethers of a share of these constants at each node, or every third node with three times as much.
/// @param springConstant N/m
/// @param viscosity N·s/m
TetherRule defaultTethers(const SpringNetwork& network, double share, double springConstant,
                          double viscosity);

} // namespace esm
