#include "core/authoring/accuracy.h"

#include "core/project/detail_change.h"
#include "core/samples/samples.h"
#include "core/support/errors.h"
#include "tests/support/steady_progress.h"
#include "tests/support/tissue_models.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace esm;

TEST(Accuracy, PullsAtTheEdgeWhereTheSceneMovesNothing) {
    Project tube = makeSample("tube");
    EXPECT_TRUE(measuredScene(tube).moves.empty());
    tube.scene.instruments.clear();
    const Scene pulled = measuredScene(tube);
    EXPECT_FALSE(pulled.moves.empty());
    EXPECT_TRUE(validate(pulled, tube.network->restPositions.size()).empty());
    NodeSelection all;
    for (std::uint32_t node = 0; node < tube.network->restPositions.size(); ++node)
        all.nodes.push_back(node);
    tube.scene.fixed = {all};
    EXPECT_THROW(measuredScene(tube), InvalidModel);
}

namespace {

/// A sheet with a run on its 256 nodes, one on fewer and one that did not end.
Project measuredSheet() {
    Project sheet = makeProject("sheet", {tissue::gridMesh(16, 0.1), {}});
    sheet.scene.gravity = {0, 0, -1};
    sheet.scene.fixed = {{{0, 17, 255}, {}}};
    Tradeoff measured;
    measured.reference.stepping = {Integrator::Rk4, 1e-5, Precision::Double};
    measured.runs = {{{Integrator::Split2, 0.01, Precision::Double}, 256, true, 0.02, false, 0.1, {}},
                     {{Integrator::Split2, 0.01, Precision::Double},
                      64,
                      true,
                      0.2,
                      false,
                      0.03,
                      Detail{Detail::Kind::Nodes, 64}},
                     {{Integrator::Euler, 1, Precision::Double}, 256, false, std::nan(""), false, 0, {}}};
    sheet.accuracy = std::make_shared<const MeasuredAccuracy>(
        measuredAccuracy(measuredOrgan(sheet), detailOf(*sheet.network), measured));
    return sheet;
}

} // namespace

TEST(Accuracy, HoldsForTheOrganAndForTheNodesOfTheRunThatWasChosen) {
    const Project sheet = measuredSheet();
    EXPECT_TRUE(isMeasuredOn(sheet, measuredOrgan(sheet)));
    const Project fewer = withMeasuredRun(sheet, 1);
    EXPECT_LT(fewer.network->restPositions.size(), 256U);
    EXPECT_EQ(fewer.stepping->error, 0.2);
    EXPECT_TRUE(isMeasuredOn(fewer, measuredOrgan(fewer)));
    const Project back = withMeasuredRun(fewer, 0);
    EXPECT_EQ(back.scene, sheet.scene) << "nodes that are fixed come back as they were";
    EXPECT_EQ(measuredOrgan(back), measuredOrgan(sheet));
    EXPECT_TRUE(isMeasuredOn(back, measuredOrgan(back)));
}

TEST(Accuracy, ChoosingARunTellsHowFarItIsAndCanBeStopped) {
    const Project sheet = measuredSheet(), fewer = withMeasuredRun(sheet, 1);
    test::expectGoodProgress([&](const Progress& progress) { withMeasuredRun(fewer, 0, progress); });
    test::expectGoodProgress([&](const Progress& progress) { withMeasuredRun(sheet, 1, progress); });
}

TEST(Accuracy, HoldsNoLongerWhereTissueOrSceneWereEdited) {
    Project sheet = measuredSheet();
    Project moved = sheet;
    moved.scene.gravity = {0, 0, -2};
    EXPECT_FALSE(isMeasuredOn(moved, measuredOrgan(moved)));
    Project softer = withMeasuredRun(sheet, 1);
    softer.base.springConstant /= 2;
    EXPECT_FALSE(isMeasuredOn(softer, measuredOrgan(softer)));
    const Project back = withMeasuredRun(softer, 0);
    EXPECT_EQ(back.network->restPositions.size(), 256U);
    EXPECT_EQ(back.base.springConstant, softer.base.springConstant);
    EXPECT_FALSE(isMeasuredOn(back, measuredOrgan(back)));
}

TEST(Accuracy, SaysNothingOfARunThatDidNotEndAndRecommendsNone) {
    const Project sheet = measuredSheet();
    EXPECT_TRUE(validate(*sheet.accuracy).empty());
    EXPECT_EQ(sheet.accuracy->runs[2].error, 0);
    const Tradeoff tradeoff = tradeoffOf(*sheet.accuracy, {1, 0.1});
    EXPECT_EQ(tradeoff.pareto, (std::vector<std::size_t>{1, 0}));
    EXPECT_EQ(tradeoff.fastestToError, 0U);
}
