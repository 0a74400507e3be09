#include "core/model/scene_cavities.h"
#include "core/support/errors.h"
#include "tests/support/tissue_models.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

using namespace esm;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

std::string cavitiesRefusal(const Scene& scene, const SpringNetwork& network,
                            const std::vector<Triangle>& surface) {
    try {
        cavitiesOf(scene, network, surface);
    } catch (const InvalidModel& refused) {
        return refused.what();
    }
    return {};
}

std::vector<std::string> sceneProblems(const Scene& scene) {
    return validate(scene, 10);
}

} // namespace

TEST(SceneCavities, AreThePartsThatAreFilledOrPressedEachOnce) {
    const TriangleMesh ball = tissue::sphereMesh(1, 1);
    const SpringNetwork network = networkFromMesh(ball);
    Scene scene;
    EXPECT_TRUE(cavitiesOf(scene, network, ball.triangles).empty());
    scene.pressures = {{0, {{0, 10}, {1, -30}, {2, 20}}}};
    ASSERT_EQ(cavitiesOf(scene, network, ball.triangles).size(), 1U);
    EXPECT_EQ(cavitiesOf(scene, network, ball.triangles)[0].stiffness, 0);
    EXPECT_EQ(cavitiesOf(scene, network, ball.triangles)[0].largestPressure, 30);
    EXPECT_EQ(cavitiesOf(scene, network, ball.triangles)[0].initialPressure, 10);
    scene.fillings = {{0, 5000}};
    ASSERT_EQ(cavitiesOf(scene, network, ball.triangles).size(), 1U);
    EXPECT_EQ(cavitiesOf(scene, network, ball.triangles)[0].stiffness, 5000);
    EXPECT_EQ(cavitiesOf(scene, network, ball.triangles)[0].largestPressure, 30);
}

TEST(SceneCavities, BeginWithThePressureAtTimeZero) {
    const TriangleMesh ball = tissue::sphereMesh(1, 1);
    const SpringNetwork network = networkFromMesh(ball);
    const auto initial = [&](const std::vector<PressurePoint>& path) {
        Scene scene;
        scene.pressures = {{0, path}};
        return cavitiesOf(scene, network, ball.triangles)[0].initialPressure;
    };
    EXPECT_EQ(initial({{0, 0}, {1, 2000}}), 0) << "it rises in the scene";
    EXPECT_EQ(initial({{0, -20}}), -20);
    EXPECT_EQ(initial({{0.5, 70}, {1, 0}}), 70) << "as before its first row";
    EXPECT_EQ(initial({{-1, 0}, {1, 100}}), 50);
}

TEST(SceneCavities, AreRefusedUnderTheEntryThatNamesThem) {
    TriangleMesh ball = tissue::sphereMesh(1, 1);
    SpringNetwork network = networkFromMesh(ball);
    Scene scene;
    scene.fillings = {{0, 5000}};
    scene.pressures = {{0, {{0, 10}}}, {1, {{0, 10}}}};
    EXPECT_THAT(cavitiesRefusal(scene, network, ball.triangles),
                HasSubstr("pressures[1]: there is no part 1"));
    ball.triangles.pop_back();
    EXPECT_THAT(cavitiesRefusal(scene, network, ball.triangles),
                HasSubstr("fillings[0]: part 0 of the surface is open"));
    network.lattice.emplace();
    EXPECT_THAT(cavitiesRefusal(scene, network, ball.triangles),
                HasSubstr("fillings[0]: a lattice fills this organ"));
}

TEST(ScenePressure, IsLinearBetweenItsPointsAndConstantOutside) {
    const PartPressure pressure{0, {{1, 100}, {2, 300}, {4, -100}}};
    EXPECT_EQ(pressureAt(pressure, 0), 100);
    EXPECT_EQ(pressureAt(pressure, 1.25), 150);
    EXPECT_EQ(pressureAt(pressure, 2), 300);
    EXPECT_EQ(pressureAt(pressure, 3), 100);
    EXPECT_EQ(pressureAt(pressure, 9), -100);
}

TEST(SceneFluids, AreRefusedWhereTheyCannotBe) {
    Scene scene;
    scene.fillings = {{0, 1e5}, {3, 1e-3}};
    scene.pressures = {{0, {{0, 0}, {1, 2000}}}};
    EXPECT_THAT(sceneProblems(scene), testing::IsEmpty());
    for (const double stiffness : {0.0, -1.0, 2e30, std::numeric_limits<double>::quiet_NaN()}) {
        scene.fillings[1].stiffness = stiffness;
        EXPECT_THAT(sceneProblems(scene),
                    ElementsAre(HasSubstr("fillings[1]: the stiffness of the fluid must be above 0")));
    }
    scene.fillings = {{2, 1}, {2, 1}};
    EXPECT_THAT(sceneProblems(scene),
                ElementsAre(HasSubstr("fillings[1]: part 2 stands in an earlier entry too")));
    scene.fillings.clear();
    scene.pressures = {{0, {{0, 0}, {1, 2}, {1, 3}}}, {1, {}}, {0, {{0, 2e30}}}};
    EXPECT_THAT(sceneProblems(scene),
                ElementsAre(HasSubstr("pressures[0]: 1 point not later than the one before it (point 2)"),
                            HasSubstr("pressures[1]: the path has no point; give [time, pressure]"),
                            HasSubstr("pressures[2]: part 0 stands in an earlier entry too"),
                            HasSubstr("pressures[2]: 1 point with a pressure beyond 1e+30 Pa")));
    scene.pressures = {{0, {{0, std::numeric_limits<double>::infinity()}}}};
    EXPECT_THAT(sceneProblems(scene), ElementsAre(HasSubstr("not finite")));
    scene.pressures.clear();
    for (std::uint32_t part = 0; part < 17; ++part)
        scene.fillings.push_back({part, 1});
    EXPECT_THAT(sceneProblems(scene), ElementsAre(HasSubstr("no more than 16 parts")));
}
