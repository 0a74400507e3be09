#include "core/authoring/even_sheet.h"

#include "core/model/net_elasticity.h"
#include "core/project/detail_change.h"
#include "tests/support/flat_nets.h"
#include "tests/support/solid_surfaces.h"
#include "tests/support/steady_progress.h"
#include "tests/support/test_surfaces.h"
#include "tests/support/virtual_pull.h"

#include <gmock/gmock.h>

#include <numeric>

namespace esm {
namespace {

const TriangleMesh uneven = test::jittered(test::regularNetOf(900), 0.4, 7);

Project organ(const TriangleMesh& mesh, bool isEven) {
    return makeProject("organ", {mesh, {}}, 2.0, {Detail::Kind::EveryVertex, 0, {}, isEven});
}

/// Young's modulus of the flat organ, pulled to a strip, over that of a regular net of its spring constant.
double modulusOf(const Project& project) {
    std::vector<double> constants;
    for (const SpringValues& values : springValues(evaluateModel(project)))
        constants.push_back(values.springConstant / project.base.springConstant);
    return test::pulledModulus(test::flatNet(*project.mesh, constants), surfaceArea(*project.mesh), 0.75);
}

double sum(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

TEST(EvenSheet, IsAsFirmAsItsTissueHoweverItIsMeshed) {
    EXPECT_NEAR(modulusOf(organ(uneven, true)), 1, 0.03);
    EXPECT_LT(modulusOf(organ(uneven, false)), 0.9) << "what it is for";
    EXPECT_NEAR(modulusOf(organ(test::regularNetOf(900), true)), 1, 1e-6);
}

TEST(EvenSheet, RelaxesAlikeEverywhere) {
    const Project project = organ(uneven, true);
    for (const auto& [springConstant, viscosity] : springValues(evaluateModel(project)))
        EXPECT_NEAR(viscosity / springConstant / (project.base.viscosity / project.base.springConstant), 1,
                    1e-12);
}

TEST(EvenSheet, WeighsByAreaAndAsMuchAltogether) {
    const TissueModel model = evaluateModel(organ(uneven, true));
    EXPECT_NEAR(sum(model.mass), 2, 1e-12);
    const std::vector<double> areas = nodeAreas(uneven.vertices, uneven.triangles);
    for (std::size_t node = 0; node < areas.size(); ++node) {
        const bool isSmall = areas[node] < 0.4 * sum(areas) / static_cast<double>(areas.size());
        if (isSmall) continue;
        EXPECT_NEAR(model.mass[node] / areas[node] / (2 / sum(areas)), 1, 0.01) << node;
    }
    EXPECT_GT(*std::min_element(model.mass.begin(), model.mass.end()), 0.29 * 2 / double(areas.size()));
}

TEST(EvenSheet, IsHeldByTethersOfTheSameSumAndTakesARegionsMass) {
    Project even = organ(uneven, true);
    even.scene.tethers = {{1, 0.5, 0.25}};
    double constant = 0;
    for (const Tether& tether : evaluateModel(even).tethers)
        constant += tether.springConstant;
    EXPECT_NEAR(constant, 0.5 * static_cast<double>(uneven.vertices.size()), 1e-9);
    Region region;
    region.held.mass = 0.7;
    even.regions = {region};
    EXPECT_NEAR(sum(evaluateModel(even).mass), 0.7, 1e-12);
}

TEST(EvenSheet, OfFewerNodesStaysOne) {
    const Project fine = organ(lumpySurface(40, 60), true);
    const Project coarse = withDetail(fine, {Detail::Kind::Nodes, 500, {}, true});
    ASSERT_TRUE(coarse.network->sheet);
    EXPECT_TRUE(detailOf(*coarse.network).isEven);
    EXPECT_THAT(carryingProblems(*coarse.mesh, *coarse.network), testing::IsEmpty());
}

TEST(EvenSheet, IsTakenAndLeftWithoutAnotherChange) {
    Project plain = organ(uneven, false);
    plain.scene.fixed = {{{1, 2, 3}, std::nullopt}};
    plain.scene.splits = {{0.5, {{40, 41}, {41, 42}}}};
    const Project even = withEvenSheet(plain, true);
    ASSERT_TRUE(even.network->sheet);
    EXPECT_EQ(even.scene, plain.scene);
    EXPECT_EQ(even.base, plain.base);
    EXPECT_EQ(even.network->restPositions, plain.network->restPositions);
    const Project again = withEvenSheet(even, false);
    EXPECT_FALSE(again.network->sheet);
    EXPECT_EQ(evaluateModel(again).mass, evaluateModel(plain).mass);
    EXPECT_THAT(evaluateModel(again).ownValues, testing::IsEmpty());
}

TEST(EvenSheet, IsMadeWithSteadyProgress) {
    const Project plain = organ(lumpySurface(60, 80), false);
    test::expectGoodProgress([&](const Progress& progress) { withEvenSheet(plain, true, progress); });
    test::expectGoodProgress([&](const Progress& progress) {
        makeProject("organ", {*plain.mesh, {}}, 1.0, {Detail::Kind::EveryVertex, 0, {}, true}, progress);
    });
}

TEST(EvenSheet, IsOfSurfacesAlone) {
    EXPECT_TRUE(canBeEvenSheet(organ(uneven, false)));
    const Project block = organ(test::block({0, 0, 0}, {0.06, 0.04, 0.05}), false);
    EXPECT_FALSE(canBeEvenSheet(withDetail(block, {Detail::Kind::Rigid, 0})));
    const Project filled =
        withDetail(block, {Detail::Kind::Filled, 0, LatticeFilling{LatticeKind::Cubic, 0.01}});
    EXPECT_FALSE(canBeEvenSheet(filled));
    EXPECT_TRUE(hollowDetail(filled).isEven);
    EXPECT_FALSE(hollowDetail(block).isEven);
    EXPECT_FALSE(canBeEvenSheet(makeProject("line", {{}, {}}, 1.0)));
}

} // namespace
} // namespace esm
