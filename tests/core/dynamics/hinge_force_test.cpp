#include "core/dynamics/hinge_force.h"

#include "core/dynamics/forces.h"
#include "tests/support/bent_walls.h"
#include "tests/support/test_surfaces.h"

#include <gtest/gtest.h>

#include <random>

using namespace esm;
using namespace esm::test;
using Eigen::Vector3d;

namespace {

/// A curved wall, thick enough that bending counts beside stretching.
TissueModel curvedWall() {
    return wallOf(lumpySurface(8, 9), {20, 0.5, 1e-3}, 0.02);
}

Vectors disturbed(Vectors places, double size, std::uint32_t seed) {
    std::mt19937 random(seed);
    const auto number = [&] { return 2 * static_cast<double>(random()) / 4294967296.0 - 1; };
    for (Vector3d& place : places)
        place += size * Vector3d(number(), number(), number());
    return places;
}

SpringSystem hingesAlone(const TissueModel& model) {
    SpringSystem system = makeSpringSystem(model);
    system.springs.clear();
    return system;
}

double energyAt(const SpringSystem& system, const Vectors& places) {
    return energy(system, places, {}).elastic;
}

double largest(const Vectors& vectors) {
    double most = 0;
    for (const Vector3d& vector : vectors)
        most = std::max(most, vector.norm());
    return most;
}

} // namespace

TEST(HingeForce, IsNoneAtRestWhateverTheShape) {
    const TissueModel model = curvedWall();
    const SpringSystem system = hingesAlone(model);
    const Vectors& rest = model.network->restPositions;
    Vectors atRest, bent;
    elasticForces(system, rest, atRest);
    elasticForces(system, disturbed(rest, 1e-3, 1), bent);
    EXPECT_LT(largest(atRest), 1e-12 * largest(bent));
}

TEST(HingeForce, IsNoneWhereverTheWallIsTurnedTo) {
    const TissueModel model = curvedWall();
    const SpringSystem system = hingesAlone(model);
    Vectors turned = model.network->restPositions;
    for (Vector3d& node : turned)
        node = Eigen::AngleAxisd(2, Vector3d(1, 2, 3).normalized()) * node + Vector3d(3, -2, 1);
    Vectors forces, bent;
    elasticForces(system, turned, forces);
    elasticForces(system, disturbed(turned, 1e-3, 1), bent);
    EXPECT_LT(largest(forces), 1e-9 * largest(bent));
}

TEST(HingeForce, IsTheGradientOfItsEnergy) {
    const TissueModel model = curvedWall();
    const SpringSystem system = hingesAlone(model);
    const Vectors places = disturbed(model.network->restPositions, 0.01, 2);
    Vectors forces;
    elasticForces(system, places, forces);
    for (const std::size_t node : {0U, 7U, 30U, 44U})
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            constexpr double way = 1e-6;
            Vectors before = places, after = places;
            before[node][axis] -= way;
            after[node][axis] += way;
            const double slope = (energyAt(system, after) - energyAt(system, before)) / (2 * way);
            EXPECT_NEAR(forces[node][axis], -slope, 1e-6 * largest(forces));
        }
}

TEST(HingeForce, KeepsMomentumAndAngularMomentum) {
    const TissueModel model = curvedWall();
    const SpringSystem system = hingesAlone(model);
    const Vectors places = disturbed(model.network->restPositions, 0.02, 3);
    Vectors forces;
    elasticForces(system, places, forces);
    Vector3d force = Vector3d::Zero(), torque = Vector3d::Zero();
    for (std::size_t i = 0; i < forces.size(); ++i) {
        force += forces[i];
        torque += places[i].cross(forces[i]);
    }
    EXPECT_LT(force.norm(), 1e-13 * largest(forces) * static_cast<double>(forces.size()));
    EXPECT_LT(torque.norm(), 1e-13 * largest(forces) * static_cast<double>(forces.size()));
}

TEST(HingeForce, TangentIsItsChange) {
    const TissueModel model = curvedWall();
    const SpringSystem system = hingesAlone(model);
    const Vectors places = disturbed(model.network->restPositions, 0.01, 4);
    const Vectors way = disturbed(Vectors(places.size(), Vector3d::Zero()), 1, 5);
    constexpr double size = 1e-6;
    Vectors before = places, after = places, forcesBefore, forcesAfter;
    for (std::size_t i = 0; i < places.size(); ++i) {
        before[i] -= size * way[i];
        after[i] += size * way[i];
    }
    elasticForces(system, before, forcesBefore);
    elasticForces(system, after, forcesAfter);
    Vectors product(places.size(), Vector3d::Zero());
    for (const auto& hinge : system.hinges)
        addToNodes(hinge,
                   stiffnessTimes(hinge, bentHinge(hinge, ofNodes(hinge, places)), true, ofNodes(hinge, way)),
                   product);
    for (std::size_t i = 0; i < places.size(); ++i)
        EXPECT_LT((product[i] + (forcesAfter[i] - forcesBefore[i]) / (2 * size)).norm(),
                  1e-6 * largest(product));
}

// A flap of two right-angled triangles, folded at rest by any angle, opens against the stiffness it was
// given.
TEST(HingeForce, IsAsStiffAsItsHingeSaysAtAnyRestAngle) {
    for (const double angle : {0.0, 0.3, 1.0, 1.6, 2.5, -1.0}) {
        const auto corner = [](double at) { return Vector3d(0.3, -0.5 * std::cos(at), 0.5 * std::sin(at)); };
        TissueModel model = tissue::oneSpring({0, 0, 1});
        SpringNetwork network;
        network.restPositions = {{0, 0, 0}, {1, 0, 0}, {0.6, 0.7, 0}, corner(angle)};
        tissue::addSpring(network, 0, 1);
        model = tissue::model(std::move(network), {0, 0, 1});
        model.hinges = {{{0, 1, 2, 3}, 0.2, 0}};
        const SpringSystem system = makeSpringSystem(model);
        Vectors places = model.network->restPositions;
        constexpr double radians = 1e-4;
        places[3] = corner(angle + radians);
        EXPECT_NEAR(energyAt(system, places) / (0.5 * 0.2 * radians * radians), 1, 1e-3) << angle;
    }
}
