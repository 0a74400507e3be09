#include "core/dynamics/contact/contact.h"
#include "core/dynamics/measure/scene_run.h"
#include "core/dynamics/simulation.h"
#include "tests/support/every_integrator.h"
#include "tests/support/rounds.h"
#include "tests/support/sanitized.h"
#include "tests/support/simulation_settings.h"
#include "tests/support/tissue_models.h"
#include "tests/support/was_touched.h"

#include <gtest/gtest.h>

#include <random>

using namespace esm;
using Eigen::Vector3d;
using tissue::Vectors;

namespace {

/// m, nearest to a collider's surface of many points of every triangle; negative inside.
double clearance(const std::vector<Triangle>& surface, const Vectors& positions,
                 const PlacedCollider& collider) {
    constexpr int samples = 40;
    const ColliderAxis axis = axisOf(collider);
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [a, b, c] : surface)
        for (int i = 0; i <= samples; ++i)
            for (int j = 0; i + j <= samples; ++j) {
                const Vector3d point =
                    (i * positions[a] + j * positions[b] + (samples - i - j) * positions[c]) / samples;
                least = std::min(least, (point - axis.at(axis.nearest(point))).norm());
            }
    return least - radiusOf(collider.shape);
}

const Eigen::Quaterniond alongX(Eigen::AngleAxisd(M_PI / 2, Vector3d::UnitY()));

struct Net {
    TissueModel model;
    std::vector<Triangle> surface;
};

/// A square net of 0.1 m with its border fixed.
Net heldNet(int perSide) {
    const TriangleMesh mesh = tissue::gridMesh(perSide, 0.1);
    Net result{tissue::fromMesh(mesh, {20, 0.02, 1e-4}), mesh.triangles};
    for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i)
        if (std::abs(mesh.vertices[i].x()) > 0.0499 || std::abs(mesh.vertices[i].y()) > 0.0499)
            result.model.fixedNodes.push_back(i);
        else
            result.model.tethers.push_back({i, 1, 0.02});
    return result;
}

/// Whether a random triangle and capsule, of sizes that differ much, have a contact exactly where they meet.
TEST(ContactColliders, FindWhateverLiesInsideACapsule) {
    std::mt19937 random(seedOf(0));
    std::uniform_real_distribution<double> place(-1, 1), exponent(-2, 1);
    int inside = 0;
    for (int round = 0; round < roundsOf(1000, 100000); ++round) {
        const auto point = [&] { return Vector3d(place(random), place(random), place(random)); };
        const double size = std::pow(10, exponent(random));
        const Eigen::Quaterniond turn =
            Eigen::Quaterniond(place(random), place(random), place(random), place(random)).normalized();
        const Vectors corners{size * point(), size * point(), size * point()};
        const PlacedCollider capsule{
            Capsule{0.3 * std::pow(10, exponent(random)), 2 * std::pow(10, exponent(random))},
            {point(), turn}};
        const auto found = findContacts(TouchedSurface({{0, 1, 2}}), {0, 0, 0}, corners, corners,
                                        {{capsule.shape, capsule.pose, capsule.pose}});
        const double clear = clearance({{0, 1, 2}}, corners, capsule);
        if (clear < 0) {
            EXPECT_FALSE(found.contacts.empty()) << round;
            ++inside;
        }
        for (const Contact& contact : found.contacts)
            EXPECT_TRUE(contact.plane.normal.allFinite() && contact.plane.centre.allFinite()) << round;
    }
    EXPECT_GT(inside, 100);
}

TEST(ContactColliders, ACapsuleWithoutLengthIsASphere) {
    for (const Integrator integrator : allIntegrators) {
        SCOPED_TRACE(integratorName(integrator));
        const auto pushed = [&](const Collider& shape, const Eigen::Quaterniond& turn) {
            const Net tissue = heldNet(9);
            Simulation simulation(tissue.model, withStep(integrator, 0.0002), tissue.surface);
            for (int i = 0; i < 60; ++i) {
                Loads loads;
                loads.instruments = {{shape, {{0.003, 0.002, 0.011 - 0.0003 * i}, turn}}};
                EXPECT_TRUE(simulation.step(loads)) << simulation.failure();
            }
            return std::pair(simulation.positions(), simulation.instrumentTouches()[0].impulse);
        };
        EXPECT_EQ(pushed(Sphere{0.01}, Eigen::Quaterniond::Identity()), pushed(Capsule{0.01, 0}, alongX));
    }
}

TEST(ContactColliders, NothingIsLeftInsideACapsuleThatComesDownLiesAcrossOrTurns) {
    const Net tissue = heldNet(9); // triangles wider than the capsule
    const Capsule shaft{0.003, 0.05};
    std::vector<Integrator> tried{Integrator::Bdf2, Integrator::Split, Integrator::Euler};
    if (isSanitized()) tried.resize(1);
    for (const Integrator integrator : tried)
        for (const double tilt : {0.0, 0.4, M_PI / 2}) {
            SCOPED_TRACE(std::string(integratorName(integrator)) + " at " + std::to_string(tilt));
            const double step = integrator == Integrator::Bdf2    ? 0.002
                                : integrator == Integrator::Split ? 0.001
                                                                  : 0.0002;
            Simulation simulation(tissue.model, withStep(integrator, step), tissue.surface);
            for (double time = 0; time < 0.4; time += step) {
                const double depth = std::min(0.2, time);
                const Eigen::Quaterniond turned =
                    Eigen::AngleAxisd(4 * std::max(0.0, time - 0.2), Vector3d::UnitZ()) *
                    Eigen::AngleAxisd(tilt, Vector3d(0.2, 1, 0).normalized());
                Loads loads;
                loads.instruments = {{shaft, {{0.003, 0.002, 0.035 - 0.2 * depth}, turned}}};
                ASSERT_TRUE(simulation.step(loads)) << simulation.failure();
                ASSERT_GT(clearance(tissue.surface, simulation.positions(), loads.instruments[0]), -1e-6);
            }
            EXPECT_TRUE(wasTouched(simulation));
        }
}

TEST(ContactColliders, PartsBoundTheMotionOfATurningCapsulesTip) {
    const TriangleMesh mesh = tissue::gridMesh(5, 0.1);
    const Vectors still(mesh.vertices.size(), Vector3d::Zero());
    const ColliderMove roll{Capsule{0.01, 0.1}, {{0, 0, 0}}, {{0, 0, 0}, Eigen::Quaterniond(0, 0, 0, 1)}};
    EXPECT_EQ(contactParts(mesh.triangles, mesh.vertices, still, {roll}, 1), 1) << "about itself";
    const ColliderMove swing{Capsule{0.01, 0.1}, {{0, 0, 0}}, {{0, 0, 0}, alongX}};
    const int parts = contactParts(mesh.triangles, mesh.vertices, still, {swing}, 1);
    for (int part = 0; part < parts; ++part) {
        const ColliderMove piece =
            partOf(swing, static_cast<double>(part) / parts, static_cast<double>(part + 1) / parts);
        EXPECT_LE(mostMotion(piece.shape, piece.from, piece.to), 0.005 * (1 + 1e-9));
    }
}

/// N, of springs on fixed nodes and of tethers on tissue that rests.
Vector3d forceOfTies(const Simulation& simulation) {
    const SpringSystem& system = simulation.system();
    Vector3d force = Vector3d::Zero();
    for (const auto& spring : system.springs) {
        if (system.fixed[spring.first] == system.fixed[spring.second]) continue;
        const std::uint32_t fixed = system.fixed[spring.first] ? spring.first : spring.second,
                            free = fixed == spring.first ? spring.second : spring.first;
        const Vector3d between = simulation.positions()[fixed] - simulation.positions()[free];
        force += spring.springConstant * between * (1 - spring.restLength / between.norm());
    }
    for (const Tether& tether : system.tethers)
        force -= tether.springConstant *
                 (simulation.positions()[tether.node] - system.network->restPositions[tether.node]);
    return force;
}

struct ThirdLaw {
    Integrator integrator;
    double timeStep; ///< s
};

/// A net that is pushed, the first instrument coming from above and the second from below, and then held.
struct HeldPush {
    HeldPush(const Net& net, const ThirdLaw& law)
        : simulation(net.model, withStep(law.integrator, law.timeStep), net.surface) {}

    void stepTo(double end, const std::vector<PlacedCollider>& push) {
        while (simulation.time() < end) {
            loads.instruments = push;
            const double away = std::max(0.0, 0.2 - simulation.time() - simulation.timeStep());
            loads.instruments[0].pose.place.z() += 0.1 * away;
            if (push.size() > 1) loads.instruments[1].pose.place.z() -= 0.2 * away;
            const double start = simulation.time();
            const Vector3d before = impulse();
            ASSERT_TRUE(simulation.step(loads)) << simulation.failure();
            told += impulse() - before;
            ofTies += (simulation.time() - start) * forceOfTies(simulation);
            for (std::size_t i = 0; i < simulation.system().mass.size(); ++i)
                if (!simulation.system().fixed[i])
                    ofTies += (simulation.time() - start) * simulation.system().mass[i] * loads.gravity;
        }
    }

    Vector3d impulse() const {
        Vector3d sum = Vector3d::Zero();
        for (const InstrumentTouch& touch : simulation.instrumentTouches())
            sum += touch.impulse;
        return sum;
    }

    Simulation simulation;
    Loads loads;
    Vector3d told = Vector3d::Zero(), ofTies = Vector3d::Zero(); ///< N·s
};

class ForceOnInstruments : public testing::TestWithParam<ThirdLaw> {};

// Net at rest is held by its ties against gravity and instruments alike: all forces are in balance.
TEST_P(ForceOnInstruments, IsWhatHoldsTheTissueAgainstThem) {
    if (isSanitized() && takesShortSteps(GetParam().integrator)) GTEST_SKIP() << "too many short steps";
    const std::vector<std::vector<PlacedCollider>> pushes{
        {sphereAt({0.003, 0.002, -0.004}, 0.01)},
        {{Capsule{0.004, 0.03}, {{0.003, 0.002, -0.012}, alongX}}},
        {sphereAt({-0.02, 0.002, 0.002}, 0.01), {Capsule{0.004, 0.03}, {{0.02, 0, 0.01}, alongX}}}};
    for (const std::vector<PlacedCollider>& push : pushes)
        for (const Vector3d& gravity : {Vector3d(0, 0, 0), Vector3d(1, 0, -3)}) {
            SCOPED_TRACE(std::to_string(push.size()) + " at " + std::to_string(gravity.z()));
            HeldPush held(heldNet(11), GetParam());
            held.loads.gravity = gravity;
            held.stepTo(isSanitized() ? 1 : 3, push);
            held.told.setZero();
            held.ofTies.setZero();
            const double start = held.simulation.time();
            held.stepTo(start + 0.1, push);
            const Vector3d byTies = held.ofTies / (held.simulation.time() - start),
                           told = held.told / (held.simulation.time() - start);
            EXPECT_GT(byTies.norm(), 0.001);
            EXPECT_LT((told - byTies).norm(), 0.01 * byTies.norm())
                << "told " << told.transpose() << ", held " << byTies.transpose();
        }
}

// In steps of 10 ms `projective` is 1.6 % off where two instruments push: its passes leave a little force
// unmet.
INSTANTIATE_TEST_SUITE_P(
    Integrators, ForceOnInstruments,
    testing::Values(ThirdLaw{Integrator::Euler, 0.0002}, ThirdLaw{Integrator::Verlet, 0.0002},
                    ThirdLaw{Integrator::Heun, 0.0002}, ThirdLaw{Integrator::Rk4, 0.0002},
                    ThirdLaw{Integrator::AdamsMoulton, 0.0002}, ThirdLaw{Integrator::Trapezoid, 0.01},
                    ThirdLaw{Integrator::Split, 0.002}, ThirdLaw{Integrator::Split2, 0.002},
                    ThirdLaw{Integrator::Implicit, 0.01}, ThirdLaw{Integrator::Bdf2, 0.01},
                    ThirdLaw{Integrator::Propagation, 0.002}, ThirdLaw{Integrator::Projective, 0.002}),
    [](const auto& info) {
        std::string name = integratorName(info.param.integrator);
        std::replace(name.begin(), name.end(), '-', '_');
        return name;
    });

TEST(ContactColliders, InstrumentsThatOverlapNeitherThrowTheTissueNorLoseIt) {
    for (const Integrator integrator : allIntegrators) {
        SCOPED_TRACE(integratorName(integrator));
        const Net tissue = heldNet(9);
        Simulation simulation(tissue.model, withStep(integrator, 0.0002), tissue.surface);
        for (int i = 0; i < 60; ++i) {
            const double gap = 0.012 - 0.0003 * i;
            Loads loads;
            loads.instruments = {sphereAt({0.003, 0.002, gap}, 0.01),
                                 {Capsule{0.01, 0.02}, {{0.003, 0.002, -gap}, alongX}}};
            ASSERT_TRUE(simulation.step(loads)) << simulation.failure();
            for (const Vector3d& position : simulation.positions())
                ASSERT_LT(position.norm(), 0.2);
        }
    }
}

TEST(ContactColliders, WhatIsFixedGivesNoForceAndIsTold) {
    Net tissue = heldNet(9);
    tissue.model.tethers.clear();
    tissue.model.fixedNodes.clear();
    for (std::uint32_t i = 0; i < 81; ++i)
        tissue.model.fixedNodes.push_back(i);
    Scene scene;
    scene.duration = 0.1;
    scene.instruments = {{Capsule{0.01, 0.02}, {{0, {0, 0, 0.005}}}, {alongX}, {}}};
    const SceneOutcome outcome = runScene({tissue.model, tissue.surface, scene, {}}, {});
    EXPECT_FALSE(outcome.touched());
    EXPECT_TRUE(outcome.instruments[0].metImmovable);
    EXPECT_EQ(forceOn(0, outcome).peak, 0);
}

TEST(ContactColliders, SceneTellsForcesAtItsRecordTimes) {
    const Net tissue = heldNet(9);
    Scene scene;
    scene.duration = 0.5;
    scene.record.every = 0.1;
    scene.instruments = {{Sphere{0.01}, {{0, {0, 0, 0.02}}, {0.4, {0, 0, 0}}}, {}, {}},
                         {Sphere{0.01}, {{0, {0, 0, 1}}}, {}, "far"}};
    const SceneOutcome outcome = runScene({tissue.model, tissue.surface, scene, {}}, {});
    ASSERT_EQ(outcome.forces.size(), 6);
    EXPECT_EQ(outcome.forces[0].forces[0], Vector3d::Zero()) << "nothing has pressed yet";
    Vector3d impulse = Vector3d::Zero();
    for (std::size_t i = 1; i < outcome.forces.size(); ++i)
        impulse += (outcome.forces[i].time - outcome.forces[i - 1].time) * outcome.forces[i].forces[0];
    EXPECT_LT((impulse - outcome.instruments[0].impulse).norm(), 1e-9 * impulse.norm()) << "nothing is lost";
    EXPECT_GT(forceOn(0, outcome).peak, forceOn(0, outcome).mean);
    EXPECT_GT(outcome.forces.back().forces[0].z(), 0) << "the tissue pushes back";
    EXPECT_EQ(forceOn(1, outcome).peak, 0);
    EXPECT_FALSE(outcome.instruments[1].touched);
}

} // namespace
