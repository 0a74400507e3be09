#include "app/editor/workers/preview_run.h"

#include "core/authoring/fluids.h"
#include "core/render/drawn_shape.h"
#include "tests/app/editor/workers/preview_projects.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace esm;

namespace {

/// The size of what moves over its size at rest.
double growth(const PreviewRun& run) {
    return boundingBox(run.positions()).diagonal().norm() /
           boundingBox(run.network()->restPositions).diagonal().norm();
}

/// Plays up to so many frames, until the run stops or its step was halved that often.
bool playUntilHalved(PreviewRun& run, int halvings, int mostFrames) {
    PreviewLoads loads;
    loads.gentleMotion = true;
    for (int frame = 0; frame < mostFrames && run.status().halvings < halvings; ++frame)
        if (!run.advance(1.0 / 60, loads)) return false;
    return true;
}

} // namespace

TEST(PreviewRun, DoesNotMoveOnWithAModelThatWasRefused) {
    PreviewRun run;
    ASSERT_TRUE(run.take(prepareProject(makeSample("tube"))));
    EXPECT_TRUE(run.isReady());
    EXPECT_FALSE(run.take(prepareProject(refusedProject())));
    run.reset();
    EXPECT_FALSE(run.isReady());
    EXPECT_NE(run.status().failure, "");
    EXPECT_TRUE(run.take(prepareProject(makeSample("tube"))));
    EXPECT_TRUE(run.isReady());
    EXPECT_EQ(run.status().failure, "");
}

TEST(PreviewRun, GoesOnFromRestAfterItWasStopped) {
    PreviewRun run;
    run.take(prepareProject(makeSample("tube")));
    run.stop("no reason");
    EXPECT_FALSE(run.isReady());
    EXPECT_EQ(run.status().failure, "no reason");
    run.reset();
    EXPECT_TRUE(run.isReady());
}

TEST(PreviewRun, GoesBackAndOnInShorterStepsWhenTheMotionRunsWild) {
    const Project tube = steppedTooLong(3);
    const double timeStep = tube.stepping->stepping.timeStep;
    PreviewRun run;
    ASSERT_TRUE(run.take(prepareProject(tube)));
    EXPECT_TRUE(playUntilHalved(run, 2, 2000));
    EXPECT_EQ(run.status().halvings, 2);
    EXPECT_DOUBLE_EQ(run.status().timeStep, timeStep / 4);
    EXPECT_TRUE(playUntilHalved(run, 3, 20));
    EXPECT_EQ(run.status().halvings, 2) << "shorter steps were of help";
    EXPECT_EQ(run.status().failure, "");
    EXPECT_LT(growth(run), 2);

    ASSERT_TRUE(run.take(prepareProject(tube)));
    EXPECT_EQ(run.status().halvings, 0);
    EXPECT_DOUBLE_EQ(run.status().timeStep, timeStep);
}

TEST(PreviewRun, GoesOnAsTheProgramChoosesWhereShorterStepsAreOfNoHelp) {
    const Project tube = steppedTooLong(1000);
    const double timeStep = tube.stepping->stepping.timeStep;
    PreviewRun run;
    ASSERT_TRUE(run.take(prepareProject(tube)));
    EXPECT_TRUE(playUntilHalved(run, 100, 200));
    EXPECT_EQ(run.status().replaced, Replaced::RanWild);
    EXPECT_EQ(run.status().halvings, 0) << "its own step may be halved as often as the first";
    EXPECT_NE(run.status().integrator, Integrator::Euler);
    EXPECT_EQ(run.status().failure, "");
    EXPECT_LT(growth(run), 2);
    run.reset();
    EXPECT_EQ(run.status().replaced, Replaced::Not);
    EXPECT_EQ(run.status().halvings, 0);
    EXPECT_DOUBLE_EQ(run.status().timeStep, timeStep);
}

TEST(PreviewRun, DoesNotPlayOnByAStepFarBeyondTheSafeOne) {
    const Project tube = steppedTooLong(1000);
    const double timeStep = tube.stepping->stepping.timeStep;
    PreviewRun run;
    ASSERT_TRUE(run.take(prepareProject(tube)));
    run.keepWithin(timeStep / 1.5);
    EXPECT_EQ(run.status().replaced, Replaced::Not)
        << "what is predicted for any deformation is on the safe side";
    run.keepWithin(timeStep / 1000);
    EXPECT_EQ(run.status().replaced, Replaced::BeyondSafe);
    EXPECT_NE(run.integrator(), Integrator::Euler);
    run.reset();
    EXPECT_EQ(run.status().replaced, Replaced::BeyondSafe) << "from rest it is as far beyond";
    EXPECT_NE(run.integrator(), Integrator::Euler);
    ASSERT_TRUE(run.take(prepareProject(tube)));
    EXPECT_EQ(run.status().replaced, Replaced::Not) << "parameters that come may bear it";
}

TEST(PreviewRun, TheProgramsOwnStepIsItsOwnToKeep) {
    PreviewRun run;
    ASSERT_TRUE(run.take(prepareProject(makeSample("tube"))));
    run.keepWithin(run.status().timeStep / 1000);
    EXPECT_EQ(run.status().replaced, Replaced::Not);
}

TEST(PreviewRun, TakesShorterStepsWhereOneCannotBeComputed) {
    Project tube = makeSample("tube");
    tube.regions.clear(); // the base tissue is to be seen
    tube.base.viscosity *= 1e6;
    tube.stepping = {{Integrator::Propagation, longestWatchedStep, Precision::Double}, 0.01, 1};
    PreviewRun run;
    ASSERT_TRUE(run.take(prepareProject(tube)));
    EXPECT_TRUE(playUntilHalved(run, 1, 20)) << run.status().failure;
    EXPECT_EQ(run.status().halvings, 1);
    EXPECT_EQ(run.status().timeStep, longestWatchedStep / 2);
    EXPECT_EQ(run.status().failure, "");
}

TEST(PreviewRun, StopsWithAWordWhereTheTissueCanBeSeenForTheLastTime) {
    Project tube = makeSample("tube");
    tube.scene = {};
    tube.scene.gravity = {0, -1e9, 0}; // and nothing holds it
    PreviewRun run;
    ASSERT_TRUE(run.take(prepareProject(tube)));
    for (int frame = 0; frame < 100 && run.isReady(); ++frame) {
        run.advance(1.0 / 60, {});
        ASSERT_TRUE(std::all_of(run.positions().begin(), run.positions().end(), isDrawable)) << frame;
    }
    EXPECT_FALSE(run.isReady());
    EXPECT_NE(run.status().failure.find("too far away to be drawn"), std::string::npos)
        << run.status().failure;
    run.reset();
    EXPECT_TRUE(run.isReady());
    EXPECT_NEAR(growth(run), 1, 1e-12);
}

TEST(PreviewRun, TellsTheForceOnTheInstrumentThatIsHeld) {
    PreviewRun run;
    ASSERT_TRUE(run.take(prepareProject(makeSample("liver"))));
    EXPECT_FALSE(run.status().instrument);
    const Eigen::AlignedBox3d box = boundingBox(run.positions());
    PreviewLoads loads;
    for (int frame = 0; frame < 30; ++frame) {
        const double depth = 0.002 * frame / 30;
        loads.instrument = sphereAt({box.center().x(), box.center().y(), box.max().z() + 0.03 - depth}, 0.03);
        ASSERT_TRUE(run.advance(1.0 / 60, loads));
    }
    ASSERT_TRUE(run.status().instrument);
    EXPECT_GT(run.status().instrument->force, 0);
    EXPECT_GT(run.status().instrument->displacement, 0);
    loads.instrument = sphereAt(box.max() + Eigen::Vector3d(1, 1, 1), 0.03);
    ASSERT_TRUE(run.advance(1.0 / 60, loads));
    EXPECT_FALSE(run.status().instrument) << "nothing is touched";
}

// Pulled further and held, tissue bears what its springs say: twice as far, about twice the force.
TEST(PreviewRun, TellsForceAndWayOfThePull) {
    PreviewRun run;
    ASSERT_TRUE(run.take(prepareProject(makeSample("liver"))));
    EXPECT_FALSE(run.status().pull);
    const std::uint32_t node = 0;
    const Eigen::Vector3d from = run.positions()[node];
    PreviewLoads loads;
    const auto feltAt = [&](double way) {
        loads.pull = Pull{node, from + Eigen::Vector3d(0, 0, way)};
        for (int frame = 0; frame < 3000; ++frame)
            run.advance(1.0 / 60, loads);
        return run.status().pull.value_or(FeltTissue());
    };
    const FeltTissue near = feltAt(0.002), far = feltAt(0.004);
    EXPECT_NEAR(near.displacement, 0.002, 1e-5);
    EXPECT_NEAR(far.displacement, 0.004, 1e-5);
    EXPECT_GT(near.force, 0);
    EXPECT_NEAR(far.force / near.force, 2, 0.4);
    loads.pull.reset();
    run.advance(1.0 / 60, loads);
    EXPECT_FALSE(run.status().pull);
}

TEST(PreviewRun, LeadsTheHeldInstrumentNoFasterThanAHandGoes) {
    PreviewRun run;
    ASSERT_TRUE(run.take(prepareProject(makeSample("liver"))));
    const Eigen::Vector3d aside = boundingBox(run.positions()).max() + Eigen::Vector3d(0.5, 0.5, 0.5);
    PreviewLoads loads;
    loads.instrument = PlacedCollider{Capsule{0.005, 0.2}, {aside}};
    ASSERT_TRUE(run.advance(1.0 / 60, loads));
    EXPECT_EQ(run.heldInstrument().value().pose.place, aside) << "it comes where the hand has it";
    loads.instrument->pose.place.x() += 1;
    double before = aside.x();
    for (int frame = 0; frame < 1200 && before < aside.x() + 1; ++frame) {
        ASSERT_TRUE(run.advance(1.0 / 60, loads));
        const double now = run.heldInstrument().value().pose.place.x();
        // A slow machine simulates less than the frame, never more than two and a step.
        EXPECT_LE(now - before, 2.0 / 60 + run.status().timeStep + 1e-9);
        before = now;
    }
    EXPECT_EQ(before, aside.x() + 1) << "and arrives";
    loads.instrument.reset();
    ASSERT_TRUE(run.advance(1.0 / 60, loads));
    EXPECT_FALSE(run.heldInstrument());
}

TEST(PreviewRun, PlaysTheScenesLoadsFromRestToItsEnd) {
    Project project = makeSample("liver");
    const std::vector<Eigen::Vector3d>& rest = project.network->restPositions;
    const auto top = static_cast<std::uint32_t>(
        std::max_element(rest.begin(), rest.end(),
                         [](const auto& a, const auto& b) { return a.z() < b.z(); }) -
        rest.begin());
    project.scene.duration = 0.2;
    project.scene.moves = {{top, {{0, {0, 0, 0}}, {0.2, {0, 0, 0.01}}}}};
    project.scene.instruments = {{Sphere{0.01}, {{0, {0, 0, 1}}, {0.2, {0.1, 0, 1}}}, {}, {}}};
    PreviewRun run;
    ASSERT_TRUE(run.take(prepareProject(project)));
    EXPECT_TRUE(run.sceneInstruments().empty());
    ASSERT_TRUE(run.advance(0.1, {}));
    EXPECT_LT((run.positions()[top] - rest[top]).norm(), 1e-6) << "nothing of it without being asked";
    run.beginScene();
    PreviewLoads loads;
    loads.pull = Pull{top, rest[top] - Eigen::Vector3d(0, 0, 0.05)};
    int frames = 0;
    while (run.advance(1.0 / 60, loads) && frames < 1000)
        ++frames;
    EXPECT_TRUE(run.status().failure.empty()) << "it is over";
    EXPECT_LT((run.positions()[top] - rest[top] - Eigen::Vector3d(0, 0, 0.01)).norm(), 1e-6)
        << "what the scene leads the hand cannot hold";
    ASSERT_EQ(run.sceneInstruments().size(), 1U) << "still to be seen";
    EXPECT_NEAR(run.sceneInstruments()[0].pose.place.x(), 0.1, 1e-6);
    EXPECT_TRUE(run.advance(1.0 / 60, {})) << "played on without the scene";
    EXPECT_TRUE(run.sceneInstruments().empty());
}

TEST(PreviewRun, PlaysNoOtherSceneToTheEndOfThisOne) {
    Project project = makeSample("liver");
    project.scene.duration = 1;
    project.scene.moves = {{40, {{0, {0, 0, 0}}, {1, {0, 0, 0.01}}}}};
    PreviewRun run;
    ASSERT_TRUE(run.take(prepareProject(project)));
    run.beginScene();
    ASSERT_TRUE(run.advance(0.1, {}));
    project.base.viscosity *= 1.1;
    ASSERT_TRUE(run.take(prepareProject(project)));
    ASSERT_TRUE(run.advance(0.1, {}));
    const std::vector<Eigen::Vector3d>& rest = project.network->restPositions;
    EXPECT_NEAR(run.positions()[40].z() - rest[40].z(), 0.002, 0.0005) << "it goes on in another tissue";
    project.scene.moves = {{40, {{0, {0, 0, 0}}, {1, {0, 0, -0.1}}}}};
    ASSERT_TRUE(run.take(prepareProject(project)));
    ASSERT_TRUE(run.advance(0.1, {}));
    EXPECT_GT(run.positions()[40].z(), rest[40].z()) << "where it was, and let go";
}

TEST(PreviewRun, StepsAsTheProjectSays) {
    Project tube = makeSample("tube");
    PreviewRun run;
    ASSERT_TRUE(run.take(prepareProject(tube)));
    const Integrator automatic = *run.status().integrator;
    tube.stepping = {{Integrator::Bdf2, 0.004, Precision::Double}, 0.01, 1};
    ASSERT_TRUE(run.take(prepareProject(tube)));
    EXPECT_EQ(run.status().integrator, Integrator::Bdf2);
    EXPECT_EQ(run.status().timeStep, 0.004);
    tube.stepping.reset();
    ASSERT_TRUE(run.take(prepareProject(tube)));
    EXPECT_EQ(run.status().integrator, automatic);
}

TEST(PreviewRun, ShortensStepsThatAreTooLongToBeWatched) {
    Project tube = makeSample("tube");
    tube.stepping = {{Integrator::Split2, 0.1, Precision::Double}, 0.01, 1};
    PreviewRun run;
    ASSERT_TRUE(run.take(prepareProject(tube)));
    EXPECT_DOUBLE_EQ(run.status().timeStep, 0.1 / 3);
    EXPECT_TRUE(run.status().isShortened);
    tube.stepping->stepping.timeStep = longestWatchedStep;
    ASSERT_TRUE(run.take(prepareProject(tube)));
    EXPECT_EQ(run.status().timeStep, longestWatchedStep);
    EXPECT_FALSE(run.status().isShortened);
    tube.stepping.reset();
    ASSERT_TRUE(run.take(prepareProject(tube)));
    EXPECT_FALSE(run.status().isShortened);
}

namespace {

Project filledLiver(double stiffness) {
    Project liver = makeSample("liver");
    fillPart(liver, 0, stiffness);
    return liver;
}

/// The share of its volume at rest to which a liver is pressed by an instrument, in turn the smallest.
double leastShareWhilePressed(PreviewRun& run) {
    const Eigen::AlignedBox3d box = boundingBox(run.positions());
    double least = 1;
    PreviewLoads loads;
    for (int frame = 0; frame < 60; ++frame) {
        const double depth = 0.01 * frame / 60;
        loads.instrument = sphereAt({box.center().x(), box.center().y(), box.max().z() + 0.03 - depth}, 0.03);
        EXPECT_TRUE(run.advance(1.0 / 60, loads)) << run.status().failure;
        const PreviewStatus status = run.status();
        if (!status.fluids.empty()) least = std::min(least, status.fluids.front().share);
    }
    EXPECT_TRUE(run.status().instrument) << "it touches the organ";
    return least;
}

double volumeOf(const PreviewRun& run, const Project& project) {
    return enclosedVolume({run.positions(), simulatedSurface(*project.mesh, *project.network)});
}

} // namespace

TEST(PreviewRun, KeepsTheVolumeOfWhatIsFilledWhileItIsPressed) {
    const Project dry = makeSample("liver");
    const double volume = fillableParts(*dry.mesh, *dry.network).front().volume;
    const Project filled = filledLiver(usualFluidStiffness(dry.base.springConstant, volume));
    PreviewRun run;
    ASSERT_TRUE(run.take(prepareProject(filled)));
    EXPECT_GT(leastShareWhilePressed(run), 0.999);
    const PartNow now = run.status().fluids.at(0);
    EXPECT_EQ(now.part, 0U);
    EXPECT_NEAR(now.volume, volumeOf(run, filled), 1e-9 * volume);
    EXPECT_NEAR(now.share, now.volume / volume, 1e-9);
    EXPECT_NEAR(now.pressure, filled.scene.fillings[0].stiffness * (1 - now.share), 1e-6);
    EXPECT_GT(now.pressure, 0);
    ASSERT_TRUE(run.take(prepareProject(dry))) << "the same organ goes on without it";
    EXPECT_TRUE(run.status().fluids.empty());
    leastShareWhilePressed(run);
    EXPECT_LT(volumeOf(run, dry), 0.998 * volume);
}

TEST(PreviewRun, PressesFromWithinByWhatIsThereFromTheBeginning) {
    Project liver = makeSample("liver");
    pressPart(liver, 0, 20);
    PreviewRun run;
    ASSERT_TRUE(run.take(prepareProject(liver)));
    for (int frame = 0; frame < 30; ++frame)
        ASSERT_TRUE(run.advance(1.0 / 60, {}));
    EXPECT_GT(run.status().fluids.at(0).share, 1.001);
    EXPECT_DOUBLE_EQ(run.status().fluids.at(0).pressure, 20);

    liver.scene.pressures = {{0, {{0, 0}, {1, 20}}}};
    ASSERT_TRUE(run.take(prepareProject(liver)));
    run.reset();
    for (int frame = 0; frame < 30; ++frame)
        ASSERT_TRUE(run.advance(1.0 / 60, {}));
    EXPECT_EQ(run.status().fluids.at(0).pressure, 0) << "a path is the scene's, which does not play";
    run.beginScene();
    for (int frame = 0; frame < 30; ++frame)
        run.advance(1.0 / 60, {});
    EXPECT_GT(run.status().fluids.at(0).pressure, 0);
}

TEST(PreviewRun, StopsWithAWordWhereAPressureBurstsTheOrgan) {
    Project liver = makeSample("liver");
    liver.scene.tethers.clear(); // which would bear a part of it
    pressPart(liver, 0, 1e5);
    PreviewRun run;
    ASSERT_TRUE(run.take(prepareProject(liver)));
    for (int frame = 0; frame < 2000 && run.isReady(); ++frame)
        run.advance(1.0 / 60, {});
    EXPECT_FALSE(run.isReady());
    EXPECT_NE(run.status().failure.find("bursts part 1"), std::string::npos) << run.status().failure;
    pressPart(liver, 0, 0);
    EXPECT_TRUE(run.take(prepareProject(liver)));
    run.reset();
    EXPECT_TRUE(run.advance(1.0 / 60, {}));
}
