#include "core/solid/lattice_springs.h"

#include "core/solid/lattice_elasticity.h"
#include "tests/support/fitted_lattice.h"
#include "tests/support/solid_surfaces.h"

#include <gtest/gtest.h>

#include <set>

namespace esm {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Energy of springs at rest under a small uniform strain.
double energyOf(const std::vector<FittedSpring>& springs, const std::vector<Vector3d>& nodes,
                const Matrix3d& strain) {
    double energy = 0;
    for (const auto& [spring, latticeLength] : springs) {
        const Vector3d along = nodes[spring.second] - nodes[spring.first];
        const double lengthening = along.normalized().dot(strain * along);
        energy += spring.constant * lengthening * lengthening / 2;
    }
    return energy;
}

Matrix3d strainOf(int number) {
    Matrix3d strain = Matrix3d::Zero();
    if (number < 3) {
        strain(number, number) = 1;
    } else {
        const int one = number - 3, other = (one + 1) % 3;
        strain(one, other) = strain(other, one) = 0.5;
    }
    return strain;
}

TEST(LatticeSprings, AreThoseOfTheLatticeInABlockOfWholeCells) {
    // At the surface half of the tissue around a spring is missing, along an edge three quarters.
    const test::CutLattice cut = test::cutLattice(test::block({0, 0, 0}, {4, 4, 4}), LatticeKind::Cubic, 1);
    const auto springs = fittedSprings(cut.background, cut.lattice);
    const auto sidesOf = [](const Vector3d& a, const Vector3d& b) {
        int sides = 0;
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {0.0, 4.0})
                sides += std::abs(a[axis] - side) < 1e-9 && std::abs(b[axis] - side) < 1e-9;
        return sides;
    };
    EXPECT_EQ(springs.size(), 3U * 100 + 6 * 80); // edges and both diagonals of every square
    for (const auto& [spring, latticeLength] : springs) {
        const Vector3d &a = cut.lattice.nodes[spring.first], &b = cut.lattice.nodes[spring.second];
        EXPECT_NEAR((a - b).norm(), latticeLength, 1e-9);
        EXPECT_NEAR(spring.constant, std::pow(0.5, sidesOf(a, b)), 0.005);
    }
}

TEST(LatticeSprings, StoreTheEnergyOfTheSolidThatTheyStandFor) {
    // Of a whole body, cut as its surface happens to run, under each strain. A uniform strain of all nodes is
    // no equilibrium in diamond, whose two kinds of nodes would shift. Between cubes of two widths the energy
    // is right in the mean of all strains alone.
    for (const LatticeKind kind : {LatticeKind::Cubic, LatticeKind::BodyCentred, LatticeKind::Graded})
        for (const auto& [spacing, slack] : {std::pair(0.012, 0.04), std::pair(0.006, 0.02)}) {
            const test::CutLattice cut = test::cutLattice(lumpySurface(30, 60), kind, spacing);
            const auto springs = fittedSprings(cut.background, cut.lattice);
            const double volume = test::totalVolume(cut.lattice.tetrahedra, cut.lattice.nodes);
            for (int number = 0; number < 6; ++number) {
                const double expected = elasticityOf(kind).tensor(number, number) / spacing / 2 * volume;
                EXPECT_NEAR(energyOf(springs, cut.lattice.nodes, strainOf(number)) / expected, 1,
                            kind == LatticeKind::Graded ? 0.04 : slack)
                    << wordOf(kind) << " " << spacing << " strain " << number;
            }
        }
}

TEST(LatticeSprings, OfOneConstantWouldMissThatEnergy) {
    // What the constants are for: with 1 for every spring the surface is far too stiff.
    const test::CutLattice cut = test::cutLattice(lumpySurface(30, 60), LatticeKind::BodyCentred, 0.012);
    auto springs = fittedSprings(cut.background, cut.lattice);
    const double volume = test::totalVolume(cut.lattice.tetrahedra, cut.lattice.nodes);
    for (FittedSpring& spring : springs)
        spring.spring.constant = 1;
    const double expected = elasticityOf(LatticeKind::BodyCentred).tensor(0, 0) / 0.012 / 2 * volume;
    EXPECT_GT(energyOf(springs, cut.lattice.nodes, strainOf(0)) / expected, 1.3);
}

TEST(LatticeSprings, AreThereForEveryEdgeOfATetrahedron) {
    for (const LatticeKind kind : {LatticeKind::Cubic, LatticeKind::BodyCentred, LatticeKind::Graded}) {
        const test::CutLattice cut = test::cutLattice(test::torus(), kind, 0.13);
        std::set<Edge> springs;
        for (const auto& [spring, latticeLength] : fittedSprings(cut.background, cut.lattice)) {
            EXPECT_LT(spring.first, spring.second);
            EXPECT_TRUE(springs.insert({spring.first, spring.second}).second) << "twice";
        }
        for (const Tetrahedron& nodes : cut.lattice.tetrahedra)
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t j = i + 1; j < 4; ++j)
                    EXPECT_TRUE(springs.count(std::minmax(nodes[i], nodes[j])));
    }
}

} // namespace
} // namespace esm
