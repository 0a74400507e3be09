#include "core/solid/trimming.h"

#include "tests/support/fitted_lattice.h"
#include "tests/support/solid_surfaces.h"

#include <gtest/gtest.h>

namespace esm {
namespace {

using Eigen::Vector3d;

/// A block with a slot from above, so wide, between x = −width/2 and width/2: a U.
TriangleMesh slotted(double width) {
    const double w = width / 2;
    const std::vector<Vector3d> outline{{-3, 0, 0}, {3, 0, 0},  {3, 4, 0},  {w, 4, 0},
                                        {w, 1, 0},  {-w, 1, 0}, {-w, 4, 0}, {-3, 4, 0}};
    TriangleMesh mesh;
    for (const double z : {0.0, 3.0})
        for (const Vector3d& corner : outline)
            mesh.vertices.emplace_back(corner.x(), corner.y(), z);
    const auto quadrangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
    };
    for (std::uint32_t i = 0; i < 8; ++i)
        quadrangle(i, (i + 1) % 8, (i + 1) % 8 + 8, i + 8);
    for (const Triangle& t : {Triangle{0, 5, 1}, Triangle{1, 5, 4}, Triangle{1, 4, 2}, Triangle{2, 4, 3},
                              Triangle{0, 7, 5}, Triangle{5, 7, 6}}) {
        mesh.triangles.push_back(t);
        mesh.triangles.push_back({t[0] + 8, t[2] + 8, t[1] + 8});
    }
    return mesh;
}

TEST(LeavingTheBody, IsCrossingAGapHoweverNarrow) {
    for (const double width : {1.5, 0.3, 0.01}) {
        const std::vector<ClosedBody> bodies = closedBodiesOf(slotted(width));
        const BodyQuery query(bodies[0]);
        const Vector3d left(-1, 3, 1.4), right(1, 2.9, 1.5), leftWall(-width / 2, 3, 1.4),
            rightWall(width / 2, 3, 1.4);
        EXPECT_TRUE(leavesBody(query, {left, right, true}, 0.25)) << width;
        EXPECT_TRUE(leavesBody(query, {left, rightWall, true}, 0.25)) << width;
        EXPECT_TRUE(leavesBody(query, {leftWall, right, false}, 0.25)) << width;
        EXPECT_TRUE(leavesBody(query, {leftWall, rightWall, false}, 0.25)) << width;
        // Below the slot, and along a wall.
        EXPECT_FALSE(leavesBody(query, {{-1, 0.5, 1}, {1, 0.5, 1}, true}, 0.25)) << width;
        EXPECT_FALSE(leavesBody(query, {leftWall, {-width / 2, 2, 1}, false}, 0.25)) << width;
    }
}

TEST(LeavingTheBody, IsNotAChordOverADent) {
    // The wall of a ball's cavity bends inwards: a chord of length l on radius r is outside by l²/(8r).
    const std::vector<ClosedBody> bodies = closedBodiesOf(test::shell(2, 1));
    const BodyQuery query(bodies[0]);
    const auto onWall = [&](double angle) {
        return query.placeOf(query.nearest({std::cos(angle), std::sin(angle), 0.02}));
    };
    EXPECT_FALSE(leavesBody(query, {onWall(0.1), onWall(0.6), false}, 0.125));
    EXPECT_TRUE(leavesBody(query, {onWall(0.1), onWall(2.1), false}, 0.125));
}

TEST(Trimming, PartsTheWallsOfAGapThatIsNarrowerThanTheSpacing) {
    for (const LatticeKind kind :
         {LatticeKind::Cubic, LatticeKind::BodyCentred, LatticeKind::Graded, LatticeKind::Diamond}) {
        test::CutLattice cut = test::cutLattice(slotted(0.05), kind, 0.31);
        trim(cut.lattice, std::vector<char>(cut.lattice.nodes.size(), 1), *cut.query, 0.08, {});
        ASSERT_GT(cut.lattice.tetrahedra.size(), 1000U);
        for (const Tetrahedron& nodes : cut.lattice.tetrahedra) {
            // Above the slot's ground no tetrahedron has nodes on both sides.
            bool isLeft = false, isRight = false, isAbove = true;
            for (const std::uint32_t node : nodes) {
                isLeft = isLeft || cut.lattice.nodes[node].x() < -0.02;
                isRight = isRight || cut.lattice.nodes[node].x() > 0.02;
                isAbove = isAbove && cut.lattice.nodes[node].y() > 1.01;
            }
            EXPECT_FALSE(isLeft && isRight && isAbove) << wordOf(kind);
        }
        // Both arms are still there.
        const double volume = test::totalVolume(cut.lattice.tetrahedra, cut.lattice.nodes);
        EXPECT_GT(volume, 0.9 * cut.bodies[0].volume);
    }
}

TEST(Trimming, ChangesNothingWhereTheSpacingResolvesTheBody) {
    test::CutLattice cut = test::cutLattice(test::torus(48, 24), LatticeKind::BodyCentred, 0.05);
    const StuffedLattice before = cut.lattice;
    trim(cut.lattice, std::vector<char>(cut.lattice.nodes.size(), 1), *cut.query, 0.0125, {});
    EXPECT_EQ(cut.lattice.tetrahedra, before.tetrahedra);
    EXPECT_EQ(cut.lattice.nodes, before.nodes);
}

TEST(DeepestChord, GrowsWithTheLongestSpring) {
    EXPECT_NEAR(deepestChord(LatticeKind::BodyCentred, 2), 0.5, 1e-6);
    EXPECT_NEAR(deepestChord(LatticeKind::Cubic, 2), 0.5 * std::sqrt(1.5), 1e-6);
    EXPECT_NEAR(deepestChord(LatticeKind::Diamond, 2), 0.5 * std::sqrt(2), 1e-6);
    EXPECT_EQ(deepestChord(LatticeKind::BareDiamond, 2), deepestChord(LatticeKind::Diamond, 2));
}

} // namespace
} // namespace esm
