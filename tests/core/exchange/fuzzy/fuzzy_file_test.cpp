#include "core/exchange/fuzzy/fuzzy_file.h"

#include "core/fuzzy/inference.h"
#include "core/support/errors.h"
#include "core/support/file_io.h"
#include "tests/core/exchange/fuzzy/fuzzy_text_files.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

using namespace esm;
using Json = nlohmann::ordered_json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

std::string sound() {
    return R"({"name": "trial", "description": "how keen", "note": "made up",
 "inputs": {"zeal": {"range": [0, 1], "terms": {"much": [0.5, 1, 1, 1], "little": [0, 0, 0.5, 1]}},
            "age": {"range": [0, 9], "terms": {"old": [4, 9, 9, 9]}}},
 "outputs": {"viscosity": {"range": [0, 5], "terms": {"thick": [3, 4, 5, 5]}}},
 "rules": ["IF zeal IS much AND age IS old THEN viscosity IS thick"]})";
}

/// What reading the text as a file says.
std::string complaint(const std::string& text) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "trial.json", text);
    try {
        importFuzzyFile(folder / "trial.json");
    } catch (const FileError& error) {
        EXPECT_THAT(error.what(), HasSubstr("trial.json: "));
        return error.what();
    }
    return "accepted";
}

} // namespace

TEST(FuzzyFile, KeepsTheOrderOfVariablesAndTermsBothWays) {
    const FuzzySystem system = fuzzySystemFromJson(Json::parse(sound()));
    ASSERT_EQ(system.inputs.size(), 2);
    EXPECT_EQ(system.inputs[0].name, "zeal");
    EXPECT_EQ(system.inputs[0].terms[0].name, "much");
    EXPECT_EQ(system.inputs[0].terms[1].name, "little");
    EXPECT_EQ(system.inputs[1].name, "age");
    EXPECT_EQ(toJson(system), Json::parse(sound())); // compares the order of keys too
}

TEST(FuzzyFile, ComesBackAsItWasWritten) {
    const TemporaryFolder folder;
    FuzzySystem system = fuzzyPreset("robo-sim");
    system.inputs[0].terms[0].set.d = 1 + 0.1 + 0.2;
    system.note = "Grüße \"und\" mehr\n";
    writeFileAtomically(folder / "copy.json", toJson(system).dump(1));
    EXPECT_EQ(toJson(importFuzzyFile(folder / "copy.json").system), toJson(system));
}

TEST(FuzzyFile, WritesNormsAndWeightsOnlyWhereTheyAreNotTheUsual) {
    FuzzySystem system = fuzzySystemFromJson(Json::parse(sound()));
    EXPECT_FALSE(toJson(system).contains("norms"));
    system.norms.disjunction = TConorm::ProbabilisticSum;
    system.norms.implication = TNorm::BoundedDifference;
    system.rules[0].weight = 0.25;
    system.rules[0].condition = negation(system.rules[0].condition);
    const Json json = toJson(system);
    EXPECT_EQ(json["norms"],
              Json::parse(R"({"disjunction": "probabilistic-sum", "implication": "bounded-difference"})"));
    EXPECT_THAT(json["rules"],
                ElementsAre("IF NOT (zeal IS much AND age IS old) THEN viscosity IS thick WITH 0.25"));
    const FuzzySystem read = fuzzySystemFromJson(json);
    EXPECT_TRUE(read.norms == system.norms);
    EXPECT_EQ(toJson(read), json);
}

TEST(FuzzyFile, KeepsAUnitWhereAVariableHasOne) {
    FuzzySystem system = fuzzySystemFromJson(Json::parse(sound()));
    EXPECT_FALSE(toJson(system)["inputs"]["age"].contains("unit"));
    system.inputs[1].unit = "µm²";
    EXPECT_EQ(toJson(system)["inputs"]["age"]["unit"], "µm²");
    EXPECT_EQ(fuzzySystemFromJson(toJson(system)), system);
    system.inputs[1].unit = "a\nb";
    EXPECT_THAT(complaint(toJson(system).dump()), HasSubstr("inputs.age.unit: must be one line"));
}

TEST(FuzzyFile, ReadsEveryNorm) {
    for (const char* t : {"minimum", "product", "bounded-difference"})
        for (const char* s : {"maximum", "probabilistic-sum", "bounded-sum"}) {
            Json json = Json::parse(sound());
            json["norms"] = {{"conjunction", t}, {"disjunction", s}, {"implication", t}, {"aggregation", s}};
            const FuzzyNorms norms = fuzzySystemFromJson(json).norms;
            EXPECT_STREQ(wordOf(norms.conjunction), t);
            EXPECT_STREQ(wordOf(norms.disjunction), s);
            EXPECT_STREQ(wordOf(norms.implication), t);
            EXPECT_STREQ(wordOf(norms.aggregation), s);
        }
}

TEST(FuzzyFile, RefusesNormsThatThereAreNot) {
    const auto withNorms = [](const std::string& norms) {
        return complaint(withReplaced(sound(), "\"rules\"", "\"norms\": " + norms + ", \"rules\""));
    };
    EXPECT_EQ(withNorms("{}"), "accepted");
    EXPECT_THAT(
        withNorms(R"({"conjunction": "maximum"})"),
        HasSubstr("norms.conjunction is \"maximum\"; it may be minimum, product, bounded-difference"));
    EXPECT_THAT(
        withNorms(R"({"aggregation": "sum", "disjunction": 7})"),
        AllOf(HasSubstr("norms.disjunction should be a text"),
              HasSubstr("norms.aggregation is \"sum\"; it may be maximum, probabilistic-sum, bounded-sum")));
    EXPECT_THAT(withNorms(R"({"activation": "minimum"})"), HasSubstr("norms.activation is not known here"));
    EXPECT_THAT(withNorms("\"product\""), HasSubstr("norms should be an object"));
}

TEST(FuzzyFile, RefusesMoreRulesThanAnyoneReads) {
    Json json = Json::parse(sound());
    const Json rule = json["rules"][0];
    for (int i = 1; i < 10000; ++i)
        json["rules"].push_back(rule);
    EXPECT_THAT(complaint(json.dump()), HasSubstr("rules: there are 10000; a system may have 2000"));
    json["rules"] = {"IF " + std::string(10000, '(') + "zeal IS much"};
    EXPECT_THAT(complaint(json.dump()), HasSubstr("rules[0], column 104: brackets and NOT are nested"));
}

TEST(FuzzyFile, NamesAnUnnamedSystemAfterItsFile) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "liver.json", withReplaced(sound(), R"("name": "trial", )", ""));
    EXPECT_EQ(importFuzzyFile(folder / "liver.json").system.name, "liver");
}

TEST(FuzzyFile, SaysWhichEncodingItIsIn) {
    EXPECT_EQ(complaint("\xEF\xBB\xBF" + sound()), "accepted");
    EXPECT_THAT(complaint(withReplaced(sound(), "how", "h\xF6w")),
                HasSubstr("line 1, column 36: is not UTF-8"));
    EXPECT_THAT(complaint("\xFF\xFE{"), HasSubstr("is UTF-16 text; save it as UTF-8"));
}

TEST(FuzzyFile, SaysWhatIsWrongAndWhere) {
    const auto with = [](const std::string& part, const std::string& by) {
        return complaint(withReplaced(sound(), part, by));
    };
    EXPECT_EQ(complaint(sound()), "accepted");
    EXPECT_THAT(complaint(""), HasSubstr("not valid JSON"));
    EXPECT_THAT(complaint("[]"), HasSubstr("object"));
    EXPECT_THAT(complaint("{\n \"name\" 3}"), HasSubstr("line 2, column 9"));
    EXPECT_THAT(complaint(sound().substr(0, 200)), HasSubstr("not valid JSON"));
    EXPECT_THAT(complaint(std::string(100000, '[')), HasSubstr("nested"));
    EXPECT_THAT(complaint("{}"), AllOf(HasSubstr("inputs is missing"), HasSubstr("outputs is missing"),
                                       HasSubstr("rules is missing")));
    EXPECT_THAT(with("[4, 9, 9, 9]", "[4, 9, 9, 8]"),
                HasSubstr("inputs.age.terms.old: the corners must rise, got 4, 9, 9, 8"));
    EXPECT_THAT(with("[4, 9, 9, 9]", "[4, 9, 9]"),
                HasSubstr("inputs.age.terms.old should be a list of 4 numbers"));
    EXPECT_THAT(with("[4, 9, 9, 9]", "[4, 9, \"9\", 9]"),
                HasSubstr("inputs.age.terms.old[2] should be a number"));
    EXPECT_THAT(with("[4, 9, 9, 9]", "[4, 9, 1e999, 9]"), HasSubstr("number is out of range"));
    EXPECT_THAT(with("[4, 9, 9, 9]", "[4, 9, NaN, 9]"), HasSubstr("not valid JSON at line 3"));
    EXPECT_THAT(with("[0, 9]", "[9, 0]"), HasSubstr("inputs.age.range"));
    EXPECT_THAT(with("\"range\": [0, 9], ", ""), HasSubstr("inputs.age.range is missing"));
    EXPECT_THAT(with("{\"old\": [4, 9, 9, 9]}", "{}"),
                HasSubstr("inputs.age.terms: there must be at least one"));
    EXPECT_THAT(with("{\"old\": [4, 9, 9, 9]}", "7"), HasSubstr("inputs.age.terms should be an object"));
    EXPECT_THAT(with("\"little\"", "\"much\""), HasSubstr("inputs.zeal.terms.much is there twice"));
    EXPECT_THAT(with("\"age\"", "\"zeal\""), HasSubstr("inputs.zeal is there twice"));
    EXPECT_THAT(with("\"viscosity\"", "\"age\""), HasSubstr("outputs.age: the name is there twice"));
    EXPECT_THAT(with("\"old\"", "\"very old\""), HasSubstr("one word"));
    EXPECT_THAT(with("\"rules\"", "\"rulez\""), HasSubstr("rulez is not known here"));
    EXPECT_THAT(with("\"range\": [0, 9]", "\"range\": [0, 9], \"colour\": \"red\""),
                HasSubstr("inputs.age.colour is not known here"));
    EXPECT_THAT(with("[3, 4, 5, 5]", "[6, 7, 8, 9]"),
                HasSubstr("outputs.viscosity.terms.thick: lies outside"));
    EXPECT_THAT(with("IS thick", "IS thin"), AllOf(HasSubstr("rules[0], column 50"), HasSubstr("thick")));
    EXPECT_THAT(with("\"IF", "7, \"IF"), HasSubstr("rules[0] should be a text"));
}

TEST(FuzzyPreset, IsTheFileThatShips) {
    const std::filesystem::path folder = std::filesystem::path(ESM_SOURCE_DIR) / "presets";
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.is_regular_file()) files.push_back(entry.path().stem());
    EXPECT_THAT(fuzzyPresetNames(), testing::UnorderedElementsAreArray(files));
    for (const std::string& name : fuzzyPresetNames())
        EXPECT_EQ(toJson(fuzzyPreset(name)), toJson(importFuzzyFile(folder / (name + ".json")).system))
            << name;
}

TEST(FuzzyPreset, IsThePublishedSystem) {
    for (const std::string& name : fuzzyPresetNames()) {
        const std::filesystem::path file = sharedData("fuzzy/" + name + ".json");
        ESM_SKIP_WITHOUT(file);
        FuzzySystem preset = fuzzyPreset(name);
        preset.description.clear(); // our own words
        EXPECT_EQ(toJson(preset), toJson(importFuzzyFile(file).system)) << name;
    }
}

TEST(FuzzyPreset, ReproducesThePublishedPairs) {
    const FuzzySystem system = fuzzyPreset("susilap-g");
    const auto flexible = infer(system, {5.5}).outputs;
    EXPECT_NEAR(flexible[0].value(), 16.2606, 2e-4 * 16.2606);
    EXPECT_NEAR(flexible[1].value(), 2.87713, 2e-4 * 2.87713);
    const auto organ = infer(fuzzyPreset("robo-sim"), {7.3, 4.9, 3.0}).outputs;
    EXPECT_NEAR(organ[0].value(), 45.4871, 1e-4);
    EXPECT_NEAR(organ[1].value(), 72.8125, 1e-9);
}

TEST(FuzzyPreset, ThatIsNotThereIsAnsweredWithThoseThatAre) {
    try {
        fuzzyPreset("susilap");
        FAIL() << "accepted";
    } catch (const InvalidModel& error) {
        EXPECT_THAT(error.what(),
                    AllOf(HasSubstr("\"susilap\""), HasSubstr("susilap-g"), HasSubstr("robo-sim")));
    }
}

TEST(FuzzySystem, IsFoundByFileOrPreset) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "trial.json", sound());
    writeFileAtomically(folder / "plain", sound());
    EXPECT_EQ(findFuzzySystem("susilap-g").system.name, "susilap-g");
    EXPECT_EQ(findFuzzySystem((folder / "trial.json").string()).system.name, "trial");
    EXPECT_EQ(findFuzzySystem((folder / "plain").string()).system.name, "trial");
    EXPECT_THROW(findFuzzySystem("missing.json"), FileError);
    EXPECT_THROW(findFuzzySystem("missing"), InvalidModel);
}
