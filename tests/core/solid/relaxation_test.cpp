#include "core/solid/relaxation.h"

#include "tests/support/fitted_lattice.h"
#include "tests/support/solid_surfaces.h"

#include <gtest/gtest.h>

#include <numeric>

namespace esm {
namespace {

TEST(Relaxation, LeavesALatticeAtRestAsItIs) {
    test::CutLattice cut = test::cutLattice(test::block({0, 0, 0}, {4, 4, 4}), LatticeKind::Cubic, 1);
    const std::vector<Eigen::Vector3d> before = cut.lattice.nodes;
    relax(cut.lattice, fittedSprings(cut.background, cut.lattice), *cut.query, 1, {});
    EXPECT_EQ(cut.lattice.nodes, before);
}

TEST(Relaxation, EvensOutSpringsAndSpoilsNoTetrahedron) {
    for (const LatticeKind kind :
         {LatticeKind::Cubic, LatticeKind::BodyCentred, LatticeKind::Graded, LatticeKind::Diamond}) {
        const double spacing = 0.01;
        test::CutLattice cut = test::cutLattice(lumpySurface(30, 60), kind, spacing);
        const auto springs = fittedSprings(cut.background, cut.lattice);
        const std::vector<Eigen::Vector3d> before = cut.lattice.nodes;
        const auto stretch = [&] { // of lattice springs, squares summed up
            double sum = 0;
            for (const auto& [spring, length] : springs)
                if (length > 0)
                    sum +=
                        spring.constant *
                        std::pow((cut.lattice.nodes[spring.first] - cut.lattice.nodes[spring.second]).norm() -
                                     length,
                                 2);
            return sum;
        };
        const double tense = stretch();
        relax(cut.lattice, springs, *cut.query, spacing, {});
        EXPECT_LT(stretch(), 0.7 * tense) << wordOf(kind);
        for (const Tetrahedron& nodes : cut.lattice.tetrahedra)
            EXPECT_GE(shapeOf(nodes, cut.lattice.nodes), std::min(0.3, shapeOf(nodes, before)) - 1e-12);
        for (std::size_t i = 0; i < before.size(); ++i)
            if (cut.lattice.isOnSurface[i]) {
                EXPECT_LT(cut.query->nearest(cut.lattice.nodes[i]).distance, 1e-12);
            }
    }
}

TEST(Shape, IsOneForARegularTetrahedron) {
    const std::vector<Eigen::Vector3d> nodes{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    const double sign = volumeOf({0, 1, 2, 3}, nodes) > 0 ? 1 : -1;
    EXPECT_NEAR(shapeOf({0, 1, 2, 3}, nodes), sign, 1e-12);
    EXPECT_NEAR(shapeOf({1, 0, 2, 3}, nodes), -sign, 1e-12);
    EXPECT_NEAR(shapeOf({0, 1, 2, 2}, nodes), 0, 1e-12);
}

} // namespace
} // namespace esm
