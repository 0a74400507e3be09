#include "core/exchange/fields_json.h"

#include <gmock/gmock.h>

namespace esm {

enum class Grip { Forceps, Hook };
template<>
inline constexpr auto wordsOf<Grip> = std::array{Word{Grip::Forceps, "forceps"}, Word{Grip::Hook, "hook"}};

struct Jaw {
    double width = 1;
    bool operator==(const Jaw&) const = default;
};
template<>
inline constexpr auto fieldsOf<Jaw> = fieldTable(field("width", &Jaw::width,
                                                       positiveLimits("the width", "m")));

struct Tongs {
    Grip grip = Grip::Forceps;
    int teeth = 2;
    std::vector<Jaw> jaws;
    std::optional<Jaw> spare;
    std::string owner = "nobody";
    bool operator==(const Tongs&) const = default;
};
template<>
inline constexpr auto
    fieldsOf<Tongs> = fieldTable(field("grip", &Tongs::grip),
                                 field("teeth", &Tongs::teeth, Limits<int>{"the teeth", 1, 9}),
                                 field("jaws", &Tongs::jaws), field("spare", &Tongs::spare).whenSet(),
                                 field("owner", &Tongs::owner).mayBeAbsent());

struct Arm {
    std::string side;
    Tongs tongs;
    double reach = 1;
    bool operator==(const Arm&) const = default;
};
template<>
inline constexpr auto
    fieldsOf<Arm> = fieldTable(field("side", &Arm::side), fieldsOfMember(&Arm::tongs),
                               field("reach", &Arm::reach, positiveLimits("the reach", "m")).whenSet());

namespace {

using Json = nlohmann::ordered_json;
using testing::ElementsAre;
using testing::IsEmpty;

struct ReadTongs {
    Tongs tongs;
    std::vector<std::string> problems;
};

template<class Forms> ReadTongs tongsFrom(const char* text, const Forms& forms) {
    const Json json = Json::parse(text);
    ReadTongs read;
    readFields(JsonReader(json, "tongs", read.problems), read.tongs, forms);
    return read;
}

TEST(FieldsJson, StandInTheTablesOrderAndComeBack) {
    EXPECT_EQ(written(Tongs{}).dump(), R"({"grip":"forceps","teeth":2,"jaws":[],"owner":"nobody"})");
    const Tongs whole{Grip::Hook, 9, {{0.1}, {2}}, Jaw{3}, ""};
    const std::string text = written(whole).dump();
    EXPECT_EQ(text, R"({"grip":"hook","teeth":9,"jaws":[{"width":0.1},{"width":2.0}],)"
                    R"("spare":{"width":3.0},"owner":""})");
    const ReadTongs read = tongsFrom(text.c_str(), TypedForms());
    EXPECT_THAT(read.problems, IsEmpty());
    EXPECT_EQ(read.tongs, whole);
}

TEST(FieldsJson, MayLackWhatTheTableSays) {
    const ReadTongs read = tongsFrom(R"({"grip": "hook", "jaws": []})", PlainForms());
    EXPECT_THAT(read.problems, ElementsAre("tongs.teeth is missing"));
    EXPECT_EQ(read.tongs.owner, "nobody");
    EXPECT_FALSE(read.tongs.spare);
}

TEST(FieldsJson, TellEveryProblemWithItsPlace) {
    constexpr const char* bad = R"({"grip": "claw", "teeth": 10, "jaws": [{"width": 0, "with": 1}, 7]})";
    EXPECT_THAT(tongsFrom(bad, PlainForms()).problems,
                ElementsAre("tongs.grip should be forceps or hook",
                            "tongs.teeth should be a whole number from 1 to 9",
                            "tongs.jaws[1] should be an object in { }"));
    EXPECT_THAT(tongsFrom(bad, TypedForms()).problems,
                ElementsAre("tongs.grip should be forceps or hook",
                            "tongs.teeth should be a whole number from 1 to 9",
                            "tongs.jaws[0].with is not known here; known are width",
                            "tongs.jaws[0].width must be above 0 m",
                            "tongs.jaws[1] should be an object in { }"));
}

TEST(FieldsJson, OfAMemberStandAmongThoseOfTheStruct) {
    const Arm whole{"left", {Grip::Hook, 9, {}, std::nullopt, "us"}, 2};
    const Json json = written(whole);
    EXPECT_EQ(json.dump(), R"({"side":"left","grip":"hook","teeth":9,"jaws":[],"owner":"us","reach":2.0})");
    std::vector<std::string> problems;
    EXPECT_EQ(valueFrom<Arm>(JsonReader(json, "", problems), TypedForms()), whole);
    EXPECT_THAT(problems, IsEmpty());
    const Json bad = Json::parse(R"({"side": "left", "teeth": 10, "jaws": [], "width": 1})");
    valueFrom<Arm>(JsonReader(bad, "", problems), TypedForms());
    EXPECT_THAT(problems,
                ElementsAre("width is not known here; known are side, grip, teeth, jaws, spare, owner, reach",
                            "grip is missing", "teeth should be a whole number from 1 to 9"));
    EXPECT_THAT(fieldProblems(Arm{"left", {Grip::Hook, 10, {}, std::nullopt, ""}, 0}),
                ElementsAre("the reach must be above 0 m"));
}

struct NumberedJaws {
    std::vector<Jaw>& jaws;
    Json write(const Jaw& jaw) const {
        jaws.push_back(jaw);
        return jaws.size() - 1;
    }
    void read(const JsonReader& reader, Jaw& jaw) const { jaw = jaws[reader.integer(0, jaws.size() - 1)]; }
};

TEST(FieldsJson, LeaveToAFilesFormsWhatStandsElsewhere) {
    std::vector<Jaw> jaws;
    const Tongs whole{Grip::Hook, 1, {{0.1}, {2}}, Jaw{3}, ""};
    const std::string text = written(whole, NumberedJaws{jaws}).dump();
    EXPECT_EQ(text, R"({"grip":"hook","teeth":1,"jaws":[0,1],"spare":2,"owner":""})");
    EXPECT_EQ(tongsFrom(text.c_str(), NumberedJaws{jaws}).tongs, whole);
}

} // namespace
} // namespace esm
