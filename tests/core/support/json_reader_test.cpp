#include "core/support/json_reader.h"

#include "core/support/errors.h"
#include "tests/core/exchange/overwrite.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <cmath>

namespace esm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using ParsedJson = nlohmann::ordered_json;

ParsedJson parsed(const std::string& text) {
    return parseJson(text.data(), text.data() + text.size());
}

std::string parseError(const std::string& text) {
    try {
        parsed(text);
    } catch (const InvalidModel& error) {
        return error.what();
    }
    return "parsed";
}

std::string objectOf(int members) {
    std::string text = "{";
    for (int i = 0; i < members; ++i)
        text += (i > 0 ? ", \"" : "\"") + std::to_string(i) + "\": 0";
    return text + "}";
}

TEST(ParseJson, RefusesKeysLongerThanAnyName) {
    const auto withKey = [](std::size_t length) { return "{\"" + std::string(length, 'k') + "\": {}}"; };
    EXPECT_EQ(parseError(withKey(1000)), "parsed");
    EXPECT_THAT(parseError(withKey(1 << 20)), HasSubstr("there is a key of 1048576 bytes"));
}

TEST(ParseJson, KeepsTheOrderOfMembers) {
    EXPECT_EQ(parsed(R"({"b": 1, "a": [1.5, null, true]})").dump(), R"({"b":1,"a":[1.5,null,true]})");
}

TEST(ParseJson, NamesThePlaceOfAnError) {
    EXPECT_THAT(parseError("{\"a\": 1,\n \"b\": }"), HasSubstr("line 2, column 7"));
    EXPECT_THAT(parseError(""), HasSubstr("line 1"));
    EXPECT_THAT(parseError("1e999"), HasSubstr("out of range"));
    EXPECT_THAT(parseError(R"({"a": {"b": 1, "b": 2}})"), HasSubstr("a.b is there twice"));
}

TEST(ParseJson, RefusesWhatWouldTakeForeverOrOverflow) {
    EXPECT_THAT(parseError(std::string(1000000, '[')), HasSubstr("nested"));
    EXPECT_EQ(parseError(std::string(90, '[') + std::string(90, ']')), "parsed");
    EXPECT_THAT(parseError(objectOf(60000)), HasSubstr("one member too many"));
    EXPECT_EQ(parseError(objectOf(2000)), "parsed");
    std::string list = "[{}";
    for (int i = 0; i < 500000; ++i)
        list += ",{}";
    EXPECT_EQ(parseError(list + "]"), "parsed"); // minutes, were each element compared with those before
    EXPECT_EQ(parseError("[" + objectOf(2000) + ", " + objectOf(2000) + "]"), "parsed");
}

TEST(ReadJsonFile, NamesTheFile) {
    const TemporaryFolder folder;
    overwrite(folder / "a.json", std::string("{"));
    EXPECT_THROW(readJsonFile(folder / "a.json"), FileError);
    EXPECT_THROW(readJsonFile(folder / "none.json"), FileError);
    overwrite(folder / "a.json", std::string("[2]"));
    EXPECT_EQ(readJsonFile(folder / "a.json"), ParsedJson::array({2}));
}

TEST(NonFiniteNumbers, AreNamedByTheirPlaces) {
    const ParsedJson json{{"a", {1.0, NAN}}, {"b", {{"c", INFINITY}}}, {"d", 2}};
    EXPECT_THAT(nonFiniteNumbers(json), ElementsAre("a[1]", "b.c"));
}

TEST(JsonReader, ReadsWhatIsThereWithoutProblems) {
    std::vector<std::string> problems;
    const ParsedJson json = parsed(
        R"({"name": "liver", "on": true, "size": 7, "at": [1, 2, 3], "list": ["a", "b"], "none": null})");
    const JsonReader reader(json, "", problems);
    EXPECT_EQ(reader.member("name").text(), "liver");
    EXPECT_TRUE(reader.member("on").flag());
    EXPECT_EQ(reader.member("size").integer(0, 7), 7U);
    EXPECT_EQ(reader.member("at").vector(), Eigen::Vector3d(1, 2, 3));
    EXPECT_THAT(reader.member("list").texts(), ElementsAre("a", "b"));
    EXPECT_FALSE(reader.has("none"));
    reader.allowOnly({"name", "on", "size", "at", "list", "none"});
    EXPECT_THAT(problems, ElementsAre());
}

TEST(JsonReader, NamesEveryProblemOnceByItsPlace) {
    std::vector<std::string> problems;
    const ParsedJson json =
        parsed(R"({"name": 1, "size": -1, "at": [1, 2], "parts": [{"kind": 3}], "odd": 0})");
    const JsonReader reader(json, "", problems);
    EXPECT_EQ(reader.member("name").text(), "");
    EXPECT_EQ(reader.member("size").integer(2, 9), 2U);
    EXPECT_EQ(reader.member("at").vector(), Eigen::Vector3d(0, 0, 0));
    EXPECT_EQ(reader.member("parts").elements().at(0).member("kind").text(), "");
    EXPECT_EQ(reader.member("missing").member("below").number(), 0);
    reader.allowOnly({"name", "size", "at", "parts"});
    EXPECT_THAT(problems,
                ElementsAre(HasSubstr("name should be a text"), HasSubstr("size should be a whole number"),
                            HasSubstr("at should be a list of 3"), HasSubstr("parts[0].kind"),
                            "missing is missing", HasSubstr("odd is not known")));
}

} // namespace
} // namespace esm
