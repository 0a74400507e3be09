#include "core/dynamics/simulation.h"
#include "core/samples/samples.h"
#include "core/support/errors.h"
#include "tests/core/c/opened_package.h"
#include "tests/core/exchange/export_package.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <limits>

namespace esm {
namespace {

using testing::HasSubstr;

constexpr const char *hollow = "version-1.glb", *filled = "version-8-filled.glb";

OwnedSimulation madeSimulation(const EsmPackage* package, const EsmSettings& settings) {
    EsmError error;
    OwnedSimulation simulation(esmMakeSimulation(package, &settings, &error));
    EXPECT_STREQ(error.text, "");
    return simulation;
}

std::vector<Eigen::Vector3d> points(const double* numbers, std::size_t count) {
    std::vector<Eigen::Vector3d> result;
    for (std::size_t i = 0; i < count; ++i)
        result.emplace_back(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]);
    return result;
}

EsmSettings steppedBy(const char* integrator, double timeStep) {
    EsmSettings settings{};
    settings.integrator = integrator;
    settings.timeStep = timeStep;
    return settings;
}

TEST(EsmSimulation, MovesAsTheLibraryInCppDoes) {
    const std::uint32_t pulled = 5, led = 9;
    const Eigen::Vector3d gravity(0, -9.81, 0), force(0, 0, -0.01), way(0.001, 0, 0);
    for (const char* name : {hollow, filled}) {
        const PackagedTissue content = loadPackagedTissue(keptPackage(name));
        const OwnedPackage package = openedPackage(keptPackage(name));
        const OwnedSimulation simulation = madeSimulation(package.get(), steppedBy("split2", 1e-3));
        const Eigen::Vector3d place = content.tissue.network->restPositions[led] + way;
        EsmError error;
        ASSERT_TRUE(esmSetGravity(simulation.get(), gravity.data(), &error));
        ASSERT_TRUE(esmSetForces(simulation.get(), 1, &pulled, force.data(), &error));
        ASSERT_TRUE(esmLeadNodes(simulation.get(), 1, &led, place.data(), &error));
        ASSERT_EQ(esmStep(simulation.get(), 20, &error), 20U) << error.text;

        SimulationSettings settings;
        settings.integrator = Integrator::Split2;
        settings.timeStep = 1e-3;
        Simulation ours(content.tissue, settings);
        Loads loads;
        loads.gravity = gravity;
        loads.forces = {{pulled, force}};
        loads.prescribed = {{led, place}};
        loads.beginsAnew = true;
        ASSERT_TRUE(ours.step(loads));
        loads.beginsAnew = false;
        ASSERT_EQ(ours.advance(loads, 19), 19U);
        const std::size_t count = esmModelOf(package.get())->nodes.count;
        EXPECT_EQ(points(esmPositionsOf(simulation.get()), count), ours.positions());
        EXPECT_EQ(points(esmVelocitiesOf(simulation.get()), count), ours.velocities());
        EXPECT_EQ(ours.positions()[led], place);
        EXPECT_DOUBLE_EQ(esmTimeOf(simulation.get()), 0.02);

        std::vector<double> vertices(3 * content.mesh.vertices.size());
        ASSERT_TRUE(esmDrawnVertices(simulation.get(), vertices.data(), &error));
        EXPECT_EQ(points(vertices.data(), content.mesh.vertices.size()),
                  drawnPositions(content.mesh, *content.tissue.network, ours.positions()));
    }
}

// Steps of some integrators build on those before, which were taken under other loads.
TEST(EsmSimulation, BeginsAnewWhereLoadsChangeMidway) {
    const std::uint32_t pulled = 5;
    const Eigen::Vector3d force(0, 0, -0.01), gravity(0, -9.81, 0);
    for (const auto& [name, integrator] :
         {std::pair("bdf2", Integrator::Bdf2), {"split2", Integrator::Split2}}) {
        SCOPED_TRACE(name);
        const OwnedPackage package = openedPackage(keptPackage(hollow));
        const OwnedSimulation simulation = madeSimulation(package.get(), steppedBy(name, 1e-3));
        const PackagedTissue content = loadPackagedTissue(keptPackage(hollow));
        SimulationSettings settings;
        settings.integrator = integrator;
        settings.timeStep = 1e-3;
        Simulation ours(content.tissue, settings);
        Loads loads;
        EsmError error;
        const auto expectSameSteps = [&] {
            ASSERT_EQ(esmStep(simulation.get(), 10, &error), 10U) << error.text;
            loads.beginsAnew = true;
            ASSERT_TRUE(ours.step(loads));
            loads.beginsAnew = false;
            ASSERT_EQ(ours.advance(loads, 9), 9U);
            EXPECT_EQ(points(esmPositionsOf(simulation.get()), ours.positions().size()), ours.positions());
        };
        loads.forces = {{pulled, force}};
        ASSERT_TRUE(esmSetForces(simulation.get(), 1, &pulled, force.data(), &error));
        expectSameSteps();
        loads.gravity = gravity;
        ASSERT_TRUE(esmSetGravity(simulation.get(), gravity.data(), &error));
        expectSameSteps();
        const Eigen::Vector3d place = ours.positions()[7];
        loads.prescribed = {{7, place}};
        const std::uint32_t led = 7;
        ASSERT_TRUE(esmLeadNodes(simulation.get(), 1, &led, place.data(), &error));
        expectSameSteps();
        loads.prescribed.clear();
        loads.forces.clear();
        ASSERT_TRUE(esmLeadNodes(simulation.get(), 0, nullptr, nullptr, &error));
        ASSERT_TRUE(esmSetForces(simulation.get(), 0, nullptr, nullptr, &error));
        expectSameSteps();
    }
}

TEST(EsmSimulation, ThePressuresOfAPackageAct) {
    const OwnedPackage package = openedPackage(keptPackage("version-9-origin.glb"));
    const OwnedSimulation simulation = madeSimulation(package.get(), steppedBy("split2", 1e-3));
    const PackagedTissue content = loadPackagedTissue(keptPackage("version-9-origin.glb"));
    ASSERT_FALSE(content.pressures.empty());
    SimulationSettings settings;
    settings.integrator = Integrator::Split2;
    settings.timeStep = 1e-3;
    Simulation ours(content.tissue, settings);
    EsmError error;
    ASSERT_EQ(esmStep(simulation.get(), 20, &error), 20U) << error.text;
    for (int i = 0; i < 20; ++i) {
        Loads loads;
        for (const PartPressure& pressure : content.pressures)
            loads.pressures.push_back(
                {pressure.part, pressureAt(pressure, ours.time()), pressureAt(pressure, ours.time() + 1e-3)});
        ASSERT_TRUE(ours.step(loads));
    }
    EXPECT_EQ(points(esmPositionsOf(simulation.get()), ours.positions().size()), ours.positions());
    EXPECT_NE(ours.positions(), content.tissue.network->restPositions);
}

TEST(EsmSimulation, IsSteppedAsRecommendedWhereAllIsLeftOpen) {
    Project project = makeSample("tube");
    const TemporaryFolder folder;
    const auto timeStep = [&](double recommended, const EsmSettings& settings) {
        project.stepping = MeasuredStepping{{Integrator::Split2, recommended}, 0.01, 0.1};
        exportPackage(project, folder / "tube.glb");
        return esmTimeStepOf(madeSimulation(openedPackage(folder / "tube.glb").get(), settings).get());
    };
    EXPECT_EQ(timeStep(1.25e-5, {}), 1.25e-5);
    EXPECT_NE(timeStep(1.25e-5, steppedBy("split2", 0)), 1.25e-5);
    EsmSettings axial{};
    axial.dampsAxially = 1;
    EXPECT_NE(timeStep(1.25e-5, axial), 1.25e-5);
    EXPECT_LT(timeStep(100, {}), 1) << "a step that is not stable";
}

TEST(EsmSimulation, RefusesWhatWasNotOpenedOrMade) {
    const double vector[3] = {0, 0, 1};
    const std::uint32_t node = 0;
    const EsmInstrument ball{1, 0, {0, 0, 0}, {0, 0, 0, 0}};
    double vertices[3];
    EsmError error;
    EXPECT_EQ(esmMakeSimulation(nullptr, nullptr, &error), nullptr);
    EXPECT_THAT(error.text, HasSubstr("package is NULL"));
    const auto expectRefused = [&](std::size_t result) {
        EXPECT_EQ(result, 0U);
        EXPECT_THAT(error.text, HasSubstr("simulation is NULL"));
        error.text[0] = '\0';
    };
    expectRefused(static_cast<std::size_t>(esmSetGravity(nullptr, vector, &error)));
    expectRefused(static_cast<std::size_t>(esmSetForces(nullptr, 1, &node, vector, &error)));
    expectRefused(static_cast<std::size_t>(esmLeadNodes(nullptr, 1, &node, vector, &error)));
    expectRefused(static_cast<std::size_t>(esmPlaceInstruments(nullptr, 1, &ball, &error)));
    expectRefused(esmStep(nullptr, 1, &error));
    expectRefused(static_cast<std::size_t>(esmDrawnVertices(nullptr, vertices, &error)));
    EXPECT_EQ(esmStep(nullptr, 1, nullptr), 0U);
}

TEST(EsmSimulation, LivesOnWithoutItsPackageAndGoesBackToRest) {
    OwnedPackage package = openedPackage(keptPackage(hollow));
    const OwnedSimulation simulation = madeSimulation(package.get(), {});
    const EsmNodes nodes = esmModelOf(package.get())->nodes;
    const std::vector<Eigen::Vector3d> rest = points(nodes.restPositions, nodes.count);
    package.reset();
    EXPECT_STRNE(esmIntegratorOf(simulation.get()), "auto");
    EXPECT_GT(esmTimeStepOf(simulation.get()), 0);
    const double gravity[3] = {0, -9.81, 0};
    EsmError error;
    ASSERT_TRUE(esmSetGravity(simulation.get(), gravity, &error));
    ASSERT_EQ(esmStep(simulation.get(), 3, &error), 3U);
    EXPECT_NE(points(esmPositionsOf(simulation.get()), rest.size()), rest);
    esmReset(simulation.get());
    EXPECT_EQ(points(esmPositionsOf(simulation.get()), rest.size()), rest);
    EXPECT_EQ(esmTimeOf(simulation.get()), 0);
}

TEST(EsmSimulation, AnInstrumentPushesAndFeelsTheTissue) {
    const OwnedPackage package = openedPackage(keptPackage(filled));
    const OwnedSimulation simulation = madeSimulation(package.get(), steppedBy("split", 1e-3));
    const EsmModel& model = *esmModelOf(package.get());
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& place : points(model.nodes.restPositions, model.nodes.count))
        box.extend(place);
    const double radius = 0.2 * box.sizes().x();
    EsmError error;
    for (int step = 0; step <= 100; ++step) {
        const double x = box.max().x() + radius * (1.05 - 0.005 * step);
        const EsmInstrument ball{radius, 0, {x, box.center().y(), box.center().z()}, {0, 0, 0, 0}};
        ASSERT_TRUE(esmPlaceInstruments(simulation.get(), 1, &ball, &error)) << error.text;
        ASSERT_EQ(esmStep(simulation.get(), 1, &error), 1U) << error.text;
    }
    double impulse[3], none[3];
    esmInstrumentImpulse(simulation.get(), 0, impulse);
    EXPECT_GT(impulse[0], 0) << "the tissue pushes back, towards where the ball came from";
    esmInstrumentImpulse(simulation.get(), 1, none);
    EXPECT_EQ(none[0], 0);
}

TEST(EsmSimulation, RefusesWhatItCannotStep) {
    const OwnedPackage package = openedPackage(keptPackage(hollow));
    EsmError error;
    const EsmSettings unknown = steppedBy("leapfrog", 0), backwards = steppedBy("euler", -1);
    EXPECT_EQ(esmMakeSimulation(package.get(), &unknown, &error), nullptr);
    EXPECT_THAT(error.text, testing::AllOf(HasSubstr("leapfrog"), HasSubstr("split2")));
    EXPECT_EQ(esmMakeSimulation(package.get(), &backwards, &error), nullptr);
    EXPECT_STRNE(error.text, "");
}

TEST(EsmSimulation, RefusesLoadsThatCannotBeAndKeepsTheOldOnes) {
    const OwnedPackage package = openedPackage(keptPackage(hollow));
    const OwnedSimulation simulation = madeSimulation(package.get(), {});
    const double bad[3] = {0, std::numeric_limits<double>::quiet_NaN(), 0}, good[3] = {0, 0, 0.01};
    const std::uint32_t none = 1u << 30, some = 3;
    EsmError error;
    EXPECT_FALSE(esmSetGravity(simulation.get(), bad, &error));
    ASSERT_TRUE(esmSetForces(simulation.get(), 1, &some, good, &error));
    EXPECT_FALSE(esmSetForces(simulation.get(), 1, &none, good, &error));
    EXPECT_THAT(error.text, HasSubstr(std::to_string(none)));
    EXPECT_FALSE(esmSetForces(simulation.get(), 1, &some, bad, &error));
    EXPECT_FALSE(esmLeadNodes(simulation.get(), 1, &none, good, &error));
    EsmInstrument instruments[2] = {{1, 0, {0, 0, 0}, {0, 0, 0, 0}}, {}};
    EXPECT_FALSE(esmPlaceInstruments(simulation.get(), 2, instruments, &error));
    EXPECT_STREQ(error.text, "instrument 1: its radius must be above 0, and finite");
    instruments[1] = {1, -1, {0, 0, 0}, {0, 0, 0, 0}};
    EXPECT_FALSE(esmPlaceInstruments(simulation.get(), 2, instruments, &error));
    EXPECT_THAT(error.text, HasSubstr("instrument 1: its length"));
    instruments[1] = {1, 0, {0, bad[1], 0}, {0, 0, 0, 0}};
    EXPECT_FALSE(esmPlaceInstruments(simulation.get(), 2, instruments, &error));
    EXPECT_THAT(error.text, HasSubstr("instrument 1: its place"));
    instruments[1] = {1, 0, {0, 0, 0}, {bad[1], 0, 0, 0}};
    EXPECT_FALSE(esmPlaceInstruments(simulation.get(), 2, instruments, &error));
    EXPECT_THAT(error.text, HasSubstr("instrument 1: its orientation"));
    const double before = esmPositionsOf(simulation.get())[3 * some + 2];
    ASSERT_EQ(esmStep(simulation.get(), 1, &error), 1U);
    EXPECT_GT(esmPositionsOf(simulation.get())[3 * some + 2], before);
}

TEST(EsmSimulation, StopsWhereMotionRunsWild) {
    const OwnedPackage package = openedPackage(keptPackage(hollow));
    const OwnedSimulation simulation = madeSimulation(package.get(), steppedBy("euler", 1));
    const double gravity[3] = {0, -9.81, 0};
    EsmError error;
    ASSERT_TRUE(esmSetGravity(simulation.get(), gravity, &error));
    EXPECT_LT(esmStep(simulation.get(), 1000, &error), 1000U);
    EXPECT_STRNE(error.text, "");
    const std::size_t count = esmModelOf(package.get())->nodes.count;
    for (const Eigen::Vector3d& place : points(esmPositionsOf(simulation.get()), count))
        EXPECT_TRUE(place.allFinite());
}

} // namespace
} // namespace esm
