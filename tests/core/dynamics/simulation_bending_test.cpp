#include "core/dynamics/simulation.h"
#include "core/dynamics/stability/stability.h"
#include "core/dynamics/step_matrix.h"
#include "tests/support/bent_walls.h"
#include "tests/support/every_integrator.h"
#include "tests/support/flat_nets.h"
#include "tests/support/sanitized.h"
#include "tests/support/simulation_settings.h"
#include "tests/support/test_surfaces.h"

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include <algorithm>

using namespace esm;
using namespace esm::test;
using Eigen::Vector3d;

namespace {

constexpr double edge = 0.01;                  ///< m
constexpr double rowHeight = 0.8660254 * edge; ///< m
constexpr double thickness = 0.003;            ///< m
const tissue::Parameters flapTissue{20, 1e-3, 8.66e-6};
/// m/s², so little that the plate's linear theory holds.
constexpr double littleGravity = 0.1;

/// A strip of so many triangles, held along one of its short sides by two columns of nodes.
struct Flap {
    std::uint32_t columns, rows;
    TriangleMesh mesh;
    TissueModel model;

    Flap(std::uint32_t across, std::uint32_t up, double wall)
        : columns(across), rows(up), mesh(regularNet(across, up)) {
        for (Vector3d& vertex : mesh.vertices)
            vertex *= edge;
        model = tissue::fromMesh(mesh, flapTissue);
        if (wall > 0) model.hinges = wallHinges(model, mesh.triangles, wall);
        for (std::uint32_t node = 0; node < mesh.vertices.size(); ++node)
            if (mesh.vertices[node].x() < 1.6 * edge) model.fixedNodes.push_back(node);
    }

    /// m, of the free side, in the mean.
    template<class HeightOf> double sag(const HeightOf& heightOf) const {
        double sum = 0;
        for (std::uint32_t row = 0; row <= rows; ++row)
            sum -= heightOf(row * (columns + 1) + columns) / (rows + 1);
        return sum;
    }

    /// By the linear theory of the hinges alone, from their matrix: what steps must come to.
    double solvedSag() const {
        SpringSystem system = makeSpringSystem(model);
        system.springs.clear();
        const auto stiffness = laplacianMatrix(system, {0, 0, 1}, system.fixed);
        const Eigen::VectorXd weight =
            Eigen::VectorXd::Constant(stiffness.rows(), -flapTissue.nodeMass * littleGravity);
        const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(stiffness);
        const Eigen::VectorXd solved = factor.solve(weight);
        std::vector<double> heights(mesh.vertices.size(), 0);
        Eigen::Index next = 0;
        for (std::size_t node = 0; node < heights.size(); ++node)
            if (!system.fixed[node]) heights[node] = solved[next++];
        return sag([&](std::size_t node) { return heights[node]; });
    }

    /// What steps come to after so many seconds.
    double steppedSag(Integrator integrator, double step, double duration, double gravity) const {
        Simulation simulation(model, withStep(integrator, step));
        Loads loads;
        loads.gravity = {0, 0, -gravity};
        const auto count = static_cast<std::size_t>(std::ceil(duration / step));
        EXPECT_EQ(simulation.advance(loads, count), count) << simulation.failure();
        return sag([&](std::size_t node) { return simulation.positions()[node].z(); });
    }
};

/// m, q·L⁴/(8·E·I) of a beam that carries the flap's nodes, with E·I = D·(1 − ν²) per width: its sides are
/// free to curve the other way.
double beamSag(const Flap& flap) {
    const double length = (flap.columns - 1 + 0.25) * edge;
    const double load =
        flapTissue.nodeMass * littleGravity / (edge * rowHeight) * (flap.rows + 1) / flap.rows;
    const double bending = plateStiffness(flapTissue.springConstant, thickness) * 8 / 9;
    return load * std::pow(length, 4) / (8 * bending);
}

double stepFor(const TissueModel& model, Integrator integrator) {
    const double critical = criticalStep(model, integrator).value_or(0);
    // Its matrix resists turning as a viscosity of c·h does: a longer step would take too long to settle.
    if (integrator == Integrator::Projective) return 5e-5;
    return std::min(integrator == Integrator::Propagation ? 2e-4 : 2e-3, 0.9 * critical);
}

class BentBy : public testing::TestWithParam<Integrator> {};
INSTANTIATE_TEST_SUITE_P(Dynamics, BentBy, testing::ValuesIn(allIntegrators), nameOfIntegratorTest);

TEST_P(BentBy, AFlapSagsAsFarAsItsHingesSay) {
    if (isSanitized() && GetParam() == Integrator::Propagation) GTEST_SKIP() << "too many short steps";
    const Flap flap(8, 4, thickness);
    const double expected = flap.solvedSag();
    EXPECT_NEAR(flap.steppedSag(GetParam(), stepFor(flap.model, GetParam()), 3, littleGravity), expected,
                5e-3 * expected);
}

TEST_P(BentBy, AWallOfAnyShapeStaysAtRest) {
    const TissueModel model = wallOf(lumpySurface(8, 9), {20, 0.01, 1e-4}, 0.01);
    Simulation simulation(model,
                          withStep(GetParam(), 0.9 * std::min(1e-3, *criticalStep(model, GetParam()))));
    ASSERT_EQ(simulation.advance({}, 200), 200U);
    for (std::size_t i = 0; i < model.mass.size(); ++i)
        EXPECT_LT((simulation.positions()[i] - model.network->restPositions[i]).norm(), 1e-13);
}

TEST_P(BentBy, AFreeWallKeepsItsMomentum) {
    if (isSanitized() && GetParam() == Integrator::Propagation) GTEST_SKIP() << "too many short steps";
    const TissueModel model = wallOf(lumpySurface(8, 9), {20, 0.01, 1e-4}, 0.01);
    Simulation simulation(model,
                          withStep(GetParam(), 0.9 * std::min(1e-3, *criticalStep(model, GetParam()))));
    Loads kick;
    kick.forces = {{3, {0.02, 0.01, -0.03}}, {40, {0.01, 0, 0.01}}};
    const Vector3d given = 10 * simulation.timeStep() * Vector3d(0.03, 0.01, -0.02);
    ASSERT_EQ(simulation.advance(kick, 10), 10U);
    ASSERT_EQ(simulation.advance({}, 200), 200U);
    Vector3d momentum = Vector3d::Zero();
    for (const Vector3d& velocity : simulation.velocities())
        momentum += 1e-4 * velocity;
    EXPECT_LT((momentum - given).norm(),
              (GetParam() == Integrator::Propagation ? 1e-5 : 1e-9) * given.norm());
}

TEST(Bending, OfACantileverIsThatOfABeam) {
    const Flap coarse(24, 6, thickness), fine(80, 20, thickness);
    EXPECT_NEAR(coarse.solvedSag() / beamSag(coarse), 1, 0.03);
    EXPECT_NEAR(fine.solvedSag() / beamSag(fine), 1, 0.03);
}

TEST(Bending, KeepsTheFormOfAFlapThatElseHangsDown) {
    const Flap wall(8, 4, 0.02), skin(8, 4, 0);
    const double length = 7 * edge;
    EXPECT_GT(skin.steppedSag(Integrator::Bdf2, 2e-3, 3, 9.81), 0.8 * length);
    EXPECT_LT(wall.steppedSag(Integrator::Bdf2, 2e-3, 3, 9.81), 0.3 * length);
}

/// Whether the energy of a small kick everywhere grows a millionfold.
bool blowsUp(const TissueModel& model, Integrator integrator, double step) {
    Simulation simulation(model, withStep(integrator, step));
    Loads kick;
    for (std::uint32_t i = 0; i < model.mass.size(); ++i)
        kick.forces.emplace_back(i,
                                 1e-9 * model.mass[i] / step *
                                     Vector3d(std::sin(9.1 * i), std::cos(5.3 * i), std::sin(3.7 * i + 1)));
    EXPECT_TRUE(simulation.step(kick));
    const double given = simulation.energy().total();
    for (int i = 0; i < 100; ++i)
        if (simulation.advance({}, 100) < 100 || simulation.energy().total() > 1e6 * given) return true;
    return false;
}

// Thin, where springs limit the step, and thick, where hinges do.
TEST(Bending, CountsInTheLongestStableStep) {
    for (const double wall : isSanitized() ? std::vector{0.02} : std::vector{0.003, 0.02, 0.1}) {
        const TissueModel model = wallOf(lumpySurface(8, 9), {20, 0.01, 1e-4}, wall);
        for (const Integrator integrator : explicitIntegrators()) {
            SCOPED_TRACE(std::string(integratorName(integrator)) + " " + std::to_string(wall));
            const double atRest = *criticalStep(model, integrator, {1e-3, Deformation::AtRest, {}});
            EXPECT_FALSE(blowsUp(model, integrator, 0.97 * *criticalStep(model, integrator)));
            EXPECT_FALSE(blowsUp(model, integrator, 0.97 * atRest)) << atRest;
            EXPECT_TRUE(blowsUp(model, integrator, 1.15 * atRest)) << atRest;
        }
    }
}

} // namespace
