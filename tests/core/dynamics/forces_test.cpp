#include "core/dynamics/forces.h"
#include "tests/support/tissue_models.h"

#include <gtest/gtest.h>

using namespace esm;
using Eigen::Vector3d;
using tissue::Vectors;

namespace {

struct Case {
    const char* name;
    Vector3d first, second, firstVelocity, secondVelocity;
    double restLength, springConstant, viscosity;
    Damping damping;
    Vector3d elastic, damped; ///< on the first node, worked out by hand
};

const std::vector<Case> cases{
    {"at rest",
     {0, 0, 0},
     {2, 0, 0},
     {0, 0, 0},
     {0, 0, 0},
     2,
     10,
     1,
     Damping::Isotropic,
     {0, 0, 0},
     {0, 0, 0}},
    {"stretched: drawn together",
     {0, 0, 0},
     {3, 0, 0},
     {0, 0, 0},
     {0, 0, 0},
     2,
     10,
     1,
     Damping::Isotropic,
     {10, 0, 0},
     {0, 0, 0}},
    {"pressed: pushed apart",
     {0, 0, 0},
     {0, 1, 0},
     {0, 0, 0},
     {0, 0, 0},
     2,
     10,
     1,
     Damping::Isotropic,
     {0, -10, 0},
     {0, 0, 0}},
    {"aslant, 3-4-5, rest length 10: c·(p1−p2)·(10/5 − 1)",
     {3, 4, 1},
     {0, 0, 1},
     {0, 0, 0},
     {0, 0, 0},
     10,
     2,
     1,
     Damping::Isotropic,
     {6, 8, 0},
     {0, 0, 0}},
    {"isotropic damping takes all of the velocity",
     {0, 0, 0},
     {2, 0, 0},
     {1, 2, 3},
     {0, 1, 1},
     2,
     10,
     4,
     Damping::Isotropic,
     {0, 0, 0},
     {-4, -4, -8}},
    {"axial damping takes what is along the spring",
     {0, 0, 0},
     {2, 0, 0},
     {1, 2, 3},
     {0, 1, 1},
     2,
     10,
     4,
     Damping::Axial,
     {0, 0, 0},
     {-4, 0, 0}},
    {"axial damping leaves a rotation alone",
     {0, 0, 0},
     {0, 0, 5},
     {1, 0, 0},
     {-1, 2, 0},
     5,
     10,
     4,
     Damping::Axial,
     {0, 0, 0},
     {0, 0, 0}},
    {"no length, no direction",
     {1, 1, 1},
     {1, 1, 1},
     {0, 0, 0},
     {0, 0, 0},
     2,
     10,
     1,
     Damping::Isotropic,
     {0, 0, 0},
     {0, 0, 0}},
    {"no length: isotropic damping stays",
     {1, 1, 1},
     {1, 1, 1},
     {1, 0, 0},
     {0, 0, 0},
     0,
     10,
     3,
     Damping::Isotropic,
     {0, 0, 0},
     {-3, 0, 0}},
    {"no length: no axis to damp along",
     {1, 1, 1},
     {1, 1, 1},
     {1, 0, 0},
     {0, 0, 0},
     0,
     10,
     3,
     Damping::Axial,
     {0, 0, 0},
     {0, 0, 0}},
};

SpringSystem oneSpring(const Case& tested) {
    TissueModel model = tissue::oneSpring({tested.springConstant, tested.viscosity, 1}, tested.restLength);
    return makeSpringSystem(model);
}

} // namespace

// [R 2.21]: f = c·(p1−p2)·(l/|p1−p2| − 1) − d·(v1−v2) on node 1, −f on node 2.
TEST(Forces, OfOneSpringFollowTheFormula) {
    for (const Case& tested : cases) {
        SCOPED_TRACE(tested.name);
        const SpringSystem system = oneSpring(tested);
        const Vectors positions{tested.first, tested.second},
            velocities{tested.firstVelocity, tested.secondVelocity};
        Vectors elastic, damped(2, Vector3d::Zero());
        elasticForces(system, positions, elastic);
        addDampingForces(system, tested.damping, positions, velocities, damped);
        EXPECT_LT((elastic[0] - tested.elastic).norm(), 1e-12) << elastic[0].transpose();
        EXPECT_LT((elastic[1] + tested.elastic).norm(), 1e-12);
        EXPECT_LT((damped[0] - tested.damped).norm(), 1e-12) << damped[0].transpose();
        EXPECT_LT((damped[1] + tested.damped).norm(), 1e-12);
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
