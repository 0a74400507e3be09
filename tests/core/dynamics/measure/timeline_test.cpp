#include "core/dynamics/measure/timeline.h"

#include <gmock/gmock.h>

#include <limits>

namespace esm {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// Where steps end, taken one by one.
std::vector<double> endsOf(Timeline timeline) {
    std::vector<double> ends;
    while (!timeline.isAtEnd()) {
        const TimeSpan span = timeline.next(never, 1);
        EXPECT_EQ(span.steps, 1);
        EXPECT_EQ(span.start, timeline.time());
        timeline.advance(span, 1);
        ends.push_back(timeline.time());
    }
    return ends;
}

Scene sceneOf(double duration) {
    Scene scene;
    scene.duration = duration;
    return scene;
}

auto near(std::vector<double> times) {
    return testing::Pointwise(testing::DoubleNear(1e-12), times);
}

TEST(Timeline, EndsWithTheScene) {
    EXPECT_THAT(endsOf({sceneOf(0.35), {0.1}, Integrator::Split, 9}), near({0.1, 0.2, 0.3, 0.35}));
    EXPECT_THAT(endsOf({sceneOf(0.3), {0.1}, Integrator::Split, 9}), near({0.1, 0.2, 0.3}));
    EXPECT_THAT(endsOf({sceneOf(0.05), {10}, Integrator::Euler, 9}), testing::ElementsAre(0.05));
}

TEST(Timeline, CutsWhereLoadsBeginEndOrTurn) {
    Scene scene = sceneOf(0.4);
    scene.forces = {{0, {1, 0, 0}, 0.12, 0.13}, {0, {1, 0, 0}, -1, 0.2}, {0, {1, 0, 0}, 0.25, 0.25}};
    scene.moves = {{1, {{0, {0, 0, 0}}, {0.24, {1, 0, 0}}, {0.31, {1, 0, 0}}}}};
    scene.instruments = {{Sphere{0.01}, {{0.05, {0, 0, 0}}, {0.06, {0, 0, 1}}, {0.07, {0, 0, 2}}}, {}, {}}};
    const auto ends = near({0.05, 0.07, 0.1, 0.12, 0.13, 0.2, 0.24, 0.3, 0.4});
    EXPECT_THAT(endsOf({scene, {0.1}, Integrator::Verlet, 9}), ends);
    EXPECT_THAT(endsOf({scene, {0.1}, Integrator::Propagation, 9}), ends);
}

TEST(Timeline, CutsWhereAnInstrumentBeginsToTurnOrTurnsOtherwise) {
    const auto turned = [](double degrees) {
        return Eigen::Quaterniond(Eigen::AngleAxisd(degrees * M_PI / 180, Eigen::Vector3d::UnitX()));
    };
    Scene scene = sceneOf(0.4);
    Path still;
    for (const double time : {0.05, 0.15, 0.25, 0.35})
        still.push_back({time, {0, 0, 0}});
    scene.instruments = {{Capsule{0.01, 0.1}, still, {turned(0), turned(90), turned(180), turned(170)}, {}}};
    EXPECT_THAT(endsOf({scene, {0.1}, Integrator::Verlet, 9}), near({0.05, 0.1, 0.2, 0.25, 0.3, 0.35, 0.4}))
        << "0.15 is no corner: it goes on turning";
}

TEST(Timeline, TakesTimesForTheSameThatRoundingSetsApart) {
    Scene scene = sceneOf(0.1 + 0.2 + 0.3);
    scene.forces = {{0, {1, 0, 0}, 0, 0.3}, {0, {1, 0, 0}, 0.1 + 0.2, 0.6}, {0, {1, 0, 0}, 1e-17, 0.35}};
    for (const Integrator integrator : {Integrator::Verlet, Integrator::Implicit})
        EXPECT_THAT(endsOf({scene, {0.1}, integrator, 9}), near({0.1, 0.2, 0.3, 0.35, 0.4, 0.5, 0.6}));
}

TEST(Timeline, HalvesNoStepToNothing) {
    Scene scene = sceneOf(0.4);
    scene.forces = {{0, {1, 0, 0}, 0.3, 0.3 + 3e-10}};
    for (const int halvings : {0, 1, 4, 12}) {
        double last = 0;
        for (const double end : endsOf({scene, {0.1, halvings}, Integrator::Verlet, 9})) {
            ASSERT_GE(end - last, 0.9e-10) << halvings;
            last = end;
        }
    }
}

TEST(Timeline, TakesAStepForWholeThatMissesACornerByRounding) {
    Scene scene = sceneOf(0.7);
    scene.forces = {{0, {1, 0, 0}, 0.3, 0.6}}; // 3·0.1 is a little more than 0.3
    Timeline timeline(scene, {0.1}, Integrator::Euler, 9);
    for (const auto& [end, steps] : {std::pair{0.3, 3U}, {0.6, 3U}, {0.7, 1U}}) {
        const TimeSpan span = timeline.next(never, 100);
        EXPECT_TRUE(span.isWhole);
        EXPECT_EQ(span.end, end);
        EXPECT_EQ(span.steps, steps);
        timeline.advance(span, span.steps);
    }
    EXPECT_TRUE(timeline.isAtEnd());
}

TEST(Timeline, TakesNoMoreStepsTogetherThanAreWanted) {
    Timeline timeline(sceneOf(1), {0.1}, Integrator::Euler, 9);
    EXPECT_EQ(timeline.next(0.25, 100).steps, 3);
    EXPECT_EQ(timeline.next(0.2, 100).steps, 2);
    EXPECT_EQ(timeline.next(never, 4).steps, 4);
    timeline.advance(timeline.next(never, 4), 1); // the others failed
    EXPECT_DOUBLE_EQ(timeline.time(), 0.1);
    EXPECT_EQ(timeline.next(never, 100).steps, 9);
}

TEST(Timeline, CutsForFewFactorisationsAndForcesFirst) {
    Scene scene = sceneOf(2);
    Path path;
    for (int i = 0; i < 15; ++i)
        path.push_back({0.1 * i + 0.003 * (i + 1), {i % 2 == 0 ? 0.0 : 1.0, 0, 0}});
    scene.moves = {{1, path}};
    scene.forces = {{0, {1, 0, 0}, 1.512, 1.534}};
    const Timeline timeline(scene, {0.1}, Integrator::Split2, 9);
    const std::vector<double> ends = endsOf(timeline);
    EXPECT_THAT(
        ends, testing::IsSupersetOf({testing::DoubleNear(1.512, 1e-12), testing::DoubleNear(1.534, 1e-12)}));
    EXPECT_GT(timeline.averagedCorners(), 0);
    EXPECT_LE(ends.size(), 20 + 8);
    EXPECT_EQ(endsOf({scene, {0.1}, Integrator::Rk4, 9}).size(), 20 + 17);
}

TEST(Timeline, CutsAsOftenAsItLikesWhereTheLengthsAreTheSame) {
    Scene scene = sceneOf(10);
    for (int i = 0; i < 100; ++i)
        scene.forces.push_back({0, {1, 0, 0}, 0.1 * i + 0.02, 0.1 * i + 0.03});
    const Timeline timeline(scene, {0.1}, Integrator::Split2, 9);
    EXPECT_EQ(timeline.averagedCorners(), 0);
    EXPECT_EQ(endsOf(timeline).size(), 300);
}

TEST(Timeline, HalvesWhatLiesBetweenCuts) {
    Scene scene = sceneOf(0.25);
    scene.forces = {{0, {1, 0, 0}, 0.12, 0.16}};
    const auto whole = endsOf({scene, {0.1}, Integrator::Euler, 9});
    EXPECT_THAT(whole, near({0.1, 0.12, 0.16, 0.2, 0.25}));
    const auto quarters = endsOf({scene, {0.1, 2}, Integrator::Euler, 9});
    EXPECT_THAT(quarters, near({0.025, 0.05, 0.075, 0.1,  0.105, 0.11, 0.115,  0.12,  0.13,   0.14,
                                0.15,  0.16, 0.17,  0.18, 0.19,  0.2,  0.2125, 0.225, 0.2375, 0.25}));
    EXPECT_EQ(Timeline(scene, {0.1, 2}, Integrator::Euler, 9).next(never, 100).steps, 4);
}

TEST(Timeline, DoesNotCutForLargeOrgansThatAreSolved) {
    Scene scene = sceneOf(0.3);
    scene.forces = {{0, {1, 0, 0}, 0.12, 0.13}};
    const Timeline timeline(scene, {0.1}, Integrator::Implicit, 1'000'000);
    EXPECT_THAT(endsOf(timeline), near({0.1, 0.2, 0.3}));
    EXPECT_EQ(timeline.averagedCorners(), 2);
}

} // namespace
} // namespace esm
