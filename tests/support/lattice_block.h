#pragma once

#include "core/solid/rigidity.h"
#include "core/solid/unit_cell.h"

#include <cmath>

/// Lattices in a block, made by distances alone: they share nothing with the springs of the unit cell.
namespace esm::test {

struct LatticeBlock {
    std::vector<Eigen::Vector3d> nodes;
    std::vector<LatticeSpring> springs;
};

/// Second neighbours of a lattice: how far (in spacings), and their constant.
inline double secondConstant(LatticeKind kind) {
    return kind == LatticeKind::BodyCentred ? 2.0 / 3 : 1.0;
}
inline double secondDistance(LatticeKind kind) {
    return kind == LatticeKind::Cubic         ? std::sqrt(2.0)
           : kind == LatticeKind::BodyCentred ? 2 / std::sqrt(3.0)
                                              : std::sqrt(8.0 / 3);
}

/// Springs between all nodes as far apart as neighbours of a lattice are, and as second ones where asked for.
inline std::vector<LatticeSpring>
springsByDistance(LatticeKind kind, const std::vector<Eigen::Vector3d>& nodes, bool withSecond) {
    std::vector<LatticeSpring> springs;
    for (std::uint32_t i = 0; i < nodes.size(); ++i)
        for (std::uint32_t j = i + 1; j < nodes.size(); ++j) {
            const double distance = (nodes[i] - nodes[j]).norm();
            if (std::abs(distance - 1) < 1e-6) springs.push_back({i, j, 1});
            if (withSecond && std::abs(distance - secondDistance(kind)) < 1e-6)
                springs.push_back({i, j, secondConstant(kind)});
        }
    return springs;
}

/// All sites from 0 to `width` (in spacings) in each direction.
inline LatticeBlock latticeBlock(LatticeKind kind, double width, bool withSecond) {
    const UnitCell& cell = unitCellOf(kind);
    const int cells = static_cast<int>(width / cell.edge) + 1;
    LatticeBlock block;
    for (int x = 0; x <= cells; ++x)
        for (int y = 0; y <= cells; ++y)
            for (int z = 0; z <= cells; ++z)
                for (std::uint32_t site = 0; site < cell.sites.size(); ++site) {
                    const Eigen::Vector3d place = cell.placeOf({site, {x, y, z}});
                    if (place.maxCoeff() < width + 1e-9) block.nodes.push_back(place);
                }
    block.springs = springsByDistance(kind, block.nodes, withSecond);
    return block;
}

} // namespace esm::test
