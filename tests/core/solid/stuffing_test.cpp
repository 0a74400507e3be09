#include "core/solid/stuffing.h"

#include "tests/support/fitted_lattice.h"
#include "tests/support/sanitized.h"
#include "tests/support/solid_surfaces.h"

#include <gtest/gtest.h>

#include <map>

namespace esm {
namespace {

const std::vector<LatticeKind> allKinds{LatticeKind::Cubic, LatticeKind::BodyCentred, LatticeKind::Graded,
                                        LatticeKind::Diamond};

TEST(Stuffing, KeepsNodesInOrOnTheSurface) {
    for (const LatticeKind kind : allKinds) {
        const test::CutLattice cut = test::cutLattice(lumpySurface(30, 60), kind, 0.012);
        for (std::size_t i = 0; i < cut.lattice.nodes.size(); ++i) {
            const double distance = cut.query->nearest(cut.lattice.nodes[i]).distance;
            if (cut.lattice.isOnSurface[i])
                EXPECT_LT(distance, 1e-12);
            else
                EXPECT_TRUE(cut.query->contains(cut.lattice.nodes[i]));
        }
    }
}

TEST(Stuffing, LeavesNoTetrahedronTurnedOver) {
    for (const LatticeKind kind : allKinds)
        for (const TriangleMesh& mesh : {lumpySurface(30, 60), test::torus(), test::shell(1, 0.7)}) {
            const double spacing = boundingBox(mesh.vertices).sizes().maxCoeff() / 17;
            const test::CutLattice cut = test::cutLattice(mesh, kind, spacing);
            for (const Tetrahedron& tetrahedron : cut.lattice.tetrahedra)
                EXPECT_GT(volumeOf(tetrahedron, cut.lattice.nodes), 1e-4 * std::pow(spacing, 3));
        }
}

TEST(Stuffing, MeetsFaceToFaceAndIsClosedAtTheSurface) {
    for (const LatticeKind kind : allKinds) {
        const test::CutLattice cut = test::cutLattice(test::torus(), kind, 0.13);
        std::map<Triangle, int> faces;
        for (const Tetrahedron& t : cut.lattice.tetrahedra)
            for (Triangle face : {Triangle{t[0], t[1], t[2]}, Triangle{t[0], t[1], t[3]},
                                  Triangle{t[0], t[2], t[3]}, Triangle{t[1], t[2], t[3]}}) {
                std::sort(face.begin(), face.end());
                ++faces[face];
            }
        for (const auto& [face, count] : faces) {
            EXPECT_LE(count, 2);
            // Where a tetrahedron has no neighbour the surface is.
            for (const std::uint32_t node : face)
                EXPECT_TRUE(count == 2 || cut.lattice.isOnSurface[node]);
        }
    }
}

TEST(Stuffing, FillsABlockOfWholeCellsExactly) {
    for (const LatticeKind kind : {LatticeKind::Cubic, LatticeKind::BodyCentred}) {
        const double spacing = kind == LatticeKind::Cubic ? 0.5 : std::sqrt(3.0) / 4;
        const test::CutLattice cut = test::cutLattice(test::block({1, 2, 3}, {4, 4, 5}), kind, spacing);
        EXPECT_NEAR(test::totalVolume(cut.lattice.tetrahedra, cut.lattice.nodes), 12, 1e-9);
        for (const Tetrahedron& tetrahedron : cut.lattice.tetrahedra)
            EXPECT_GT(volumeOf(tetrahedron, cut.lattice.nodes), 0.05 * std::pow(spacing, 3));
    }
    // 7 × 5 × 5 corners.
    EXPECT_EQ(
        test::cutLattice(test::block({1, 2, 3}, {4, 4, 5}), LatticeKind::Cubic, 0.5).lattice.nodes.size(),
        175U);
}

TEST(Stuffing, ComesNearerToTheVolumeWithTheSquareOfTheSpacing) {
    if (isSanitized()) GTEST_SKIP() << "smaller bodies show the sanitizers the same";
    const TriangleMesh mesh = test::ball(1, {0, 0, 0}, 60);
    for (const LatticeKind kind : allKinds) {
        const auto lost = [&](double spacing) {
            const test::CutLattice cut = test::cutLattice(mesh, kind, spacing);
            return 1 - test::totalVolume(cut.lattice.tetrahedra, cut.lattice.nodes) / cut.bodies[0].volume;
        };
        EXPECT_LT(lost(0.1), 0.01) << wordOf(kind);
        EXPECT_LT(lost(0.05), 0.0026) << wordOf(kind);
        EXPECT_GT(lost(0.05), 0) << wordOf(kind);
    }
}

} // namespace
} // namespace esm
