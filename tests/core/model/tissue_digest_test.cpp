#include "core/model/tissue_digest.h"

#include "core/project/project.h"
#include "tests/support/tissue_models.h"

#include <gtest/gtest.h>

#include <functional>

using namespace esm;

namespace {

/// As a package holds it.
void inSinglePrecision(std::vector<double>& values) {
    for (double& value : values)
        value = static_cast<float>(value);
}

} // namespace

TEST(TissueDigest, ChangesWithWhateverMovesTheTissue) {
    const TissueModel tube = tissue::fallopianTube();
    const std::string digest = tissueDigest(tube);
    const std::function<void(TissueModel&)> changes[] = {
        [](TissueModel& model) { model.mass.back() *= 1.000001; },
        [](TissueModel& model) { std::swap(model.springConstant.front(), model.viscosity.front()); },
        [](TissueModel& model) { model.viscosity[3] *= 1.000001; },
        [](TissueModel& model) {
            model.stiffening = SpringStiffening{0.2, 2};
        },
        [](TissueModel& model) {
            model.ownValues = springValues(model);
            model.ownValues.back().viscosity *= 0.5;
        },
        [](TissueModel& model) {
            model.hinges = {{{0, 1, 2, 12}, 1, 1}};
        },
    };
    for (const auto& change : changes) {
        TissueModel other = tube;
        change(other);
        EXPECT_NE(tissueDigest(other), digest);
    }
}

TEST(TissueDigest, IsThatOfThePackageAndOfAnyScene) {
    TissueModel tube = tissue::fallopianTube();
    const std::string digest = tissueDigest(tube);
    for (auto* values : {&tube.mass, &tube.springConstant, &tube.viscosity})
        inSinglePrecision(*values);
    tube.fixedNodes = {0, 1};
    tube.tethers.clear();
    EXPECT_EQ(tissueDigest(tube), digest);
    tube.ownValues = springValues(tube);
    EXPECT_EQ(tissueDigest(tube), digest) << "all are the mean of their ends";
}

TEST(TissueDigest, SaysNothingOfWhatDoesNotNameItsTissue) {
    const TissueModel tube = tissue::fallopianTube();
    MeasuredStepping measured;
    EXPECT_FALSE(isFromOtherTissue(measured, tube));
    measured.tissue = tissueDigest(tube);
    EXPECT_FALSE(isFromOtherTissue(measured, tube));
    measured.tissue.back() ^= 1;
    EXPECT_TRUE(isFromOtherTissue(measured, tube));
}
