#include "core/solid/unit_cell.h"

#include "tests/support/lattice_block.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <set>

namespace esm {
namespace {

class UnitCellOf : public testing::TestWithParam<LatticeKind> {
protected:
    const UnitCell& m_cell = unitCellOf(GetParam());
};

TEST_P(UnitCellOf, IsFilledByItsTetrahedra) {
    double volume = 0;
    for (const CellTetrahedron& tetrahedron : m_cell.tetrahedra) {
        EXPECT_GT(tetrahedron.volume, 0);
        volume += tetrahedron.volume;
    }
    EXPECT_NEAR(volume, std::pow(m_cell.edge, 3), 1e-12);
}

/// A face by its corners' places, rounded, within a cell of the periodic lattice.
std::array<std::array<long, 3>, 3> faceKey(const UnitCell& cell, const CellTetrahedron& tetrahedron,
                                           std::size_t opposite) {
    std::vector<Eigen::Vector3d> corners;
    for (std::size_t i = 0; i < 4; ++i)
        if (i != opposite) corners.push_back(cell.placeOf(tetrahedron.corners[i]) / cell.edge);
    const Eigen::Vector3d middle = (corners[0] + corners[1] + corners[2]) / 3;
    const Eigen::Vector3d origin = (middle.array() + 1e-6).floor();
    std::array<std::array<long, 3>, 3> key;
    for (std::size_t i = 0; i < 3; ++i)
        for (int axis = 0; axis < 3; ++axis)
            key[i][static_cast<std::size_t>(axis)] = std::lround(1000 * (corners[i] - origin)[axis]);
    std::sort(key.begin(), key.end());
    return key;
}

TEST_P(UnitCellOf, HasTetrahedraThatMeetFaceToFace) {
    std::map<std::array<std::array<long, 3>, 3>, int> faces;
    for (const CellTetrahedron& tetrahedron : m_cell.tetrahedra)
        for (std::size_t opposite = 0; opposite < 4; ++opposite)
            ++faces[faceKey(m_cell, tetrahedron, opposite)];
    for (const auto& [face, count] : faces)
        EXPECT_EQ(count, 2);
}

TEST_P(UnitCellOf, HasTheSpringsThatDistancesTell) {
    const bool withSecond = GetParam() != LatticeKind::BareDiamond;
    std::vector<Eigen::Vector3d> nodes;
    for (int place = 0; place < 27; ++place)
        for (std::uint32_t site = 0; site < m_cell.sites.size(); ++site)
            nodes.push_back(m_cell.placeOf({site, {place % 3 - 1, place / 3 % 3 - 1, place / 9 - 1}}));
    const auto first = static_cast<std::uint32_t>(13 * m_cell.sites.size());
    double expected = 0;
    for (const LatticeSpring& spring : test::springsByDistance(GetParam(), nodes, withSecond))
        for (const std::uint32_t node : {spring.first, spring.second})
            if (node >= first && node < first + m_cell.sites.size()) expected += spring.constant / 2;
    const double found =
        std::accumulate(m_cell.springs.begin(), m_cell.springs.end(), 0.0,
                        [](double sum, const CellSpring& spring) { return sum + spring.constant; });
    EXPECT_NEAR(found, expected, 1e-9);
}

TEST_P(UnitCellOf, SharesEachSpringOutWhole) {
    std::map<std::array<long, 6>, double> shares;
    for (const CellTetrahedron& tetrahedron : m_cell.tetrahedra)
        for (const SpringShare& share : tetrahedron.shares) {
            EXPECT_GT(share.constant, 0);
            EXPECT_NEAR((m_cell.placeOf(share.second) - m_cell.placeOf(share.first)).norm(), share.length,
                        1e-12);
            const Eigen::Vector3i way = share.second.cell - share.first.cell;
            shares[{share.first.site, share.second.site, way.x(), way.y(), way.z(), 0}] += share.constant;
        }
    ASSERT_EQ(shares.size(), m_cell.springs.size());
    for (const CellSpring& spring : m_cell.springs) {
        const Eigen::Vector3i way = spring.second.cell;
        const auto found = shares.find({spring.first, spring.second.site, way.x(), way.y(), way.z(), 0});
        ASSERT_NE(found, shares.end());
        EXPECT_NEAR(found->second, spring.constant, 1e-9);
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, UnitCellOf,
                         testing::Values(LatticeKind::Cubic, LatticeKind::BodyCentred, LatticeKind::Diamond,
                                         LatticeKind::BareDiamond),
                         [](const auto& info) {
                             std::string name = wordOf(info.param);
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

TEST(UnitCell, OfBodyCentredSharesSpringsByTheAngleAroundThem) {
    // All tetrahedra are congruent: six meet at a spring to a nearest neighbour, four at one along an axis.
    for (const CellTetrahedron& tetrahedron : unitCellOf(LatticeKind::BodyCentred).tetrahedra) {
        ASSERT_EQ(tetrahedron.shares.size(), 6U);
        for (const SpringShare& share : tetrahedron.shares)
            EXPECT_NEAR(share.constant, 1.0 / 6, 1e-9);
    }
}

TEST(UnitCell, HoldsAsManyNodesAsItsDensitySays) {
    EXPECT_NEAR(unitCellOf(LatticeKind::Cubic).density(), 1, 1e-12);
    EXPECT_NEAR(unitCellOf(LatticeKind::BodyCentred).density(), 2 / std::pow(2 / std::sqrt(3.0), 3), 1e-12);
    EXPECT_NEAR(unitCellOf(LatticeKind::Diamond).density(), 8 / std::pow(4 / std::sqrt(3.0), 3), 1e-12);
}

} // namespace
} // namespace esm
