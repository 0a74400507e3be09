#include "core/exchange/project/scene_file.h"

#include "core/support/errors.h"
#include "core/support/file_io.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

using namespace esm;
using Json = nlohmann::ordered_json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

Json whole() {
    return Json::parse(R"({ "duration": 1.5, "gravity": [0, -9.81, 0],
  "fixed":   [ {"nodes": [0, 1, 2]},
               {"ellipsoid": {"centre": [1, 2, 3], "radii": [0.1, 1, 1], "axis": [0, 0, 2], "degrees": 90}} ],
  "tethers": [ {"every": 3, "spring_constant": 2.4, "viscosity": 10.7} ],
  "forces":  [ {"node": 12, "force": [0, 0, -1], "from": 0.25, "to": 1} ],
  "moves":   [ {"node": 13, "path": [[0, 0, 0, 0], [0.5, 0, 0, -0.01]]} ],
  "instrument": { "shape": "sphere", "radius": 0.003, "path": [[0, 0, 0, 0.1], [1, 0, 0, 0.05]] },
  "record":  { "every": 0.02, "nodes": [12, 13] } })");
}

std::vector<std::string> problemsOf(const Json& json) {
    try {
        sceneFromJson(json);
    } catch (const InvalidModel& error) {
        return error.problems();
    }
    return {};
}

std::vector<std::string> problemsWith(const char* pointer, const Json& value) {
    Json json = whole();
    json[Json::json_pointer(pointer)] = value;
    return problemsOf(json);
}

} // namespace

TEST(SceneFile, ReadsEveryPart) {
    const Scene scene = sceneFromJson(whole());
    EXPECT_EQ(scene.duration, 1.5);
    EXPECT_EQ(scene.gravity, Eigen::Vector3d(0, -9.81, 0));
    ASSERT_EQ(scene.fixed.size(), 2);
    EXPECT_THAT(scene.fixed[0].nodes, ElementsAre(0, 1, 2));
    EXPECT_TRUE(contains(scene.fixed[1].ellipsoid.value(), {1.9, 2, 3}));
    EXPECT_FALSE(contains(scene.fixed[1].ellipsoid.value(), {1, 2.9, 3}));
    ASSERT_EQ(scene.tethers.size(), 1);
    EXPECT_EQ(scene.tethers[0].every, 3);
    EXPECT_EQ(scene.tethers[0].springConstant, 2.4);
    EXPECT_EQ(scene.tethers[0].viscosity, 10.7);
    ASSERT_EQ(scene.forces.size(), 1);
    EXPECT_EQ(scene.forces[0].node, 12);
    EXPECT_EQ(scene.forces[0].force, Eigen::Vector3d(0, 0, -1));
    EXPECT_EQ(scene.forces[0].from, 0.25);
    EXPECT_EQ(scene.forces[0].to, 1);
    ASSERT_EQ(scene.moves.size(), 1);
    EXPECT_EQ(scene.moves[0].node, 13);
    EXPECT_EQ(scene.moves[0].path[1].time, 0.5);
    EXPECT_EQ(scene.moves[0].path[1].value, Eigen::Vector3d(0, 0, -0.01));
    ASSERT_EQ(scene.instruments.size(), 1);
    EXPECT_EQ(scene.instruments[0].shape, Collider(Sphere{0.003}));
    EXPECT_EQ(scene.instruments[0].path[1].value, Eigen::Vector3d(0, 0, 0.05));
    EXPECT_EQ(scene.record.every, 0.02);
    EXPECT_THAT(scene.record.nodes.value(), ElementsAre(12, 13));
}

TEST(SceneFile, NeedsNothingButADuration) {
    const Scene scene = sceneFromJson(Json{{"duration", 2}});
    EXPECT_EQ(scene.duration, 2);
    EXPECT_EQ(scene.record.every, 0.01);
    EXPECT_FALSE(scene.record.nodes);
    EXPECT_TRUE(scene.instruments.empty());
    EXPECT_THAT(problemsOf(Json::object()), ElementsAre("duration is missing"));
}

TEST(SceneFile, LetsAForceActAllTheTimeUnlessToldOtherwise) {
    Json json = whole();
    json["forces"][0].erase("from");
    json["forces"][0].erase("to");
    EXPECT_EQ(sceneFromJson(json).forces[0].from, 0);
    EXPECT_EQ(sceneFromJson(json).forces[0].to, 1.5);
}

TEST(SceneFile, ComesBackBitByBit) {
    Scene scene = sceneFromJson(whole());
    scene.gravity.x() = 0.1 + 0.2;
    scene.fixed[1].ellipsoid->orientation = Eigen::Quaterniond(0.1, -0.7, 0.3, 0.2).normalized();
    const Scene again = sceneFromJson(Json::parse(toJson(scene).dump()));
    EXPECT_EQ(toJson(again), toJson(scene));
    EXPECT_EQ(again.gravity, scene.gravity);
    EXPECT_EQ(again.fixed[1].ellipsoid->orientation.coeffs(), scene.fixed[1].ellipsoid->orientation.coeffs());
    EXPECT_EQ(again.instruments[0].path[0].value, scene.instruments[0].path[0].value);
    EXPECT_EQ(again.record.nodes, scene.record.nodes);
    EXPECT_EQ(toJson(sceneFromJson(toJson(Scene{}))), toJson(Scene{}));
}

TEST(SceneFile, RecordsAllOrSomeNodes) {
    EXPECT_THAT(problemsWith("/record/nodes", "all"), IsEmpty());
    EXPECT_THAT(problemsWith("/record/nodes", Json::array()), IsEmpty());
    EXPECT_THAT(problemsWith("/record/nodes", "some"), ElementsAre(HasSubstr("\"all\" or a list")));
}

Json severalInstruments() {
    Json json = whole();
    json.erase("instrument");
    json["instruments"] = Json::parse(R"([
  {"shape": "capsule", "radius": 0.0025, "length": 0.2, "path": [[0, 0,0,0.1, 2,0,0,0], [1, 0,0,0.05, 0,0,-3,4]]},
  {"name": "blade", "shape": "sphere", "radius": 0.01, "path": [[0, 0,0,0.1]]} ])");
    return json;
}

std::vector<std::string> severalWith(const char* pointer, const Json& value) {
    Json json = severalInstruments();
    json[Json::json_pointer(pointer)] = value;
    return problemsOf(json);
}

TEST(SceneFile, ReadsSeveralInstrumentsThatTurn) {
    const Scene scene = sceneFromJson(severalInstruments());
    ASSERT_EQ(scene.instruments.size(), 2);
    EXPECT_EQ(scene.instruments[0].shape, Collider(Capsule{0.0025, 0.2}));
    ASSERT_EQ(scene.instruments[0].orientations.size(), 2);
    EXPECT_EQ(scene.instruments[0].orientations[0].coeffs(), Eigen::Quaterniond::Identity().coeffs());
    EXPECT_EQ(scene.instruments[0].orientations[1].coeffs(), Eigen::Quaterniond(0, 0, -0.6, 0.8).coeffs());
    EXPECT_EQ(nameOf(scene, 0), "instrument 0");
    EXPECT_EQ(nameOf(scene, 1), "blade");
    const Json written = toJson(scene);
    EXPECT_FALSE(written.contains("instrument"));
    EXPECT_EQ(toJson(sceneFromJson(Json::parse(written.dump()))), written);
}

TEST(SceneFile, WritesOnePlainSphereAsItAlwaysDid) {
    const Json written = toJson(sceneFromJson(whole()));
    EXPECT_EQ(written["instrument"].dump(),
              R"({"shape":"sphere","radius":0.003,"path":[[0.0,0.0,0.0,0.1],[1.0,0.0,0.0,0.05]]})");
    EXPECT_FALSE(written.contains("instruments"));
    Json listed = whole();
    listed["instruments"] = Json::array({listed["instrument"]});
    listed.erase("instrument");
    EXPECT_EQ(toJson(sceneFromJson(listed)), written) << "alone in a list it is the same";
}

TEST(SceneFile, RefusesInstrumentsInPlainWords) {
    EXPECT_THAT(problemsWith("/instrument/shape", "jaws"),
                ElementsAre("instrument.shape \"jaws\" is not offered yet; use \"sphere\" or \"capsule\""));
    EXPECT_THAT(problemsWith("/instrument/shape", "cube"), ElementsAre(HasSubstr("must be \"sphere\" or")));
    EXPECT_THAT(problemsWith("/instrument/length", 1), ElementsAre(HasSubstr("is for a capsule")));
    EXPECT_THAT(severalWith("/instrument", whole()["instrument"]), ElementsAre(HasSubstr("put all into")));
    EXPECT_THAT(severalWith("/instruments/0/path/1", {1, 0, 0, 0.05}),
                ElementsAre(AllOf(HasSubstr("instruments[0].path[1]"), HasSubstr("has no orientation"))));
    EXPECT_THAT(severalWith("/instruments/1/path/1", {1, 0, 0, 0.05, 1, 0, 0, 0}),
                ElementsAre(AllOf(HasSubstr("instruments[1].path[1]"), HasSubstr("has an orientation"))));
    EXPECT_THAT(severalWith("/instruments/0/path/1", {1, 0, 0, 0.05, 0, 0, 0, 0}),
                ElementsAre(AllOf(HasSubstr("instruments[0].path[1]"), HasSubstr("zero quaternion"))));
    EXPECT_THAT(severalWith("/instruments/0/path/1", {1, 0, 0}), ElementsAre(HasSubstr("a list of 8")));
    EXPECT_THAT(severalWith("/instruments/0/length", -1),
                ElementsAre(AllOf(HasSubstr("instruments[0]"), HasSubstr("length must be 0"))));
    EXPECT_THAT(severalWith("/instruments/0/name", "blade"),
                ElementsAre(AllOf(HasSubstr("instruments[1]"), HasSubstr("\"blade\" too"))));
    EXPECT_THAT(severalWith("/instruments/1/name", "instrument 0"),
                ElementsAre(HasSubstr("a name of its own")));
    for (const char* name : {"a,b", "a\nb", "a\"b", "  "})
        EXPECT_THAT(severalWith("/instruments/1/name", name), ElementsAre(HasSubstr("a name needs"))) << name;
    EXPECT_THAT(severalWith("/instruments/1/name", ""), ElementsAre(HasSubstr("is empty")));
    EXPECT_THAT(problemsWith("/moves/0/path/0", {0, 0, 0, 0, 1, 0, 0, 0}),
                ElementsAre(HasSubstr("a list of 4")));
}

TEST(SceneFile, ReadsAndWritesSplits) {
    Json json = whole();
    json["split"] =
        Json::parse(R"([ {"time": 0.2, "edges": [[12, 13], [13, 27]]}, {"time": 0, "edges": [[1, 2]]} ])");
    const Scene scene = sceneFromJson(json);
    ASSERT_EQ(scene.splits.size(), 2U);
    EXPECT_EQ(scene.splits[0], (SurfaceSplit{0.2, {{12, 13}, {13, 27}}}));
    EXPECT_EQ(toJson(scene)["split"], json["split"]);
    EXPECT_FALSE(toJson(sceneFromJson(whole())).contains("split"));
}

TEST(SceneFile, RefusesSplitsThatAreNone) {
    const auto splitWith = [](const char* text) { return problemsWith("/split", Json::parse(text)); };
    EXPECT_THAT(splitWith(R"([{"edges": [[1, 2]]}])"), ElementsAre(HasSubstr("split[0].time")));
    EXPECT_THAT(splitWith(R"([{"time": 0}])"), ElementsAre(HasSubstr("split[0].edges")));
    EXPECT_THAT(splitWith(R"([{"time": 0, "edges": []}])"),
                ElementsAre(HasSubstr("split[0]: name at least one")));
    EXPECT_THAT(splitWith(R"([{"time": -1, "edges": [[1, 2]]}])"),
                ElementsAre(HasSubstr("split[0].time must be 0 s or more")));
    EXPECT_THAT(splitWith(R"([{"time": 0, "edges": [[1, 2, 3]]}])"),
                ElementsAre(HasSubstr("split[0].edges[0] must be the two nodes of an edge")));
    EXPECT_THAT(splitWith(R"([{"time": 0, "edges": [[1, -2]]}])"),
                ElementsAre(HasSubstr("split[0].edges[0][1]")));
    EXPECT_THAT(splitWith(R"([{"time": 0, "edges": [1, 2]}])"), testing::SizeIs(2));
    EXPECT_THAT(splitWith(R"([{"time": 0, "edges": [[1, 2]], "depth": 1}])"),
                ElementsAre(HasSubstr("is not known here")));
}

TEST(SceneFile, RefusesKeysItDoesNotKnowAnywhere) {
    for (const char* pointer : {"/forse", "/fixed/0/node", "/fixed/1/ellipsoid/radius", "/tethers/0/every_n",
                                "/forces/0/until", "/moves/0/from", "/instrument/speed", "/record/frames"})
        EXPECT_THAT(problemsWith(pointer, 1), ElementsAre(HasSubstr("is not known here"))) << pointer;
}

TEST(SceneFile, ListsEveryProblemWithItsPlace) {
    Json json = whole();
    json["duration"] = "long";
    json["gravity"] = {0, 0};
    json["fixed"][0]["nodes"][1] = -1;
    json["fixed"][1]["ellipsoid"]["axis"] = {0, 0, 0};
    json["tethers"][0]["every"] = 0;
    json["forces"][0]["node"] = 1.5;
    json["moves"][0]["path"][1] = {0, 0, 0, 0};
    json["instrument"].erase("radius");
    json["record"]["every"] = -0.01;
    EXPECT_THAT(problemsOf(json), ElementsAre(HasSubstr("duration should be a number"),
                                              HasSubstr("gravity should be a list of 3"),
                                              HasSubstr("fixed[0].nodes[1] should be a whole number"),
                                              HasSubstr("fixed[1].ellipsoid.axis must have a length"),
                                              HasSubstr("tethers[0].every should be a whole number from 1"),
                                              HasSubstr("forces[0].node should be a whole number"),
                                              HasSubstr("record.every must be above 0 s"),
                                              HasSubstr("instrument.radius is missing"),
                                              HasSubstr("moves[0]: 1 point not later")));
}

TEST(SceneFile, RefusesEntriesOfAnotherKind) {
    for (const char* pointer :
         {"/fixed/0", "/fixed/1/ellipsoid", "/tethers/0", "/forces/0", "/moves/0", "/instrument", "/record"})
        EXPECT_THAT(problemsWith(pointer, 7), ElementsAre(HasSubstr("should be an object"))) << pointer;
    for (const char* pointer :
         {"/fixed", "/tethers", "/forces", "/moves", "/moves/0/path", "/instrument/path"})
        EXPECT_THAT(problemsWith(pointer, 7), ElementsAre(HasSubstr("should be a list"))) << pointer;
    EXPECT_THAT(problemsWith("/fixed/0", Json::object()), ElementsAre(HasSubstr("must name nodes")));
    EXPECT_THAT(problemsOf(Json::array()), ElementsAre(HasSubstr("object")));
}

TEST(SceneFile, NamesTheFileInItsMessages) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "scene.json", std::string("{\"duration\": 1,\n \"duration\": 2}"));
    try {
        readSceneFile(folder / "scene.json");
        FAIL() << "accepted";
    } catch (const FileError& error) {
        EXPECT_THAT(error.what(), AllOf(HasSubstr("scene.json: "), HasSubstr("duration is there twice")));
    }
    EXPECT_THROW(readSceneFile(folder / "missing.json"), FileError);
}
