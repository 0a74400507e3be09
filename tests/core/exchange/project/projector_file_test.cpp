#include "core/exchange/project/projector_file.h"

#include "core/support/errors.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>

using namespace esm;
using Json = nlohmann::ordered_json;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

Json valid() {
    return Json::parse(R"({"pose": [0,0,1,0.5, 1,0,0,0.25, 0,1,0,2, 0,0,0,1], "width": 0.2, "height": 0.1})");
}

std::vector<std::string> problems(const Json& json) {
    try {
        projectorFromJson(json);
    } catch (const InvalidModel& error) {
        return error.problems();
    }
    return {};
}

} // namespace

TEST(ProjectorFile, ReadsThePoseRowByRow) {
    const Projector projector = projectorFromJson(valid());
    EXPECT_EQ(projector.pose * Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(3.5, 1.25, 4));
    EXPECT_EQ(projector.width, 0.2);
    EXPECT_EQ(projector.height, 0.1);
    EXPECT_TRUE(projector.occlusion);
}

TEST(ProjectorFile, ComesBackBitByBit) {
    Projector projector;
    projector.pose = Eigen::Translation3d(0.1, -0.2, 1.0 / 3) *
                     Eigen::AngleAxisd(1.234, Eigen::Vector3d(1, 2, 3).normalized());
    projector.width = 0.123456789;
    projector.occlusion = false;
    const Projector back = projectorFromJson(Json::parse(toJson(projector).dump()));
    EXPECT_EQ(back.pose.matrix(), projector.pose.matrix());
    EXPECT_EQ(back.width, projector.width);
    EXPECT_EQ(back.height, projector.height);
    EXPECT_FALSE(back.occlusion);
}

TEST(ProjectorFile, ListsEveryProblem) {
    const Json json =
        Json::parse(R"({"width": -1, "height": "tall", "occlusion": 1, "colour": 3, "kind": "flat"})");
    EXPECT_THAT(problems(json), ElementsAre(HasSubstr("colour"), HasSubstr("pose"), HasSubstr("width"),
                                            HasSubstr("height"), HasSubstr("kind"), HasSubstr("occlusion")));
    EXPECT_THAT(problems(Json::parse("[1]")), ElementsAre(HasSubstr("object")));
}

TEST(ProjectorFile, RefusesAPoseThatIsNotRigid) {
    const auto withEntry = [](std::size_t i, double value) {
        Json json = valid();
        json["pose"][i] = value;
        return json;
    };
    EXPECT_THAT(problems(withEntry(2, 1.001)), ElementsAre(HasSubstr("scaling")));
    EXPECT_THAT(problems(withEntry(0, 0.001)), ElementsAre(HasSubstr("shearing")));
    EXPECT_THAT(problems(withEntry(2, -1)), ElementsAre(HasSubstr("mirroring")));
    EXPECT_THAT(problems(withEntry(12, 1)), ElementsAre(HasSubstr("last row")));
    EXPECT_THAT(problems(withEntry(2, 1 + 1e-8)), ElementsAre());
    Json shortPose = valid();
    shortPose["pose"].erase(15);
    EXPECT_THAT(problems(shortPose), ElementsAre(HasSubstr("16 numbers")));
}

TEST(ProjectorFile, TurnsAPoseOfFewDigitsToTheNearestRotation) {
    Json json = valid();
    json["pose"] = {0.7071, -0.7071, 0, 0.5, 0.7071, 0.7071, 0, 0.25, 0, 0, 1, 2, 0, 0, 0, 1};
    ASSERT_THAT(problems(json), ElementsAre());
    const Eigen::Isometry3d pose = projectorFromJson(json).pose;
    const Eigen::AngleAxisd eighth(std::acos(-1.0) / 4, Eigen::Vector3d::UnitZ());
    EXPECT_TRUE(pose.linear().isApprox(eighth.toRotationMatrix(), 1e-12));
    EXPECT_EQ(Eigen::Vector3d(pose.translation()), Eigen::Vector3d(0.5, 0.25, 2));
}

TEST(ProjectorFile, RefusesAPhotoOfNoUsableSize) {
    for (const char* key : {"width", "height"})
        for (const double length : {1e-308, 1e-7, 1001.0, 1e300, 0.0, -0.1}) {
            Json json = valid();
            json[key] = length;
            EXPECT_THAT(problems(json), ElementsAre(HasSubstr(key))) << length;
        }
}

namespace {

Json inPerspective(const std::string& rest) {
    return Json::parse(R"({"pose": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1])" + rest + "}");
}

} // namespace

TEST(ProjectorFile, ReadsAPerspectiveProjectorByFieldOfViewOrIntrinsics) {
    for (const char* rest : {R"(, "kind": "perspective", "fov": 60)", R"(, "fov": 60)",
                             R"(, "kind": "perspective", "fov": 60, "width": -1, "height": 0)"}) {
        const Projector projector = projectorFromJson(inPerspective(rest));
        EXPECT_EQ(projector.kind, ProjectorKind::Perspective) << rest;
        EXPECT_EQ(projector.fieldOfView, 60);
        EXPECT_FALSE(projector.intrinsics);
    }
    const Projector measured =
        projectorFromJson(inPerspective(R"(, "intrinsics": {"fx": 900, "fy": 910, "cx": -1, "cy": 2.5})"));
    EXPECT_EQ(measured.kind, ProjectorKind::Perspective);
    EXPECT_EQ(measured.intrinsics, (Intrinsics{900, 910, -1, 2.5}));
    EXPECT_EQ(projectorFromJson(valid()).kind, ProjectorKind::Parallel);
}

TEST(ProjectorFile, APerspectiveProjectorComesBackBitByBit) {
    Projector projector;
    projector.kind = ProjectorKind::Perspective;
    projector.fieldOfView = 100.0 / 3;
    projector.falloff = true;
    EXPECT_TRUE(projectorFromJson(Json::parse(toJson(projector).dump())) == projector);
    projector.fieldOfView = Projector().fieldOfView;
    projector.intrinsics = Intrinsics{1000.0 / 3, 2000.0 / 7, 0.1, -0.2};
    EXPECT_TRUE(projectorFromJson(Json::parse(toJson(projector).dump())) == projector);
}

TEST(ProjectorFile, FallsOffWithTheAngleOnlyWhereItSaysSo) {
    Json json = valid();
    EXPECT_FALSE(projectorFromJson(json).falloff);
    json["falloff"] = true;
    EXPECT_TRUE(projectorFromJson(json).falloff);
    EXPECT_FALSE(toJson(Projector()).contains("falloff")) << "older programs read what they understand";
}

TEST(ProjectorFile, RefusesACameraThatCannotBeWithOneMessageEach) {
    const std::pair<const char*, const char*> refusals[] = {
        {R"(, "kind": "perspective")", "fov"},
        {R"(, "fov": 0)", "fov must be from 0.1"},
        {R"(, "fov": 180)", "fov must be from 0.1"},
        {R"(, "fov": -40)", "fov must be from 0.1"},
        {R"(, "fov": "wide")", "fov"},
        {R"(, "fov": 60, "intrinsics": {"fx": 1, "fy": 1, "cx": 0, "cy": 0})", "leave one of them away"},
        {R"(, "intrinsics": {"fx": 0, "fy": 1, "cx": 0, "cy": 0})", "intrinsics.fx must be above 0"},
        {R"(, "intrinsics": {"fx": 1, "fy": -1, "cx": 0, "cy": 0})", "intrinsics.fy must be above 0"},
        {R"(, "intrinsics": {"fx": 1, "fy": 1e9, "cx": 0, "cy": 0})", "intrinsics.fy"},
        {R"(, "intrinsics": {"fx": 1, "fy": 1, "cx": 1e300, "cy": 0})", "intrinsics.cx"},
        {R"(, "intrinsics": {"fx": 1, "fy": 1, "cx": 0})", "intrinsics.cy"},
        {R"(, "intrinsics": {"fx": 1, "fy": 1, "cx": 0, "cy": 0, "k1": 0})", "k1"},
        {R"(, "intrinsics": [1, 1, 0, 0])", "intrinsics"},
        {R"(, "kind": "parallel", "fov": 60)", "perspective projector"},
        {R"(, "kind": "parallel", "intrinsics": {})", "perspective projector"},
        {R"(, "kind": "fisheye", "width": 1, "height": 1)", "kind should be parallel or perspective"}};
    for (const auto& [rest, problem] : refusals)
        EXPECT_THAT(problems(inPerspective(rest)), ElementsAre(HasSubstr(problem))) << rest;
}

TEST(ProjectorFile, NamesTheFileInEveryMessage) {
    const TemporaryFolder folder;
    const auto refusal = [&](const std::string& text) -> std::string {
        std::ofstream(folder / "pose.json") << text;
        try {
            readProjectorFile(folder / "pose.json");
        } catch (const FileError& error) {
            return error.what();
        }
        return "accepted";
    };
    const std::string file = (folder / "pose.json").string();
    for (const char* text :
         {"", "{", "null", "{}", R"({"width": 1e999})", R"({"pose": [1e999]})", "[[[[", "\xff\xfe"})
        EXPECT_THAT(refusal(text), HasSubstr(file + ": ")) << text;
    EXPECT_EQ(refusal(valid().dump()), "accepted");
    EXPECT_THROW(readProjectorFile(folder / "missing.json"), FileError);
}
