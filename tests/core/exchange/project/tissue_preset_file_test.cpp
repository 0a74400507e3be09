#include "core/exchange/project/tissue_preset_file.h"

#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/support/errors.h"
#include "core/support/json_reader.h"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>

using namespace esm;
using testing::HasSubstr;

TEST(TissuePresetFile, IsTheFileThatShips) {
    const std::filesystem::path folder = std::filesystem::path(ESM_SOURCE_DIR) / "presets/tissue";
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        files.push_back(entry.path().stem());
    EXPECT_THAT(tissuePresetNames(), testing::UnorderedElementsAreArray(files));
    for (const std::string& name : tissuePresetNames()) {
        EXPECT_EQ(tissuePresetFromJson(readJsonFile(folder / (name + ".json"))).name, name);
        EXPECT_THAT(tissuePreset(name).source, testing::ContainsRegex("(19|20)[0-9][0-9]")) << name;
    }
}

TEST(TissuePresetFile, SaysInWordsWhatWasPublished) {
    for (const std::string& name : tissuePresetNames()) {
        const TissuePreset preset = tissuePreset(name);
        const PublishedTissue& published = preset.published;
        EXPECT_EQ(preset.system != nullptr, published.springConstant || published.youngsModulus) << name;
        if (!preset.system) continue;
        Region region;
        layPreset(region, preset);
        const RegionTissue tissue = evaluate(region, usualWallThickness);
        EXPECT_TRUE(tissue.warnings.empty()) << name;
        const double modulus = *youngsModulusOf(tissue.values, usualWallThickness);
        const double time = *relaxationTimeOf(tissue);
        EXPECT_NEAR(*tissue.values.springConstant /
                        published.springConstant.value_or(*tissue.values.springConstant),
                    1, 2e-4)
            << name;
        EXPECT_NEAR(*tissue.values.viscosity / published.viscosity.value_or(*tissue.values.viscosity), 1,
                    2e-4)
            << name;
        EXPECT_NEAR(modulus / published.youngsModulus.value_or(modulus), 1, 2e-4) << name;
        EXPECT_NEAR(time / published.relaxationTime.value_or(time), 1, 1e-3) << name;
    }
}

TEST(TissuePresetFile, HoldsThePublishedFigures) {
    const TissuePreset tube = tissuePreset("tube");
    EXPECT_EQ(tube.published.springConstant, 16.2606);
    EXPECT_EQ(tube.published.viscosity, 2.87713);
    EXPECT_EQ(tube.mass, 0.010);
    EXPECT_EQ(tissuePreset("uterus").mass, 0.5);
    EXPECT_EQ(tissuePreset("uterus").published.springConstant, 81.3091);
    EXPECT_EQ(tissuePreset("bowel").mass, 0.1);
    EXPECT_EQ(tissuePreset("bowel").published.viscosity, 9.13015);
    EXPECT_EQ(tissuePreset("ventricle").mass, 1);
    EXPECT_EQ(tissuePreset("ventricle").published.viscosity, 72.8125);
    EXPECT_FALSE(tissuePreset("tube-tethers").system);
    for (const char* name : {"tube", "tube-tethers"}) {
        ASSERT_EQ(tissuePreset(name).tethers.size(), 1U);
        EXPECT_EQ(tissuePreset(name).tethers[0].every, 3U);
        EXPECT_EQ(tissuePreset(name).tethers[0].springConstant, 2.41327);
        EXPECT_EQ(tissuePreset(name).tethers[0].viscosity, 10.6875);
    }
    EXPECT_EQ(publishedText(tube), "16.2606 N/m, 2.87713 N·s/m, 0.01 kg, a tether of 2.41327 N/m and 10.6875 "
                                   "N·s/m at one node in 3");
    EXPECT_EQ(publishedText(tissuePreset("liver")), "5.49 kPa, 0.07 s");
}

/// The words of our own system rise in order: who slides to the right gets firmer, and quicker, tissue.
TEST(FuzzyPreset, OrganRisesOverBothSliders) {
    const FuzzySystem system = fuzzyPreset("organ");
    double modulus = 0, time = INFINITY;
    for (int step = 0; step <= 1000; ++step) {
        const auto outputs = infer(system, {0.01 * step, 0.01 * step}).outputs;
        EXPECT_GT(*outputs[0], modulus) << step;
        EXPECT_LT(*outputs[1], time) << step;
        modulus = *outputs[0];
        time = *outputs[1];
        EXPECT_NEAR(modulus / (625 * std::exp2(0.01 * step)), 1, 0.011) << step;
        EXPECT_NEAR(time / (2 * std::pow(10, -0.002 * step)), 1, 0.011) << step;
    }
}

TEST(TissuePresetFile, ThatIsNotThereIsAnsweredWithThoseThatAre) {
    try {
        tissuePreset("tub");
        FAIL() << "accepted";
    } catch (const InvalidModel& error) {
        EXPECT_THAT(error.what(), AllOf(HasSubstr("\"tub\""), HasSubstr("tube-tethers")));
    }
    EXPECT_THROW(tissuePresetFromJson({{"name", "x"}}), InvalidModel);
}

TEST(TissuePresetFile, SaysWhatIsWrongAndWhere) {
    nlohmann::ordered_json json =
        readJsonFile(std::filesystem::path(ESM_SOURCE_DIR) / "presets/tissue/tube.json");
    json["mass"] = 0;
    json["published"]["springConstant"] = 1;
    json["tethers"][0]["every"] = 0;
    json.erase("inputs");
    try {
        tissuePresetFromJson(json);
        FAIL() << "accepted";
    } catch (const InvalidModel& error) {
        EXPECT_THAT(error.problems(),
                    testing::UnorderedElementsAre("inputs is missing", HasSubstr("mass must be"),
                                                  HasSubstr("published.springConstant is not known here"),
                                                  HasSubstr("tethers[0].every should be")));
    }
}
