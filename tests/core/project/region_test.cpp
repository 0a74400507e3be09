#include "core/project/region.h"

#include "core/project/wall.h"
#include "core/support/errors.h"

#include <gmock/gmock.h>

#include <cmath>

using namespace esm;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

/// Where the input is `low`, tissue gets the outputs' only sets; elsewhere no rule fires.
std::shared_ptr<const FuzzySystem> systemOf(std::vector<FuzzyVariable> outputs) {
    FuzzySystem system;
    system.name = "trial";
    system.inputs = {{"firmness", 0, 10, {{"low", {0, 0, 5, 5}}}}};
    system.outputs = std::move(outputs);
    FuzzyRule rule;
    rule.condition = {{0, 0}};
    for (std::size_t output = 0; output < system.outputs.size(); ++output)
        rule.conclusions.push_back({output, 0});
    system.rules = {rule};
    return std::make_shared<const FuzzySystem>(system);
}

FuzzyVariable around(const std::string& name, double centre) {
    return {name, centre - 1, centre + 1, {{"only", {centre - 1, centre, centre, centre + 1}}}};
}

} // namespace

TEST(Region, TakesInferredParametersByTheOutputsNames) {
    for (const char* springName : {"spring_const", "spring_constant"}) {
        Region region;
        region.system = systemOf(
            {around("mass", 3), around(springName, 20), around("colour", 7), around("viscosity", 5)});
        region.inputs = {{"firmness", 2}};
        const RegionTissue tissue = evaluate(region, usualWallThickness);
        EXPECT_DOUBLE_EQ(tissue.values.springConstant.value(), 20);
        EXPECT_DOUBLE_EQ(tissue.values.viscosity.value(), 5);
        EXPECT_DOUBLE_EQ(tissue.values.mass.value(), 3);
        EXPECT_THAT(tissue.warnings, IsEmpty());
        EXPECT_THAT(tissue.inference.firing, ElementsAre(1));
    }
}

TEST(Region, LeavesOutputsNoRuleReachesAndSaysSo) {
    Region region;
    region.system = systemOf({around("viscosity", 5)});
    region.inputs = {{"firmness", 7}};
    const RegionTissue tissue = evaluate(region, usualWallThickness);
    EXPECT_FALSE(tissue.values.viscosity);
    EXPECT_THAT(tissue.unreached, ElementsAre(0U));
}

TEST(Region, SaysNothingOfAnOutputThatAHeldValueStandsFor) {
    Region region;
    region.system = systemOf({around("viscosity", 5), around("spring_const", 20)});
    region.inputs = {{"firmness", 7}};
    region.held.viscosity = 11;
    const RegionTissue tissue = evaluate(region, usualWallThickness);
    EXPECT_EQ(tissue.values.viscosity, 11);
    EXPECT_THAT(tissue.unreached, ElementsAre(1U)) << "the spring constant";
}

TEST(Region, WarnsOfASystemThatSetsNoTissue) {
    Region region;
    region.system = systemOf({around("colour", 5), around("stiffness", 20)});
    region.inputs = {{"firmness", 2}};
    EXPECT_THAT(evaluate(region, usualWallThickness).warnings,
                ElementsAre(HasSubstr("trial sets no tissue")));
}

TEST(Region, TakesTheFirstOfTwoOutputsThatSetTheSameAndSaysSo) {
    Region region;
    region.system =
        systemOf({around("viscosity", 5), around("spring_constant", 20), around("spring_const", 70)});
    region.inputs = {{"firmness", 2}};
    const RegionTissue tissue = evaluate(region, usualWallThickness);
    EXPECT_DOUBLE_EQ(tissue.values.springConstant.value(), 20);
    EXPECT_THAT(tissue.warnings,
                ElementsAre(HasSubstr("spring_const sets nothing, since spring_constant before it")));
    EXPECT_EQ(outputFor(*region.system, Parameter::SpringConstant), 1);
    EXPECT_EQ(outputFor(*region.system, Parameter::Viscosity), 0);
    EXPECT_EQ(outputFor(*region.system, Parameter::Mass), std::nullopt);
}

TEST(Region, WarnsOfInputsOutOfRangeAndEvaluatesThemUnclamped) {
    Region region;
    region.system = systemOf({around("viscosity", 5)});
    region.inputs = {{"firmness", -1}};
    const RegionTissue tissue = evaluate(region, usualWallThickness);
    EXPECT_FALSE(tissue.values.viscosity);
    EXPECT_THAT(tissue.warnings, ElementsAre(HasSubstr("firmness -1 is out of its range, 0 to 10")));
    EXPECT_THAT(tissue.unreached, ElementsAre(0U));
}

TEST(Region, TakesAModulusAsTheSpringConstantOfItsWall) {
    Region region;
    region.system = systemOf({around("youngs_modulus", 5000)});
    region.inputs = {{"firmness", 2}};
    const RegionTissue tissue = evaluate(region, 0.002);
    EXPECT_NEAR(tissue.values.springConstant.value(), std::sqrt(3) * 0.002 * 5000 / 2, 1e-9);
    EXPECT_NEAR(youngsModulusOf(tissue.values, 0.002).value(), 5000, 1e-9);
    EXPECT_THAT(tissue.warnings, IsEmpty());
    EXPECT_EQ(parameterOf(*region.system, 0), Parameter::SpringConstant);
}

TEST(Region, TakesARelaxationTimeByItsSpringConstantOrThatBeneath) {
    Region region;
    region.system = systemOf({around("relaxation_time", 5)});
    region.inputs = {{"firmness", 2}};
    RegionTissue tissue = evaluate(region, usualWallThickness);
    EXPECT_EQ(relaxationTimeOf(tissue), 5);
    EXPECT_FALSE(tissue.values.viscosity) << "its spring constant is that of what lies beneath";
    region.held.springConstant = 30;
    tissue = evaluate(region, usualWallThickness);
    EXPECT_DOUBLE_EQ(tissue.values.viscosity.value(), 150);
    EXPECT_FALSE(tissue.relaxationTime);
    region.held.viscosity = 3;
    EXPECT_DOUBLE_EQ(relaxationTimeOf(evaluate(region, usualWallThickness)).value(), 0.1);
}

TEST(Region, DropsATimeThatNoTissueHas) {
    Region region;
    region.system = systemOf({around("relaxation_time", -5)});
    region.inputs = {{"firmness", 2}};
    const RegionTissue tissue = evaluate(region, usualWallThickness);
    EXPECT_FALSE(tissue.relaxationTime || tissue.values.viscosity);
    EXPECT_THAT(tissue.warnings, ElementsAre(HasSubstr("relaxation time -5 is not zero or more")));
}

TEST(Region, PutsHeldValuesBeforeInferredOnes) {
    Region region;
    region.system = systemOf({around("viscosity", 5), around("mass", 3)});
    region.inputs = {{"firmness", 2}};
    region.held.viscosity = 11;
    region.held.springConstant = 0;
    const TissueValues values = evaluate(region, usualWallThickness).values;
    EXPECT_EQ(values.viscosity, 11);
    EXPECT_EQ(values.springConstant, 0);
    EXPECT_DOUBLE_EQ(values.mass.value(), 3);
}

TEST(Region, KeepsWhatIsBeneathWhereAValueIsImpossible) {
    Region region;
    region.system = systemOf({around("viscosity", -5), around("mass", 0)});
    region.inputs = {{"firmness", 2}};
    region.held.springConstant = NAN;
    const RegionTissue tissue = evaluate(region, usualWallThickness);
    EXPECT_FALSE(tissue.values.springConstant || tissue.values.viscosity || tissue.values.mass);
    EXPECT_THAT(tissue.warnings,
                ElementsAre(HasSubstr("spring constant"), HasSubstr("viscosity -5"), HasSubstr("mass 0")));

    region = {};
    region.held = {1e31, 1e300, 1e-31};
    EXPECT_THAT(evaluate(region, usualWallThickness).warnings, testing::SizeIs(3));
    region.held = {1e30, 1e30, 1e-30};
    EXPECT_THAT(evaluate(region, usualWallThickness).warnings, IsEmpty());
}

TEST(Region, RefusesInputsItsSystemDoesNotHave) {
    Region region;
    region.system = systemOf({around("viscosity", 5)});
    region.inputs = {{"firmess", 2}, {"firmness", NAN}};
    try {
        evaluate(region, usualWallThickness);
        FAIL() << "accepted";
    } catch (const InvalidModel& error) {
        EXPECT_THAT(error.problems(),
                    ElementsAre(HasSubstr("\"firmess\""), HasSubstr("firmness is not a finite")));
    }
}
