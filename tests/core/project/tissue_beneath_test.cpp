#include "core/project/tissue_beneath.h"

#include "core/authoring/regions.h"
#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/samples/samples.h"

#include <gmock/gmock.h>

using namespace esm;
using testing::ElementsAre;

namespace {

Project softTube() {
    Project project = makeSample("tube");
    project.regions.clear();
    project.base = {20, 3, 0.5};
    return project;
}

/// Around everything.
Region everything(double springConstant) {
    Region region;
    region.name = "all";
    region.held.springConstant = springConstant;
    return region;
}

} // namespace

TEST(TissueBeneath, IsTheBaseTissueUnderTheLowestRegion) {
    const auto beneath = tissueBeneath(softTube(), everything(1));
    ASSERT_TRUE(beneath);
    EXPECT_EQ(inWords(*beneath, Parameter::SpringConstant), "20 N/m");
    EXPECT_EQ(inWords(*beneath, Parameter::Viscosity), "3 N·s/m");
    EXPECT_EQ(inWords(*beneath, Parameter::Mass), "0.5 kg");
}

TEST(TissueBeneath, IsOfTheRegionsBeneathAlone) {
    Project project = softTube();
    for (const double constant : {5.0, 7.0, 9.0})
        project.regions.push_back(everything(constant));
    numberParts(project);
    EXPECT_EQ(inWords(*tissueBeneath(project, project.regions[1]), Parameter::SpringConstant), "5 N/m");
    EXPECT_EQ(inWords(*tissueBeneath(project, everything(1)), Parameter::SpringConstant), "9 N/m")
        << "one that is added lies on top";
}

TEST(TissueBeneath, TellsFromLeastToMostWhereItDiffers) {
    Project project = softTube();
    addRegion(project, RegionId{1}, organBox(*project.mesh, *project.network).center());
    project.regions[0].held.springConstant = 4;
    const auto beneath = tissueBeneath(project, everything(1));
    EXPECT_EQ(inWords(*beneath, Parameter::SpringConstant), "4 to 20 N/m");
    Region part = project.regions[0];
    part.id = RegionId{2};
    const auto within = tissueBeneath(project, part);
    EXPECT_EQ(inWords(*within, Parameter::SpringConstant), "4 N/m");
    EXPECT_LT(within->mass, 0.5);
    part.ellipsoid->centre.x() += 100;
    EXPECT_FALSE(tissueBeneath(project, part)) << "it reaches no node";
}

TEST(TissueBeneath, IsWhatIsLeftWhereTheRegionIsNotLaid) {
    Project project = softTube();
    addRegion(project, RegionId{1}, organBox(*project.mesh, *project.network).center());
    const TissueModel without = evaluateModel(softTube());
    const auto weights = nodeWeights(*project.network, project.regions[0]);
    double mass = 0;
    for (std::size_t node = 0; node < weights.size(); ++node)
        mass += weights[node] * without.mass[node];
    EXPECT_NEAR(tissueBeneath(project, project.regions[0])->mass, mass, 1e-15);
}

TEST(TissueBeneath, IsSaidOfAnOutputThatNoRuleReaches) {
    Project project = softTube();
    FuzzySystem system = fuzzyPreset("susilap-g");
    for (FuzzyRule& rule : system.rules)
        std::erase_if(rule.conclusions, [](const FuzzyProposition& said) { return said.variable == 1; });
    Region region;
    region.system = std::make_shared<const FuzzySystem>(system);
    region.inputs = {{"consistency", 5.5}};
    EXPECT_THAT(evaluateRegion(project, region).tissue.warnings,
                ElementsAre("no rule reaches viscosity: it keeps 3 N·s/m"));
    EXPECT_THAT(evaluate(region, usualWallThickness).unreached, ElementsAre(1U));
}
