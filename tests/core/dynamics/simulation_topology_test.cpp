#include "core/dynamics/schemes/schemes.h"
#include "core/dynamics/simulation.h"
#include "core/support/errors.h"
#include "tests/support/every_integrator.h"
#include "tests/support/motion_difference.h"
#include "tests/support/sanitized.h"
#include "tests/support/simulation_settings.h"
#include "tests/support/split_tissue.h"
#include "tests/support/was_touched.h"

#include <gmock/gmock.h>

using namespace esm;
using tissue::Sheet;
using tissue::Vectors;

namespace {

class TopologyOfARun : public testing::TestWithParam<Integrator> {};
INSTANTIATE_TEST_SUITE_P(Dynamics, TopologyOfARun, testing::ValuesIn(allIntegrators), nameOfIntegratorTest);

constexpr double step = 1e-3; ///< s
int steps() {
    return isSanitized() ? 10 : 60;
}

/// Nine by nine nodes, hung on its lower border, some of it tethered.
Sheet hungSheet() {
    Sheet sheet = tissue::sheetOf(tissue::gridMesh(9, 0.1), {40, 0.01, 0.001});
    sheet.tissue.fixedNodes = {0, 1, 2, 3, 4, 5, 6, 7, 8};
    for (std::uint32_t node = 20; node < 81; node += 5)
        sheet.tissue.tethers.push_back({node, 3, 0.01});
    return sheet;
}

const tissue::SplitPath fromBorderToBorder = tissue::pathAlong({4, 13, 22, 31, 40, 49, 58, 67, 76});

/// N, at two corners, upwards and apart.
Loads pull() {
    Loads loads;
    loads.forces = {{72, {-0.05, 0.02, 0.03}}, {80, {0.05, 0.02, 0.01}}};
    return loads;
}

void advance(Simulation& simulation, const Loads& loads, int count) {
    for (int i = 0; i < count; ++i)
        ASSERT_TRUE(simulation.step(loads)) << simulation.failure();
}

Simulation movingSheet(const Sheet& sheet, Integrator integrator) {
    Simulation simulation(sheet.tissue, withStep(integrator, step));
    advance(simulation, pull(), steps());
    return simulation;
}

Eigen::Vector3d momentum(const Simulation& simulation) {
    Eigen::Vector3d sum(0, 0, 0);
    for (std::size_t node = 0; node < simulation.velocities().size(); ++node)
        sum += simulation.system().mass[node] * simulation.velocities()[node];
    return sum;
}

TEST_P(TopologyOfARun, KeepsMomentumAndEnergyWhereItIsSplit) {
    const Sheet sheet = hungSheet();
    Simulation simulation = movingSheet(sheet, GetParam());
    const Eigen::Vector3d before = momentum(simulation);
    const Energy energy = simulation.energy();
    const double time = simulation.time();
    const SplitTissue split = splitSheet(sheet, fromBorderToBorder);
    simulation.setTopology(split.tissue, split.map);
    ASSERT_GT(before.norm(), 0);
    EXPECT_LT((momentum(simulation) - before).norm(), 1e-14 * before.norm());
    EXPECT_NEAR(simulation.energy().kinetic, energy.kinetic, 1e-13 * energy.total());
    EXPECT_NEAR(simulation.energy().elastic, energy.elastic, 1e-13 * energy.total());
    EXPECT_EQ(simulation.time(), time);
    EXPECT_EQ(simulation.timeStep(), step);
    EXPECT_EQ(simulation.integrator(), GetParam());
    advance(simulation, pull(), steps());
    EXPECT_NEAR(simulation.time(), 2 * time, 1e-12);
}

TEST_P(TopologyOfARun, LetsBothSidesOfACutGoApart) {
    const Sheet sheet = hungSheet();
    const SplitTissue split = splitSheet(sheet, fromBorderToBorder);
    Simulation simulation = movingSheet(sheet, GetParam());
    simulation.setTopology(split.tissue, split.map);
    advance(simulation, pull(), steps());
    const Vectors& at = simulation.positions();
    const PartedNode& top = split.parted.back();
    EXPECT_GT(at[top.twin].x() - at[top.node].x(), isSanitized() ? 1e-6 : 1e-3);
}

bool buildsOnEarlierSteps(Integrator integrator) {
    return traitsOf(integrator).startsAs != integrator || schemeOf(integrator).explicitMethod.keptRates > 0;
}

/// What was split and joined again at once goes on as if it had begun anew, as after new parameters.
TEST_P(TopologyOfARun, IsNotChangedByWhatIsTakenBack) {
    const Sheet sheet = hungSheet();
    const SplitTissue split = splitSheet(sheet, fromBorderToBorder);
    Simulation taken = movingSheet(sheet, GetParam()), begun = movingSheet(sheet, GetParam());
    taken.setTopology(split.tissue, split.map);
    taken.setTopology(sheet.tissue, tissue::joining(split));
    begun.setModel(sheet.tissue);
    const Vectors start = begun.positions();
    advance(taken, pull(), steps());
    advance(begun, pull(), steps());
    EXPECT_LT(motionDifference(taken.positions(), begun.positions(), start), 1e-12);
    if (buildsOnEarlierSteps(GetParam())) return;
    Simulation alone = movingSheet(sheet, GetParam());
    advance(alone, pull(), steps());
    EXPECT_LT(motionDifference(taken.positions(), alone.positions(), start), 1e-12);
}

TEST_P(TopologyOfARun, IsTheWholeOneAfterAReset) {
    const Sheet sheet = hungSheet();
    const SplitTissue split = splitSheet(sheet, fromBorderToBorder);
    Simulation simulation = movingSheet(sheet, GetParam());
    const Vectors moved = simulation.positions();
    simulation.setTopology(split.tissue, split.map);
    advance(simulation, pull(), 3);
    simulation.reset();
    EXPECT_EQ(simulation.positions(), sheet.tissue.network->restPositions);
    EXPECT_EQ(simulation.time(), 0);
    advance(simulation, pull(), steps());
    EXPECT_EQ(simulation.positions(), moved);
}

TEST_P(TopologyOfARun, GoesBackToAStateOfTheWholeWithItsParts) {
    const Sheet sheet = hungSheet();
    const SplitTissue split = splitSheet(sheet, fromBorderToBorder);
    Simulation simulation = movingSheet(sheet, GetParam());
    simulation.keepState();
    simulation.keepState();
    const Vectors kept = simulation.positions();
    const double time = simulation.time();
    advance(simulation, pull(), 3);
    simulation.setTopology(split.tissue, split.map);
    advance(simulation, pull(), 3);
    simulation.goBack(step / 2);
    EXPECT_EQ(simulation.positions(), split.map.mapped(kept));
    EXPECT_DOUBLE_EQ(simulation.time(), time);
    advance(simulation, pull(), 3);
}

TEST(TopologyChange, RefusesAMapThatIsNone) {
    const Sheet sheet = hungSheet();
    const SplitTissue split = splitSheet(sheet, fromBorderToBorder);
    Simulation simulation = movingSheet(sheet, Integrator::Euler);
    const Vectors before = simulation.positions();
    EXPECT_THROW(simulation.setTopology(split.tissue, NodeMap::identity(81)), InvalidModel);
    EXPECT_THROW(simulation.setTopology(split.tissue, NodeMap::identity(90)), InvalidModel);
    EXPECT_EQ(simulation.positions(), before);
    advance(simulation, pull(), 3);
}

TEST(TopologyChange, TakesNewParametersOnceTheTissueIsWholeAgain) {
    const Sheet sheet = hungSheet();
    const SplitTissue split = splitSheet(sheet, fromBorderToBorder);
    Simulation simulation = movingSheet(sheet, Integrator::Euler);
    simulation.setTopology(split.tissue, split.map);
    EXPECT_THROW(simulation.setModel(split.tissue), InvalidModel);
    EXPECT_THROW(simulation.setModel(sheet.tissue), InvalidModel);
    advance(simulation, pull(), 3);
    simulation.reset();
    TissueModel heavier = sheet.tissue;
    heavier.mass[0] *= 2;
    simulation.setModel(heavier);
    EXPECT_EQ(simulation.system().mass[0], heavier.mass[0]);
}

/// An instrument in the gap touches both sides of it.
TEST(TopologyChange, MovesWhatInstrumentsTouch) {
    const Sheet sheet = hungSheet();
    const SplitTissue split = splitSheet(sheet, fromBorderToBorder);
    const auto surfaceOf = [](const Topology& topology) {
        return TouchedSurface(simulatedSurface(*topology.surface, *topology.network));
    };
    Simulation simulation(sheet.tissue, withStep(Integrator::Implicit, step), surfaceOf(sheet.topology));
    Loads loads = pull();
    loads.instruments = {{Sphere{0.006}, {{0, 0, 0.02}}}};
    simulation.setTopology(split.tissue, split.map, surfaceOf(split.topology));
    for (int i = 0; i < 20; ++i) {
        loads.instruments[0].pose.place.z() -= 0.0015;
        ASSERT_TRUE(simulation.step(loads)) << simulation.failure();
    }
    EXPECT_TRUE(wasTouched(simulation));
    const PartedNode& middle = split.parted[4];
    EXPECT_GT(simulation.positions()[middle.twin].x() - simulation.positions()[middle.node].x(), 0.002);
}

} // namespace
