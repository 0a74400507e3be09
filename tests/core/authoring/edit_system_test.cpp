#include "core/authoring/edit_system.h"

#include "core/authoring/regions.h"
#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/samples/samples.h"
#include "core/support/errors.h"

#include <gmock/gmock.h>

using namespace esm;
using testing::ElementsAre;
using testing::Pair;

namespace {

/// Two regions that were given the same preset one after the other, and one with another.
Project threeRegions() {
    Project project = makeSample("tube");
    project.regions.clear();
    for (const char* preset : {"susilap-g", "susilap-g", "robo-sim"}) {
        addRegion(project, nextId(project.regions), Eigen::Vector3d::Zero());
        setSystem(project, project.regions.back().id,
                  std::make_shared<const FuzzySystem>(fuzzyPreset(preset)));
    }
    return project;
}

} // namespace

TEST(EditSystem, GoesToEveryRegionOfTheSameLanguage) {
    Project project = threeRegions();
    const auto other = project.regions[2].system;
    setInput(project.regions[0], "consistency", 5.5);
    FuzzySystem system = *project.regions[0].system;
    system.inputs[0].name = "firmness";
    editSystem(project, project.regions[0].id, system);
    EXPECT_EQ(project.regions[0].system->inputs[0].name, "firmness");
    EXPECT_EQ(project.regions[0].system.get(), project.regions[1].system.get());
    EXPECT_EQ(project.regions[2].system, other);
    EXPECT_THAT(project.regions[0].inputs, ElementsAre(Pair("firmness", 5.5)));
    EXPECT_THAT(project.regions[1].inputs, ElementsAre(Pair("firmness", 6)));
}

TEST(EditSystem, MakesACopyForOneWhereAsked) {
    Project project = threeRegions();
    const Project before = project;
    FuzzySystem system = *project.regions[0].system;
    system.inputs[0].name = "firmness";
    editSystem(project, project.regions[0].id, system, {Reach::CopyForOne});
    EXPECT_EQ(project.regions[0].system->name, "susilap-g, own");
    EXPECT_EQ(project.regions[0].system->inputs[0].name, "firmness");
    EXPECT_THAT(project.regions[0].inputs, ElementsAre(Pair("firmness", 6)));
    EXPECT_EQ(project.regions[1], before.regions[1]);
    EXPECT_EQ(project.regions[2], before.regions[2]);
    system.inputs[0].name = "hardness";
    editSystem(project, project.regions[1].id, system, {Reach::CopyForOne});
    EXPECT_EQ(project.regions[1].system->name, "susilap-g") << "nobody else has it: nothing to copy";
    project.regions[2].system = project.regions[0].system;
    system = *project.regions[0].system;
    system.rules.clear();
    editSystem(project, project.regions[2].id, system, {Reach::CopyForOne});
    EXPECT_EQ(project.regions[2].system->name, "susilap-g, own 2");
}

TEST(EditSystem, ACopyTakesNoNameThatIsTakenElsewhere) {
    Project project = threeRegions();
    FuzzySystem system = *project.regions[0].system;
    system.rules.clear();
    editSystem(project, project.regions[0].id, system,
               {Reach::CopyForOne, {"susilap-g, own", "susilap-g, own 2"}});
    EXPECT_EQ(project.regions[0].system->name, "susilap-g, own 3");
}

TEST(EditSystem, ARangeForACopyLeavesTheOtherRegionsAsTheyAre) {
    Project project = threeRegions();
    const Region other = project.regions[1];
    setRange(project, project.regions[0].id, {FuzzySide::Inputs, 0}, {0, 24, TermsInRange::Stretch},
             {Reach::CopyForOne});
    EXPECT_EQ(project.regions[1], other);
    EXPECT_THAT(project.regions[0].inputs, ElementsAre(Pair("consistency", 12)));
}

TEST(EditSystem, ValuesGoWithTheirInputs) {
    Project project = threeRegions();
    Region& region = project.regions[2];
    region.inputs = {{"consistency", 7.3}, {"sensitiveness", 4.9}}; // shiftability is left out
    FuzzySystem system = *region.system;
    system.rules.clear();
    std::swap(system.inputs[0], system.inputs[2]);
    editSystem(project, project.regions[2].id, system);
    EXPECT_THAT(region.inputs, ElementsAre(Pair("consistency", 7.3), Pair("sensitiveness", 4.9)));
    system.inputs.erase(system.inputs.begin() + 1);
    system.inputs.push_back({"wetness", 2, 4, {{"wet", {2, 2, 4, 4}}}});
    system.inputs.push_back({"age", 0, 4, {{"old", {2, 2, 4, 4}}}});
    editSystem(project, project.regions[2].id, system);
    EXPECT_THAT(region.inputs, ElementsAre(Pair("consistency", 7.3), Pair("wetness", 3), Pair("age", 2)));
}

TEST(EditSystem, RefusesWhatCannotBeEvaluated) {
    Project project = threeRegions();
    const auto before = project.regions[0].system;
    FuzzySystem system = *before;
    system.inputs[0].terms[0].set.a = 11;
    EXPECT_THROW(editSystem(project, project.regions[0].id, system), InvalidModel);
    EXPECT_EQ(project.regions[0].system, before);
}
