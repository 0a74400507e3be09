#include "core/solid/graded_lattice.h"

#include "core/solid/filled_body.h"
#include "core/solid/lattice_elasticity.h"
#include "tests/support/sanitized.h"
#include "tests/support/solid_surfaces.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace esm {
namespace {

using Eigen::Vector3d;

constexpr int cubes = 20; ///< along each side of a block, of edge 1 m
const double spacing = std::sqrt(3.0) / 2;

FilledBody filledBlock(LatticeKind kind) {
    return fillBody(test::block({0, 0, 0}, Vector3d::Constant(cubes)), {kind, spacing});
}

/// Stretches a block by a thousandth of its width between two faces along which nodes slide, and gives the
/// modulus of an even solid that stores the same energy. The other sides are free but for one of each pair,
/// which keeps the block from moving away. Springs are those of small displacements.
double pulledModulus(const FilledBody& block) {
    constexpr double strain = 1e-3;
    const auto count = static_cast<Eigen::Index>(3 * block.nodes.size());
    std::vector<char> isGiven(static_cast<std::size_t>(count), 0);
    Eigen::VectorXd moves = Eigen::VectorXd::Zero(count);
    for (std::size_t node = 0; node < block.nodes.size(); ++node)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double place = block.nodes[node][static_cast<int>(axis)];
            const bool isEnd = axis == 0 && place > cubes - 1e-6;
            isGiven[3 * node + axis] = place < 1e-6 || isEnd;
            if (isEnd) moves[static_cast<Eigen::Index>(3 * node)] = strain * cubes;
        }
    const auto forcesAt = [&](const Eigen::VectorXd& at, double& energy) {
        Eigen::VectorXd forces = Eigen::VectorXd::Zero(count);
        energy = 0;
        for (const LatticeSpring& spring : block.springs) {
            const Eigen::Index one = 3 * Eigen::Index{spring.first}, other = 3 * Eigen::Index{spring.second};
            const Vector3d along = (block.nodes[spring.second] - block.nodes[spring.first]).normalized();
            const double longer = along.dot(at.segment<3>(other) - at.segment<3>(one));
            forces.segment<3>(one) += spring.constant * longer * along;
            forces.segment<3>(other) -= spring.constant * longer * along;
            energy += spring.constant * longer * longer / 2;
        }
        for (Eigen::Index i = 0; i < count; ++i)
            if (isGiven[static_cast<std::size_t>(i)]) forces[i] = 0;
        return forces;
    };
    // Conjugate gradients, of which each product is a pass over the springs.
    double energy = 0, unused = 0;
    Eigen::VectorXd left = forcesAt(moves, energy), way = left;
    const double enough = 1e-6 * left.norm();
    for (int step = 0; step < 1000 && left.norm() > enough; ++step) {
        const Eigen::VectorXd product = -forcesAt(way, unused);
        const double part = left.squaredNorm() / way.dot(product);
        moves += part * way;
        const Eigen::VectorXd next = left - part * product;
        way = next + next.squaredNorm() / left.squaredNorm() * way;
        left = next;
    }
    forcesAt(moves, energy);
    return energy / (strain * strain / 2 * std::pow(cubes, 3));
}

TEST(GradedLattice, IsAsFirmAsAnEvenOneWithFarFewerNodes) {
    if (isSanitized()) GTEST_SKIP() << "smaller bodies show the sanitizers the same";
    const FilledBody even = filledBlock(LatticeKind::BodyCentred), graded = filledBlock(LatticeKind::Graded);
    EXPECT_LT(graded.nodes.size(), 0.65 * static_cast<double>(even.nodes.size()));
    const double wanted = relativeModulus(LatticeKind::BodyCentred) / spacing;
    EXPECT_NEAR(pulledModulus(even) / wanted, 1, 0.01);
    EXPECT_NEAR(pulledModulus(graded) / wanted, 1, 0.025);
}

TEST(GradedLattice, IsTheEvenOneWhereNothingIsDeepEnough) {
    const TriangleMesh plate = test::block({0, 0, 0}, {8, 8, 3});
    const FilledBody even = fillBody(plate, {LatticeKind::BodyCentred, spacing}),
                     graded = fillBody(plate, {LatticeKind::Graded, spacing});
    EXPECT_EQ(graded.nodes.size(), even.nodes.size());
    ASSERT_EQ(graded.springs.size(), even.springs.size());
    const auto constantsOf = [](const FilledBody& body) {
        std::vector<double> constants;
        for (const LatticeSpring& spring : body.springs)
            constants.push_back(spring.constant);
        std::sort(constants.begin(), constants.end());
        return constants;
    };
    const std::vector<double> ofEven = constantsOf(even), ofGraded = constantsOf(graded);
    for (std::size_t i = 0; i < ofEven.size(); ++i)
        EXPECT_NEAR(ofGraded[i], ofEven[i], 0.01); // of even ones shares are sampled
}

TEST(GradedLattice, HasNoFloppyModes) {
    const FilledBody graded = filledBlock(LatticeKind::Graded);
    const Rigidity rigidity = rigidityOf(graded.nodes, graded.springs);
    EXPECT_EQ(rigidity.bodies, 1U);
    EXPECT_EQ(rigidity.floppyModes, 0U);
}

TEST(GradedLattice, HasAsManyNodesAsIsSaidBefore) {
    if (isSanitized()) GTEST_SKIP() << "smaller bodies show the sanitizers the same";
    for (const TriangleMesh& mesh :
         {lumpySurface(60, 120), test::torus(48, 24), test::ball(1, {0, 0, 0}, 40)})
        for (const double nodes : {3000.0, 20'000.0}) {
            const LatticeFilling filling = fillingOf(mesh, LatticeKind::Graded, nodes);
            const auto count = static_cast<double>(fillBody(mesh, filling).nodes.size());
            EXPECT_NEAR(count / nodes, 1.1, 0.15); // spacings of two digits
            EXPECT_NEAR(estimateLattice(mesh, filling).nodes / count, 1, 0.1);
        }
}

TEST(GradedLattice, KnowsHowDeepABallIs) {
    const std::vector<ClosedBody> bodies = closedBodiesOf(test::ball(1, {0, 0, 0}, 40));
    const std::vector<double> depths = depthsWithin(bodies[0], 4096);
    ASSERT_GT(depths.size(), 1000U);
    for (const double depth : {0.1, 0.3, 0.5}) {
        const auto deeper = depths.end() - std::lower_bound(depths.begin(), depths.end(), depth);
        EXPECT_NEAR(static_cast<double>(deeper) / static_cast<double>(depths.size()), std::pow(1 - depth, 3),
                    0.02);
    }
}

} // namespace
} // namespace esm
