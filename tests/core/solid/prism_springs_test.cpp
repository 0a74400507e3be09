#include "core/solid/prism_springs.h"

#include "tests/support/wall_balance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace esm {
namespace {

using Eigen::Vector3d;

constexpr double youngsModulus = 6000, width = 0.01; // Pa; of triangles, m
constexpr int columns = 24, rows = 8;
constexpr double length = columns * width, breadth = rows * width * 0.8660254037844386;

/// A flat strip of nearly regular triangles, along x.
TriangleMesh strip() {
    TriangleMesh mesh;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column) {
            const bool isEnd = column == 0 || column == columns;
            mesh.vertices.emplace_back(width * (column + (row % 2 == 1 && !isEnd ? 0.5 : 0)),
                                       breadth * row / rows, 0);
        }
    const auto at = [](int row, int column) {
        return static_cast<std::uint32_t>(row * (columns + 1) + column);
    };
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const std::uint32_t a = at(row, column), b = at(row, column + 1), c = at(row + 1, column),
                                d = at(row + 1, column + 1);
            mesh.triangles.push_back(row % 2 == 1 ? Triangle{a, b, d} : Triangle{a, b, c});
            mesh.triangles.push_back(row % 2 == 1 ? Triangle{a, d, c} : Triangle{b, d, c});
        }
    return mesh;
}

/// Both ends pulled apart, or turned against each other, over what a beam of the tissue resists with.
double stiffnessOf(double thickness, int layers, bool isBent) {
    const PrismWall wall =
        test::wallOfTissue(strip(), {LatticeKind::Prisms, 0, thickness, layers}, youngsModulus);
    test::WallBalance balance(wall);
    bool leadsAcross = true;
    for (std::size_t i = 0; i < wall.nodes.size(); ++i) {
        const Vector3d& place = wall.nodes[i];
        if (place.x() > 1e-9 && place.x() < length - 1e-9) continue;
        const double fromMiddle = place.z() + thickness / 2;
        balance.lead(i, 0, isBent ? (place.x() - length / 2) * fromMiddle : place.x());
        if (std::abs(place.z()) < 1e-9) balance.lead(i, 2, 0);
        if (std::exchange(leadsAcross, false)) balance.lead(i, 1, 0);
    }
    const double whole = youngsModulus * thickness * length * breadth / 2;
    return balance.energy() / (isBent ? whole * thickness * thickness / 12 : whole);
}

TEST(PrismSprings, StretchAsASheetOfTheTissue) {
    for (const double thickness : {0.001, 0.003, 0.006, 0.01})
        for (const int layers : {1, 2, 3, 4})
            EXPECT_NEAR(stiffnessOf(thickness, layers, false), 1, 0.05) << thickness << " m, " << layers;
}

TEST(PrismSprings, BendAsAPlateOfTheTissueInTwoLayersOrMore) {
    for (const double thickness : {0.001, 0.003, 0.006, 0.01}) {
        for (const int layers : {2, 3, 4, 6})
            EXPECT_NEAR(stiffnessOf(thickness, layers, true), 1, 0.03) << thickness << " m, " << layers;
        EXPECT_NEAR(stiffnessOf(thickness, 1, true), 2.85, 0.1) << thickness << " m";
    }
}

} // namespace
} // namespace esm
