#include "core/dynamics/kernel/tissue_kernel.h"

#include "core/dynamics/forces.h"
#include "tests/core/dynamics/kernel/networks.h"

#include <gtest/gtest.h>

using namespace esm;
using Eigen::Vector3d;
using network::Contents;

namespace {

const Vector3d gravity(0.3, -9.81, 0.1); ///< m/s²

std::vector<InstructionSet> instructionSets() {
    if (bestInstructionSet() == InstructionSet::V2) return {InstructionSet::V2};
    return {InstructionSet::V2, InstructionSet::V3};
}

/// By the scalar forces, springs in their own order.
Vectors referenceAccelerations(const SpringSystem& system, Damping damping, const Motion& motion) {
    Vectors result;
    elasticForces(system, motion.positions, result);
    addDampingForces(system, damping, motion.positions, motion.velocities, result);
    for (std::size_t i = 0; i < result.size(); ++i) {
        result[i] = result[i] / system.mass[i] + gravity;
        if (system.fixed[i]) result[i].setZero();
    }
    return result;
}

Motion referenceStep(const SpringSystem& system, Damping damping, const Motion& motion, double timeStep) {
    const Vectors accelerations = referenceAccelerations(system, damping, motion);
    Motion next = motion;
    for (std::size_t i = 0; i < next.positions.size(); ++i) {
        next.velocities[i] += timeStep * accelerations[i];
        next.positions[i] += timeStep * next.velocities[i];
    }
    return next;
}

double largest(const Vectors& values) {
    double result = 0;
    for (const Vector3d& value : values)
        result = std::max(result, value.norm());
    return result;
}

/// Relative to the largest of `expected`; NaN never passes.
void expectNear(const Vectors& values, const Vectors& expected, double tolerance) {
    ASSERT_EQ(values.size(), expected.size());
    const double limit = tolerance * largest(expected);
    for (std::size_t i = 0; i < values.size(); ++i)
        EXPECT_LE((values[i] - expected[i]).norm(), limit)
            << i << ": " << values[i].transpose() << " for " << expected[i].transpose();
}

template<class Real>
Motion steps(const TissueKernel<Real>& kernel, const Motion& motion, double timeStep, int count) {
    auto state = kernel.load(motion.positions, motion.velocities), next = state;
    for (int i = 0; i < count; ++i) {
        kernel.step(state, next, {timeStep, gravity});
        state.swap(next);
    }
    Motion result;
    kernel.store(state, result.positions, result.velocities);
    return result;
}

template<class Real> Vectors accelerations(const TissueKernel<Real>& kernel, const Motion& motion) {
    const auto state = kernel.load(motion.positions, motion.velocities);
    auto rates = state;
    kernel.rates(state, gravity, rates);
    Vectors velocities, result;
    kernel.store(rates, velocities, result);
    expectNear(velocities, motion.velocities, 1e-6);
    return result;
}

struct Variant {
    const char* name;
    Contents contents;
    Damping damping;
};

std::vector<Variant> variants() {
    Contents linear, biphasic, plain, single, walls;
    biphasic.biphasic = true;
    plain.tethers = plain.fixedNodes = plain.zeroLength = plain.hub = false;
    single.nodes = 11, single.springs = 0, single.hub = false;
    walls.hinges = 301;
    return {
        {"with hinges, isotropic", walls, Damping::Isotropic}, {"with hinges, axial", walls, Damping::Axial},
        {"linear, isotropic", linear, Damping::Isotropic},     {"linear, axial", linear, Damping::Axial},
        {"biphasic, isotropic", biphasic, Damping::Isotropic}, {"biphasic, axial", biphasic, Damping::Axial},
        {"springs only", plain, Damping::Isotropic},           {"no springs", single, Damping::Axial}};
}

template<class Real> void expectScalarForces(double tolerance) {
    for (const InstructionSet set : instructionSets())
        for (const auto& [name, contents, damping] : variants()) {
            SCOPED_TRACE(name);
            const SpringSystem system = network::random(contents, 2);
            const Motion motion = network::randomMotion(system, contents.zeroLength, 4);
            const TissueKernel<Real> kernel(system, {damping, set});
            expectNear(accelerations(kernel, motion), referenceAccelerations(system, damping, motion),
                       tolerance);
        }
}

bool sameBits(const Motion& a, const Motion& b) {
    return a.positions == b.positions && a.velocities == b.velocities;
}

template<class Real> void expectSameForAnyThreads() {
    Contents contents;
    contents.nodes = 3000, contents.springs = 9000, contents.hinges = 8000;
    const SpringSystem system = network::random(contents, 8);
    const Motion motion = network::randomMotion(system, true, 3);
    for (const InstructionSet set : instructionSets()) {
        const Motion alone = steps(TissueKernel<Real>(system, {Damping::Isotropic, set}), motion, 1e-6, 50);
        for (const std::size_t threads : {1U, 2U, 3U, 5U}) {
            ThreadTeam team(threads);
            const TissueKernel<Real> kernel(system, {Damping::Isotropic, set, &team, threads});
            EXPECT_TRUE(sameBits(steps(kernel, motion, 1e-6, 50), alone)) << threads << " threads";
        }
    }
}

} // namespace

TEST(TissueKernel, HasTheScalarForces) {
    expectScalarForces<double>(1e-14);
    expectScalarForces<float>(2e-6);
}

TEST(TissueKernel, StepsAsSemiImplicitEulerDoes) {
    for (const auto& [name, contents, damping] : variants()) {
        SCOPED_TRACE(name);
        const SpringSystem system = network::random(contents, 6);
        const Motion start = network::randomMotion(system, contents.zeroLength, 7);
        Motion expected = start;
        for (int i = 0; i < 20; ++i)
            expected = referenceStep(system, damping, expected, 1e-4);
        const Motion result = steps(TissueKernel<double>(system, {damping}), start, 1e-4, 20);
        expectNear(result.positions, expected.positions, 1e-12);
        expectNear(result.velocities, expected.velocities, 1e-12);
    }
}

TEST(TissueKernel, GivesTheSameBitsForAnyNumberOfThreads) {
    expectSameForAnyThreads<double>();
    expectSameForAnyThreads<float>();
}

TEST(TissueKernel, AgreesBetweenInstructionSets) {
    if (bestInstructionSet() == InstructionSet::V2) GTEST_SKIP() << "this processor has only one";
    for (const auto& [name, contents, damping] : variants()) {
        SCOPED_TRACE(name);
        const SpringSystem system = network::random(contents, 12);
        const Motion start = network::randomMotion(system, false, 13);
        const Motion v2 =
            steps(TissueKernel<double>(system, {damping, InstructionSet::V2}), start, 1e-4, 100);
        const Motion v3 =
            steps(TissueKernel<double>(system, {damping, InstructionSet::V3}), start, 1e-4, 100);
        expectNear(v2.positions, v3.positions, 1e-12);
        expectNear(v2.velocities, v3.velocities, 1e-12);
    }
}

TEST(TissueKernel, DoesNotDependOnTheNumbersOfNodes) {
    const SpringSystem system = network::random(Contents{}, 21);
    const Motion start = network::randomMotion(system, false, 22);
    const auto numbers = network::randomOrder(system.mass.size(), 23);
    const Motion result = steps(TissueKernel<double>(system, {}), start, 1e-4, 100);
    const Motion other =
        steps(TissueKernel<double>(network::renumbered(system, numbers), {}),
              {network::renumbered(start.positions, numbers), network::renumbered(start.velocities, numbers)},
              1e-4, 100);
    expectNear(other.positions, network::renumbered(result.positions, numbers), 1e-12);
    expectNear(other.velocities, network::renumbered(result.velocities, numbers), 1e-12);
}

TEST(TissueKernel, InFloatIsOffByRoundingOnly) {
    Contents contents;
    contents.biphasic = true;
    const SpringSystem system = network::random(contents, 31);
    const Motion start = network::randomMotion(system, false, 32);
    const Motion exact = steps(TissueKernel<double>(system, {}), start, 1e-4, 100);
    const Motion rounded = steps(TissueKernel<float>(system, {}), start, 1e-4, 100);
    expectNear(rounded.positions, exact.positions, 1e-5);
    expectNear(rounded.velocities, exact.velocities, 1e-4);
}

TEST(TissueKernel, KeepsMomentum) {
    Contents contents;
    contents.tethers = contents.fixedNodes = false;
    contents.hinges = 300;
    const SpringSystem system = network::random(contents, 41);
    const Motion start = network::randomMotion(system, true, 42);
    for (const Damping damping : {Damping::Isotropic, Damping::Axial}) {
        const Vectors a = accelerations(TissueKernel<double>(system, {damping}), start);
        Vector3d sum = Vector3d::Zero(), weight = Vector3d::Zero();
        double scale = 0;
        for (std::size_t i = 0; i < a.size(); ++i) {
            sum += system.mass[i] * a[i];
            weight += system.mass[i] * gravity;
            scale += system.mass[i] * a[i].norm();
        }
        EXPECT_LT((sum - weight).norm(), 1e-14 * scale);
    }
}

TEST(TissueKernel, AtRestStaysAtRestToTheLastBit) {
    const TissueModel model = tissue::fromMesh(tissue::sphereMesh(3, 0.05), {10, 0.1, 0.001});
    const SpringSystem system = makeSpringSystem(model);
    const Motion rest{model.network->restPositions, Vectors(system.mass.size(), Vector3d::Zero())};
    for (const InstructionSet set : instructionSets()) {
        const TissueKernel<double> kernel(system, {Damping::Isotropic, set});
        auto state = kernel.load(rest.positions, rest.velocities), next = state;
        kernel.step(state, next, {1e-3, Vector3d::Zero()});
        Motion after;
        kernel.store(next, after.positions, after.velocities);
        EXPECT_TRUE(sameBits(after, rest));
    }
}

TEST(TissueKernel, FixedNodesStay) {
    const SpringSystem system = network::random(Contents{}, 51);
    const Motion start = network::randomMotion(system, true, 52);
    const TissueKernel<double> kernel(system, {});
    const Motion end = steps(kernel, start, 1e-4, 20);
    for (std::size_t i = 0; i < system.mass.size(); ++i) {
        if (system.fixed[i]) {
            EXPECT_EQ(end.positions[i], start.positions[i]);
        }
        EXPECT_EQ(kernel.inverseMass(i), system.fixed[i] ? 0 : 1 / system.mass[i]);
    }
}

TEST(TissueKernel, TakesNewParametersForTheSameNetwork) {
    Contents contents;
    contents.biphasic = true;
    Contents walls;
    walls.hinges = 300;
    const SpringSystem before = network::random(walls, 61);
    SpringSystem after = before;
    for (auto& spring : after.springs) {
        spring.springConstant *= 3;
        spring.viscosity += 0.1;
        spring.secondPhase = {0.1, 100};
    }
    for (auto& hinge : after.hinges)
        hinge.springConstant *= 2;
    after.mass[4] *= 2;
    after.fixed[5] = 0;
    after.tethers.resize(3);
    const Motion start = network::randomMotion(before, true, 62);
    TissueKernel<double> kernel(before, {});
    kernel.setParameters(after);
    EXPECT_TRUE(
        sameBits(steps(kernel, start, 1e-4, 10), steps(TissueKernel<double>(after, {}), start, 1e-4, 10)));
    kernel.setParameters(before);
    EXPECT_TRUE(
        sameBits(steps(kernel, start, 1e-4, 10), steps(TissueKernel<double>(before, {}), start, 1e-4, 10)));
}

TEST(TissueKernel, ComputesOnlyTheSlicesThatAreListed) {
    Contents contents;
    contents.nodes = 3000, contents.springs = 9000, contents.hinges = 8000;
    const SpringSystem system = network::random(contents, 71);
    const Motion start = network::randomMotion(system, true, 72);
    ThreadTeam team(2);
    for (const std::size_t threads : {1U, 2U}) {
        const TissueKernel<double> kernel(system, {Damping::Isotropic, {}, &team, threads});
        const auto state = kernel.load(start.positions, start.velocities);
        auto all = state, some = state;
        kernel.step(state, all, {1e-4, gravity});
        std::vector<std::uint32_t> list;
        for (std::uint32_t slice = 1; slice < kernel.sliceCount(); slice += 3)
            list.push_back(slice);
        kernel.step(state, some, {1e-4, gravity}, list);
        for (std::size_t node = 0; node < system.mass.size(); ++node) {
            const std::size_t row = kernel.rowOf(node);
            const auto& expected = kernel.sliceOf(node) % 3 == 1 ? all[row] : state[row];
            EXPECT_TRUE(std::equal(expected.position, expected.position + 4, some[row].position));
            EXPECT_TRUE(std::equal(expected.velocity, expected.velocity + 4, some[row].velocity));
        }
        kernel.step(state, some, {1e-4, gravity}, {});
        kernel.rates(state, gravity, some, list);
        EXPECT_EQ(some[list[0] * kernel::sliceHeight].position[0],
                  state[list[0] * kernel::sliceHeight].velocity[0]);
    }
}

TEST(TissueKernel, OneNodeFalls) {
    const SpringSystem system = network::withNodes(1);
    const Motion start{system.network->restPositions, {Vector3d::Zero()}};
    const Motion end = steps(TissueKernel<double>(system, {}), start, 0.5, 1);
    EXPECT_EQ(end.velocities[0], Vector3d(0.5 * gravity));
    EXPECT_NEAR((end.positions[0] - start.positions[0] - 0.25 * gravity).norm(), 0, 1e-15);
}

TEST(TissueKernel, OfNothingDoesNothing) {
    const SpringSystem system = network::withNodes(0);
    const TissueKernel<float> kernel(system, {});
    EXPECT_EQ(kernel.sliceCount(), 0U);
    EXPECT_TRUE(steps(kernel, {}, 1e-3, 3).positions.empty());
}

// Masses of a nanogram and a tonne, constants over fifteen decades, lengths of millimetres and metres.
TEST(TissueKernel, InFloatTakesExtremeParametersWithoutOverflow) {
    Contents contents;
    contents.biphasic = true;
    SpringSystem system = network::random(contents, 81);
    for (std::size_t i = 0; i < system.springs.size(); ++i) {
        auto& spring = system.springs[i];
        spring.springConstant = std::pow(10, static_cast<double>(i % 16) - 6);
        if (i % 5 == 0) spring.restLength = 0;
        if (i % 7 == 0) spring.secondPhase = {1e30, 1e9};
        if (i % 9 == 0) spring.viscosity = 1e6;
    }
    for (std::size_t i = 0; i < system.mass.size(); ++i)
        system.mass[i] = std::pow(10, static_cast<double>(i % 13) - 9);
    const Motion motion = network::randomMotion(system, true, 82);
    for (const InstructionSet set : instructionSets())
        for (const Damping damping : {Damping::Isotropic, Damping::Axial}) {
            const Vectors exact = accelerations(TissueKernel<double>(system, {damping, set}), motion);
            const Vectors rounded = accelerations(TissueKernel<float>(system, {damping, set}), motion);
            for (std::size_t i = 0; i < exact.size(); ++i)
                ASSERT_TRUE(exact[i].allFinite() && rounded[i].allFinite()) << i;
            expectNear(rounded, exact, 1e-5);
        }
}
