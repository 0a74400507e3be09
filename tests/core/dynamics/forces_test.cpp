#include "core/dynamics/forces.h"
#include "tests/support/tissue_models.h"

#include <gtest/gtest.h>

using namespace esm;
using Eigen::Vector3d;
using tissue::Vectors;

namespace {

struct ElasticCase {
    const char* name;
    Vector3d first, second;
    double restLength, springConstant;
    Vector3d force; ///< on the first node, worked out by hand
};

const std::vector<ElasticCase> elasticCases{
    {"at rest", {0, 0, 0}, {2, 0, 0}, 2, 10, {0, 0, 0}},
    {"stretched: drawn together", {0, 0, 0}, {3, 0, 0}, 2, 10, {10, 0, 0}},
    {"pressed: pushed apart", {0, 0, 0}, {0, 1, 0}, 2, 10, {0, -10, 0}},
    {"aslant, 3-4-5: c·(p1−p2)·(10/5 − 1)", {3, 4, 1}, {0, 0, 1}, 10, 2, {6, 8, 0}},
    {"no length, no direction", {1, 1, 1}, {1, 1, 1}, 2, 10, {0, 0, 0}},
    {"no length, none at rest", {1, 1, 1}, {1, 1, 1}, 0, 10, {0, 0, 0}},
};

struct DampingCase {
    const char* name;
    Damping damping;
    Vector3d second, firstVelocity, secondVelocity; ///< the first node is at the origin
    double viscosity;
    Vector3d force; ///< on the first node, worked out by hand
};

const std::vector<DampingCase> dampingCases{
    {"at rest", Damping::Isotropic, {2, 0, 0}, {0, 0, 0}, {0, 0, 0}, 1, {0, 0, 0}},
    {"isotropic: all of it", Damping::Isotropic, {2, 0, 0}, {1, 2, 3}, {0, 1, 1}, 4, {-4, -4, -8}},
    {"axial: along the spring", Damping::Axial, {2, 0, 0}, {1, 2, 3}, {0, 1, 1}, 4, {-4, 0, 0}},
    {"axial: not a rotation", Damping::Axial, {0, 0, 5}, {1, 0, 0}, {-1, 2, 0}, 4, {0, 0, 0}},
    {"no length: isotropic stays", Damping::Isotropic, {0, 0, 0}, {1, 0, 0}, {0, 0, 0}, 3, {-3, 0, 0}},
    {"no length: no axis to damp along", Damping::Axial, {0, 0, 0}, {1, 0, 0}, {0, 0, 0}, 3, {0, 0, 0}},
};

void expectOppositePair(const Vectors& forces, const Vector3d& onFirst) {
    EXPECT_LT((forces[0] - onFirst).norm(), 1e-12) << forces[0].transpose();
    EXPECT_LT((forces[1] + onFirst).norm(), 1e-12) << forces[1].transpose();
}

} // namespace

// [R 2.21]: f = c·(p1−p2)·(l/|p1−p2| − 1) − d·(v1−v2) on node 1, −f on node 2.
TEST(Forces, OfOneSpringAreElastic) {
    for (const ElasticCase& tested : elasticCases) {
        SCOPED_TRACE(tested.name);
        const TissueModel model = tissue::oneSpring({tested.springConstant, 1, 1}, tested.restLength);
        Vectors forces;
        elasticForces(makeSpringSystem(model), {tested.first, tested.second}, forces);
        expectOppositePair(forces, tested.force);
    }
}

TEST(Forces, OfOneSpringDampItsMotion) {
    for (const DampingCase& tested : dampingCases) {
        SCOPED_TRACE(tested.name);
        const TissueModel model = tissue::oneSpring({10, tested.viscosity, 1}, tested.second.norm());
        Vectors forces(2, Vector3d::Zero());
        addDampingForces(makeSpringSystem(model), tested.damping, {Vector3d::Zero(), tested.second},
                         {tested.firstVelocity, tested.secondVelocity}, forces);
        expectOppositePair(forces, tested.force);
    }
}

TEST(Forces, OfATetherPullToTheRestPosition) {
    TissueModel model = tissue::oneSpring({0, 0, 1});
    model.tethers = {{1, 5, 2}};
    const SpringSystem system = makeSpringSystem(model);
    const Vectors positions{{0, 0, 0}, {1, 3, 0}}, velocities{{9, 9, 9}, {0, 0, 4}};
    Vectors forces;
    elasticForces(system, positions, forces);
    EXPECT_EQ(forces[0], Vector3d(0, 0, 0));
    EXPECT_EQ(forces[1], Vector3d(0, -15, 0));
    addDampingForces(system, Damping::Isotropic, positions, velocities, forces);
    EXPECT_EQ(forces[0], Vector3d(0, 0, 0));
    EXPECT_EQ(forces[1], Vector3d(0, -15, -8));
}

TEST(Forces, AreTheSlopeOfTheEnergy) {
    TissueModel model = tissue::fromMesh(tissue::sphereMesh(1, 0.05), {10, 0.1, 0.001});
    model.tethers = {{3, 4, 0}, {17, 50, 0}};
    for (std::size_t i = 0; i < model.mass.size(); ++i)
        model.springConstant[i] += static_cast<double>(i);
    const SpringSystem system = makeSpringSystem(model);
    Vectors positions = model.network->restPositions;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const auto n = static_cast<double>(i);
        positions[i] += 0.02 * Vector3d(std::sin(3 * n), std::cos(5 * n), std::sin(7 * n + 1));
    }
    const Vectors still(positions.size(), Vector3d::Zero());
    Vectors forces;
    elasticForces(system, positions, forces);
    constexpr double step = 1e-6;
    for (std::size_t i = 0; i < positions.size(); ++i)
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            Vectors forward = positions, back = positions;
            forward[i][axis] += step;
            back[i][axis] -= step;
            const double slope =
                (energy(system, forward, still).elastic - energy(system, back, still).elastic) / (2 * step);
            EXPECT_NEAR(forces[i][axis], -slope, 1e-6) << i;
        }
}

TEST(Energy, OfMotionIsHalfTheMassTimesTheSquaredSpeed) {
    const TissueModel model = tissue::oneSpring({10, 1, 3});
    const Energy result = energy(makeSpringSystem(model), {{0, 0, 0}, {1.5, 0, 0}}, {{2, 0, 0}, {0, 1, 0}});
    EXPECT_DOUBLE_EQ(result.kinetic, 0.5 * 3 * (4 + 1));
    EXPECT_DOUBLE_EQ(result.elastic, 0.5 * 10 * 0.25);
    EXPECT_DOUBLE_EQ(result.total(), result.kinetic + result.elastic);
}

TEST(ForceOn, IsWhatAHandBearsThatHoldsSomeNodes) {
    SpringNetwork network;
    for (const double x : {0, 1, 2, 3})
        network.restPositions.emplace_back(0.1 * x, 0, 0);
    for (const std::size_t node : {0U, 1U, 2U})
        tissue::addSpring(network, node, node + 1);
    TissueModel model = tissue::model(std::move(network), {20, 3, 0.001});
    model.tethers = {{1, 5, 2}};
    const SpringSystem system = makeSpringSystem(model);
    Motion motion{model.network->restPositions, Vectors(4, Vector3d::Zero())};
    EXPECT_LT(forceOn({1, 2}, system, Damping::Isotropic, motion).norm(), 1e-12);
    for (const std::uint32_t node : {1U, 2U})
        motion.positions[node].y() += 0.3;
    motion.velocities[1].y() = 0.5;
    motion.velocities[2].y() = 0.5;
    Vectors forces;
    elasticForces(system, motion.positions, forces);
    addDampingForces(system, Damping::Isotropic, motion.positions, motion.velocities, forces);
    EXPECT_LT((forceOn({1, 2}, system, Damping::Isotropic, motion) - forces[1] - forces[2]).norm(), 1e-12);
    EXPECT_LT(forceOn({1, 2}, system, Damping::Isotropic, motion).y(), -1) << "drawn back, and held up";
    EXPECT_LT((forceOn({3}, system, Damping::Isotropic, motion) - forces[3]).norm(), 1e-12);
}
