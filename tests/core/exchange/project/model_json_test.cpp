#include "core/exchange/project/model_json.h"

#include "core/support/errors.h"

#include <gmock/gmock.h>

namespace esm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using ModelJson = nlohmann::ordered_json;

/// Why a file of this version is refused by a program that knows version 2; empty when it is not.
std::string refusal(const ModelJson& file, std::vector<std::string>& problems) {
    try {
        refuseNewerVersion(JsonReader(file, "", problems), 2);
        return {};
    } catch (const InvalidModel& error) {
        return error.what();
    }
}

TEST(ModelJson, RefusesOnlyNewerVersions) {
    std::vector<std::string> problems;
    EXPECT_EQ(refusal({{"version", 1}}, problems), "");
    EXPECT_EQ(refusal({{"version", 2}}, problems), "");
    EXPECT_THAT(refusal({{"version", 3}}, problems), HasSubstr("newer version (3)"));
    EXPECT_THAT(problems, IsEmpty());
}

TEST(ModelJson, NotesAVersionThatIsNone) {
    for (const ModelJson& file :
         {ModelJson{{"version", 0}}, ModelJson{{"version", "1"}}, ModelJson::object()}) {
        std::vector<std::string> problems;
        EXPECT_EQ(refusal(file, problems), "");
        EXPECT_THAT(problems, ElementsAre(HasSubstr("version")));
    }
}

TEST(ModelJson, BringsTheBaseTissueBackBitByBit) {
    BaseTissue base;
    base.springConstant = 0.1 + 0.2;
    base.viscosity = 1e-300;
    base.mass = 1.0 / 3;
    std::vector<std::string> problems;
    const ModelJson written = ModelJson::parse(writtenFields(base).dump());
    const BaseTissue read = valueFrom<BaseTissue>(JsonReader(written, "base", problems));
    EXPECT_EQ(read.springConstant, base.springConstant);
    EXPECT_EQ(read.viscosity, base.viscosity);
    EXPECT_EQ(read.mass, base.mass);
    EXPECT_THAT(problems, IsEmpty());
}

TEST(ModelJson, NotesEveryMissingValueOfTheBaseTissue) {
    std::vector<std::string> problems;
    const ModelJson file{{"viscosity", 1}};
    valueFrom<BaseTissue>(JsonReader(file, "base", problems));
    EXPECT_THAT(problems, ElementsAre(HasSubstr("base.springConstant"), HasSubstr("base.mass")));
}

TEST(ModelJson, BringsBiphasicSpringsBackBitByBit) {
    BaseTissue base;
    EXPECT_FALSE(writtenFields(base).contains("stiffening"));
    base.stiffening = SpringStiffening{0.1 + 0.2, 1.0 / 3};
    std::vector<std::string> problems;
    const ModelJson written = ModelJson::parse(writtenFields(base).dump());
    const BaseTissue read = valueFrom<BaseTissue>(JsonReader(written, "base", problems));
    EXPECT_THAT(problems, IsEmpty());
    ASSERT_TRUE(read.stiffening);
    EXPECT_EQ(read.stiffening->strain, base.stiffening->strain);
    EXPECT_EQ(read.stiffening->factor, base.stiffening->factor);
}

TEST(ModelJson, TakesTheOldestVersionThatHoldsAll) {
    EXPECT_EQ(versionOf({}), 1);
    EXPECT_EQ(versionOf({true, false, false}), 2);
    EXPECT_EQ(versionOf({false, true, false}), 3);
    EXPECT_EQ(versionOf({true, true, false}), 3);
    EXPECT_EQ(versionOf({false, false, true}), 4);
    EXPECT_EQ(versionOf({true, true, true}), 4);
    EXPECT_EQ(versionOf({false, false, false, true}), 5);
    EXPECT_EQ(versionOf({true, true, true, true}), 5);
    VersionNeeds several;
    several.instruments = true;
    EXPECT_EQ(versionOf(several), 9);
    VersionNeeds split;
    split.splits = true;
    EXPECT_EQ(versionOf(split), 9);
    VersionNeeds shaped = several;
    shaped.shapedMasks = true;
    EXPECT_EQ(versionOf(shaped), 10);
    VersionNeeds retouched = shaped, finished = shaped;
    retouched.retouching = true;
    EXPECT_EQ(versionOf(retouched), 11);
    finished.finish = true;
    EXPECT_EQ(versionOf(finished), 11);
    EXPECT_EQ(versionOf({false, false, false, false, true}), 6);
    EXPECT_EQ(versionOf({true, true, true, true, true}), 6);
    EXPECT_EQ(versionOf({true, true, true, true, true, true}), 7);
    EXPECT_EQ(versionOf({true, true, true, true, true, true, true}), 8);
}

TEST(ModelJson, TurnsPointsIntoOneListAndBack) {
    const std::vector<Eigen::Vector3d> points{{1, 2, 3}, {-4, 5.5, 6}};
    EXPECT_THAT(coordinatesOf(points), ElementsAre(1, 2, 3, -4, 5.5, 6));
    EXPECT_EQ(pointsOf(coordinatesOf(points)), points);
    EXPECT_EQ(pointsOf(std::vector<float>{1, 2, 3}), (std::vector<Eigen::Vector3d>{{1, 2, 3}}));
    EXPECT_THAT(pointsOf(std::vector<double>{}), IsEmpty());
}

TEST(ModelJson, TurnsTrianglesIntoOneListAndBack) {
    const std::vector<Triangle> triangles{{0, 1, 2}, {2, 1, 3}};
    EXPECT_THAT(cornersOf(triangles), ElementsAre(0, 1, 2, 2, 1, 3));
    EXPECT_EQ(trianglesOf(cornersOf(triangles)), triangles);
}

} // namespace
} // namespace esm
