#include "core/authoring/preset_changes.h"

#include "core/exchange/project/tissue_preset_file.h"
#include "core/samples/samples.h"

#include <gmock/gmock.h>

using namespace esm;
using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

namespace {

std::vector<std::string> linesOf(const std::vector<PresetChange>& changes) {
    std::vector<std::string> words;
    for (const PresetChange& change : changes)
        words.push_back(change.what + ": " + change.before + " > " + change.after);
    return words;
}

} // namespace

TEST(PresetChanges, NameEverythingWithItsUnit) {
    Project project = makeSample("tube");
    project.base.mass = 0.02;
    project.scene.tethers = {{1, 0.5, 2}};
    const RegionId whole = project.regions[0].id;
    setInput(project.regions[0], "consistency", 10.1);
    const auto words = linesOf(presetChanges(project, whole, tissuePreset("tube")));
    EXPECT_THAT(words,
                ElementsAre("consistency: 10.1 > 5.5", "spring constant: 81.31 N/m > 16.26 N/m",
                            "viscosity: 6 N·s/m > 2.878 N·s/m", "base mass: 0.02 kg > 0.01 kg",
                            "tethers: each node, 0.5 N/m, 2 N·s/m > one node in 3, 2.413 N/m, 10.69 N·s/m"));
}

TEST(PresetChanges, AreThoseThatApplyingMakes) {
    for (const std::string& name : tissuePresetNames())
        for (const bool isPart : {false, true}) {
            const TissuePreset preset = tissuePreset(name);
            Project project = makeSample("liver");
            if (isPart) addRegion(project, nextId(project.regions), Eigen::Vector3d::Zero());
            const RegionId region = project.regions.back().id;
            const auto changes = presetChanges(project, region, preset);
            const Project before = project;
            applyPreset(project, region, preset);
            EXPECT_EQ(changes.empty(), before == project) << name;
            EXPECT_THAT(presetChanges(project, region, preset), IsEmpty()) << name;
        }
}

TEST(PresetChanges, OfNoRegionYetBeginWithNone) {
    Project project = makeSample("tube");
    project.regions.clear();
    EXPECT_THAT(linesOf(presetChanges(project, nextId(project.regions), tissuePreset("ventricle"))),
                Contains("fuzzy system: none > robo-sim"));
}
