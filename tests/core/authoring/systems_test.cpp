#include "core/authoring/systems.h"

#include "core/authoring/regions.h"
#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/exchange/project/tissue_preset_file.h"
#include "core/samples/samples.h"

#include <gmock/gmock.h>

using namespace esm;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

namespace {

SharedSystem own(const std::string& name) {
    FuzzySystem system = fuzzyPreset("susilap-g");
    system.name = name;
    return std::make_shared<const FuzzySystem>(std::move(system));
}

std::vector<std::string> namesOf(const std::vector<SharedSystem>& systems) {
    std::vector<std::string> names;
    for (const SharedSystem& system : systems)
        names.push_back(system->name);
    return names;
}

/// Regions "Region 1" and "Region 2" with one system of their own.
class Systems : public testing::Test {
protected:
    Systems() {
        project.regions.clear();
        for (RegionId id : {first, second})
            addRegion(project, id, Eigen::Vector3d::Zero(), own("mine"));
    }
    std::vector<std::string> spare() const {
        return namesOf({project.spareSystems.begin(), project.spareSystems.end()});
    }

    const RegionId first{1}, second{2};
    Project project = makeSample("tube");
};

} // namespace

TEST_F(Systems, AreToldWithTheRegionsThatUseThem) {
    setSystem(project, second, own("other"));
    EXPECT_THAT(namesOf(systemsOf(project)), ElementsAre("mine", "other"));
    const auto users = usersOf(project, *own("mine"));
    ASSERT_EQ(users.size(), 1U) << "systems that are alike are one";
    EXPECT_EQ(users[0]->name, "Region 1");
}

TEST_F(Systems, StayWhenNoRegionUsesThem) {
    setSystem(project, first, own("other"));
    EXPECT_THAT(spare(), IsEmpty()) << "the second region has it still";
    setSystem(project, second, nullptr);
    EXPECT_THAT(spare(), ElementsAre("mine"));
    removeRegion(project, first);
    EXPECT_THAT(spare(), ElementsAre("mine", "other"));
    EXPECT_THAT(namesOf(systemsOf(project)), ElementsAre("mine", "other"));
    setSystem(project, second, own("mine"));
    EXPECT_THAT(spare(), ElementsAre("other")) << "used again";
    applyPreset(project, second, tissuePreset("uterus"));
    EXPECT_THAT(spare(), ElementsAre("other", "mine"));
    EXPECT_THAT(validate(project), IsEmpty());
}

TEST_F(Systems, GoWhenTheyAreRemoved) {
    removeSpareSystem(project, *own("mine"));
    EXPECT_THAT(namesOf(systemsOf(project)), ElementsAre("mine")) << "it is in use";
    setSystem(project, first, nullptr);
    setSystem(project, second, nullptr);
    removeSpareSystem(project, *own("mine"));
    EXPECT_THAT(systemsOf(project), IsEmpty());
}

TEST_F(Systems, KeepInputsThatTheOtherHasToo) {
    FuzzySystem copy = *own("copy");
    copy.inputs[0].terms.pop_back();
    copy.rules.clear();
    copy.inputs.push_back({"wetness", 2, 4, {{"wet", {2, 2, 4, 4}}}});
    Region& region = project.regions[0];
    region.inputs = {{"consistency", 4.5}};
    setSystem(project, first, std::make_shared<const FuzzySystem>(copy));
    EXPECT_THAT(region.inputs, ElementsAre(Pair("consistency", 4.5), Pair("wetness", 3)));
    setInput(region, "consistency", 7);
    setSystem(project, first, own("mine"));
    EXPECT_THAT(region.inputs, ElementsAre(Pair("consistency", 7)));
    copy.inputs[0].maximum = 6;
    setSystem(project, first, std::make_shared<const FuzzySystem>(copy));
    EXPECT_THAT(region.inputs, ElementsAre(Pair("consistency", 3), testing::_)) << "7 is out of its range";
    copy.inputs[0].unit = "kPa";
    setInput(region, "consistency", 5);
    setSystem(project, first, std::make_shared<const FuzzySystem>(copy));
    EXPECT_THAT(region.inputs, ElementsAre(Pair("consistency", 3), testing::_)) << "of another unit";
}

TEST_F(Systems, KeepAnInputThatWasLeftOutSo) {
    project.regions[0].inputs.clear();
    FuzzySystem copy = *own("copy");
    copy.rules.pop_back();
    setSystem(project, first, std::make_shared<const FuzzySystem>(copy));
    EXPECT_THAT(project.regions[0].inputs, IsEmpty());
}
