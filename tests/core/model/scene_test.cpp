#include "core/model/scene.h"

#include <gmock/gmock.h>

#include <cmath>

using namespace esm;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

Scene soundScene() {
    Scene scene;
    scene.fixed = {{{0, 1}, Ellipsoid{}}};
    scene.tethers = {{3, 2.4, 10.7}};
    scene.forces = {{4, {0, 0, -1}, 0, 1}};
    scene.moves = {{2, {{0, {0, 0, 0}}, {0.5, {0, 0, -0.01}}}}};
    scene.instruments = {{Sphere{0.003}, {{0, {0, 0, 0.1}}}, {}, {}}};
    scene.record.nodes = std::vector<std::uint32_t>{0, 4};
    return scene;
}

} // namespace

TEST(Scene, TurnsAnInstrumentEvenlyTheShorterWay) {
    InstrumentMotion motion{Capsule{0.01, 0.1}, {{0, {0, 0, 0}}, {2, {2, 0, 0}}}, {}, {}};
    EXPECT_EQ(poseAt(motion, 1).orientation.coeffs(), Eigen::Quaterniond::Identity().coeffs());
    const Eigen::AngleAxisd quarter(M_PI / 2, Eigen::Vector3d::UnitY());
    const Eigen::Quaterniond turned(quarter);
    // The other sign is the same orientation, and asks for three quarters of a turn where signs are taken at
    // their word.
    motion.orientations = {Eigen::Quaterniond::Identity(), Eigen::Quaterniond(-turned.coeffs())};
    const ColliderPose half = poseAt(motion, 1);
    EXPECT_EQ(half.place, Eigen::Vector3d(1, 0, 0));
    EXPECT_LT(half.orientation.angularDistance(
                  Eigen::Quaterniond(Eigen::AngleAxisd(M_PI / 4, Eigen::Vector3d::UnitY()))),
              1e-7);
    EXPECT_EQ(poseAt(motion, -1).orientation.coeffs(), motion.orientations[0].coeffs());
    EXPECT_EQ(poseAt(motion, 3).orientation.coeffs(), motion.orientations[1].coeffs());
}

TEST(Path, IsLinearBetweenItsPointsAndConstantOutside) {
    const Path path{{1, {0, 0, 0}}, {2, {1, 0, 0}}, {4, {1, 2, 0}}};
    EXPECT_EQ(positionAt(path, 0), Eigen::Vector3d(0, 0, 0));
    EXPECT_EQ(positionAt(path, 1), Eigen::Vector3d(0, 0, 0));
    EXPECT_EQ(positionAt(path, 1.25), Eigen::Vector3d(0.25, 0, 0));
    EXPECT_EQ(positionAt(path, 2), Eigen::Vector3d(1, 0, 0));
    EXPECT_EQ(positionAt(path, 3), Eigen::Vector3d(1, 1, 0));
    EXPECT_EQ(positionAt(path, 4), Eigen::Vector3d(1, 2, 0));
    EXPECT_EQ(positionAt(path, 99), Eigen::Vector3d(1, 2, 0));
}

TEST(Path, WithOnePointStandsStill) {
    EXPECT_EQ(positionAt({{5, {1, 2, 3}}}, 0), Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(positionAt({{5, {1, 2, 3}}}, 9), Eigen::Vector3d(1, 2, 3));
}

TEST(Scene, ThatIsSoundHasNoProblem) {
    EXPECT_THAT(validate(soundScene(), 5), IsEmpty());
    EXPECT_THAT(validate(Scene{}, 1), IsEmpty());
}

TEST(Scene, MayHaveExtremeTimes) {
    for (const double time : {5e-324, 1e-300, 1e25, 1e308}) {
        Scene scene = soundScene();
        scene.duration = scene.record.every = time;
        EXPECT_THAT(validate(scene, 5), IsEmpty()) << time;
    }
}

TEST(Scene, BoundsItsTethers) {
    Scene scene = soundScene();
    scene.tethers = {{1, 1e30, 1e30}};
    EXPECT_THAT(validate(scene, 5), IsEmpty());
    scene.tethers = {{1, 2e30, 2e30}};
    EXPECT_THAT(validate(scene, 5), testing::SizeIs(2));
}

TEST(Scene, ReportsEveryProblemWithItsPlace) {
    Scene scene = soundScene();
    scene.duration = 0;
    scene.gravity.x() = NAN;
    scene.fixed[0].ellipsoid->radii.y() = 0;
    scene.tethers = {{0, -1, NAN}};
    scene.forces[0].to = -1;
    scene.moves[0].path[1].time = 0;
    scene.instruments[0].shape = Sphere{0};
    scene.record.every = 0;
    EXPECT_THAT(validate(scene, 5),
                ElementsAre(HasSubstr("duration"), HasSubstr("gravity"), HasSubstr("fixed[0].ellipsoid"),
                            AllOf(HasSubstr("tethers[0]"), HasSubstr("every")), HasSubstr("spring_constant"),
                            HasSubstr("viscosity"), HasSubstr("forces[0]"),
                            AllOf(HasSubstr("moves[0]"), HasSubstr("later")), HasSubstr("instrument"),
                            HasSubstr("record.every")));
}

TEST(Scene, NamesMissingNodesAndTheLastThereIs) {
    EXPECT_THAT(validate(soundScene(), 2),
                ElementsAre(AllOf(HasSubstr("forces[0]"), HasSubstr("no node 4"), HasSubstr("last is 1")),
                            AllOf(HasSubstr("moves[0]"), HasSubstr("no node 2")),
                            AllOf(HasSubstr("record.nodes"), HasSubstr("node 4"))));
}

TEST(Scene, ReportsAThousandMissingNodesInOneLine) {
    Scene scene;
    scene.fixed.emplace_back();
    for (std::uint32_t node = 10; node < 1010; ++node)
        scene.fixed[0].nodes.push_back(node);
    EXPECT_THAT(validate(scene, 10), ElementsAre(AllOf(HasSubstr("1000 nodes"), HasSubstr("10, 11, 12"))));
}

TEST(Scene, RefusesEmptyAndNonFinitePathsAndANodeMovedTwice) {
    Scene scene = soundScene();
    scene.moves.push_back(scene.moves[0]);
    scene.moves.push_back({3, {}});
    scene.instruments[0].path.push_back({INFINITY, {0, 0, 0}});
    EXPECT_THAT(validate(scene, 5), ElementsAre(AllOf(HasSubstr("moves[1]"), HasSubstr("node 2")),
                                                AllOf(HasSubstr("moves[2]"), HasSubstr("no point")),
                                                AllOf(HasSubstr("instrument"), HasSubstr("point 1"))));
}
