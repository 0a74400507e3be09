#pragma once

#include "core/geometry/triangle_mesh.h"

#include <cstdint>
#include <vector>

namespace esm {

class ThreadTeam;

/// The wall of a cavity laid out for stepping: its nodes have places of their own, and each place has a ring
/// of triangles. The volume V changes with a node's position by the sixth of Σ (a − x)×(b − x) over the
/// ring's sides (a, b), which is a third of the area vectors of the triangles at it: a pressure p presses the
/// node with p·∂V/∂x. Over a closed wall these add up to zero, and so do their moments.
struct CavityWall {
    struct Side {
        std::uint32_t from, to; ///< places, of the ring's triangle beside the node's own
    };

    std::vector<std::uint32_t> nodes;  ///< of the tissue, by place, rising
    std::vector<std::uint32_t> starts; ///< per place and one more: where its ring begins
    std::vector<Side> sides;           ///< one ring after the other

    /// @param triangles over the tissue's nodes, a closed surface
    explicit CavityWall(const std::vector<Triangle>& triangles);

    std::size_t size() const { return nodes.size(); }
};

/// What a wall encloses, and how that changes.
struct CavityVolume {
    double volume = 0;                     ///< m³
    std::vector<Eigen::Vector3d> gradient; ///< m², ∂V/∂x of each place
};

/// The wall's nodes by their places, m.
std::vector<Eigen::Vector3d> placesOf(const CavityWall& wall, const std::vector<Eigen::Vector3d>& positions);

/// At these places. The same to the last bit with any team, or none.
CavityVolume volumeOf(const CavityWall& wall, const std::vector<Eigen::Vector3d>& places,
                      ThreadTeam* team = nullptr);

/// ∂V/∂x of one place.
Eigen::Vector3d volumeGradientAt(const CavityWall& wall, const std::vector<Eigen::Vector3d>& places,
                                 std::uint32_t place);

/// By how much the gradient changes, m², along displacements of the places, m: ∂²V/∂x² times them.
std::vector<Eigen::Vector3d> gradientChange(const CavityWall& wall,
                                            const std::vector<Eigen::Vector3d>& places,
                                            const std::vector<Eigen::Vector3d>& displacements);

} // namespace esm
