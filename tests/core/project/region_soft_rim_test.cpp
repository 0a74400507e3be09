#include "core/project/project.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numeric>

using namespace esm;
using testing::AllOf;
using testing::Each;
using testing::ElementsAre;
using testing::Ge;
using testing::HasSubstr;
using testing::Le;

namespace {

using Eigen::Vector3d;

/// A row of nodes, 1 mm apart, from 0 along x.
Project row(std::size_t nodes) {
    SpringNetwork network;
    for (std::size_t i = 0; i < nodes; ++i)
        network.restPositions.emplace_back(0.001 * static_cast<double>(i), 0, 0);
    for (std::uint32_t i = 0; i + 1 < nodes; ++i)
        network.springs.push_back({i, i + 1, 0.001});
    Project project;
    project.mesh = std::make_shared<TriangleMesh>();
    project.importReport = std::make_shared<RepairReport>();
    project.network = std::make_shared<SpringNetwork>(network);
    project.base = {16, 3, 0.1};
    return project;
}

/// Around x = `centre`, 5 mm long to both sides, 2 mm thick.
Region lump(double centre, double rim) {
    Region region;
    region.ellipsoid = Ellipsoid{{centre, 0, 0}, {0.005, 0.002, 0.002}, Eigen::Quaterniond::Identity()};
    region.rim = rim;
    return region;
}

double sumOf(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

} // namespace

TEST(SoftRim, FallsSteadilyFromOneInsideToZeroAtItsEnd) {
    Region region = lump(0, 0.004);
    region.ellipsoid->orientation = Eigen::AngleAxisd(0.4, Vector3d(1, 1, 0).normalized());
    for (const Vector3d& direction : {Vector3d(1, 0, 0), Vector3d(0, 0, -1), Vector3d(-1, 2, 0.3)}) {
        double before = 1;
        for (int step = 0; step <= 4000; ++step) {
            const double weight = weightAt(region, 0.012 / 4000 * step * direction.normalized());
            EXPECT_LE(weight, before);
            EXPECT_GE(weight, 0);
            // Its slope is 1.5 / rim at most.
            EXPECT_GT(weight, before - 1.6 / 0.004 * 0.012 / 4000);
            before = weight;
        }
        EXPECT_EQ(weightAt(region, 1e-4 * direction), 1);
        EXPECT_EQ(before, 0);
    }
    EXPECT_NEAR(weightAt(lump(0, 0.004), {0.007, 0, 0}), 0.5, 1e-12);
    EXPECT_NEAR(weightAt(lump(0, 0.004), {0, 0.003, 0}), 0.84375, 1e-12);
}

TEST(SoftRim, IsSharpWithoutAWidthAndEverywhereInTheWholeOrgan) {
    EXPECT_EQ(weightAt(lump(0, 0), {0.005, 0, 0}), 1);
    EXPECT_EQ(weightAt(lump(0, 0), {0.005000001, 0, 0}), 0);
    Region whole;
    whole.rim = 0.1;
    EXPECT_EQ(weightAt(whole, {9, 9, 9}), 1);
}

TEST(SoftRim, HoldsUpOverDegenerateEllipsoidsAndAnyWidth) {
    for (const Vector3d& radii :
         {Vector3d(1, 1, 1e-12), Vector3d(1e-12, 1e-12, 1e-12), Vector3d(1e-300, 1, 1)})
        for (const double rim : {1e-300, 1e-9, 0.01, 1e30}) {
            Region region;
            region.ellipsoid = Ellipsoid{{0, 0, 0}, radii, Eigen::Quaterniond::Identity()};
            region.rim = rim;
            EXPECT_EQ(weightAt(region, {0, 0, 0}), 1);
            for (const Vector3d& point : {Vector3d(0.3, 0.2, 0.001), Vector3d(0, 0, 5), Vector3d(1e9, 0, 0)})
                EXPECT_THAT(weightAt(region, point), AllOf(Ge(0.0), Le(1.0))) << radii.transpose() << rim;
        }
}

TEST(SoftRim, MixesWithinBothEndsInProportionToTheWeight) {
    Project project = row(30);
    project.regions = {lump(0, 0.01)};
    project.regions[0].held = {500, 0, {}};
    const TissueModel model = evaluateModel(project);
    EXPECT_THAT(model.springConstant, Each(AllOf(Ge(16.0), Le(500.0))));
    EXPECT_THAT(model.viscosity, Each(AllOf(Ge(0.0), Le(3.0))));
    EXPECT_EQ(model.springConstant[5], 500);
    EXPECT_NEAR(model.springConstant[10], (500 + 16) / 2.0, 1e-9);
    EXPECT_EQ(model.springConstant[15], 16);
    EXPECT_TRUE(std::is_sorted(model.springConstant.rbegin(), model.springConstant.rend()));
    EXPECT_NEAR(valuesOf(model, 9).springConstant, (model.springConstant[9] + model.springConstant[10]) / 2,
                1e-12);
}

TEST(SoftRim, LeavesEqualTissueAsItIs) {
    Project project = row(30);
    project.base = {0.1, 1.0 / 3, 0.1};
    project.regions = {lump(0, 0.01)};
    project.regions[0].held = {0.1, 1.0 / 3, {}};
    EXPECT_THAT(evaluateModel(project).springConstant, Each(0.1));
    EXPECT_THAT(evaluateModel(project).viscosity, Each(1.0 / 3));
}

TEST(SoftRim, KeepsTheRegionsMassAndWhatTheOthersKeep) {
    for (const double rim : {0.0, 0.0005, 0.01, 1e6}) {
        Project project = row(30);
        project.regions = {lump(0.011, rim)};
        project.regions[0].held.mass = 0.7;
        const std::vector<double> weights = nodeWeights(*project.network, project.regions[0]);
        const TissueModel model = evaluateModel(project);
        double kept = 0, taken = 0;
        for (std::size_t i = 0; i < weights.size(); ++i) {
            kept += (1 - weights[i]) * 0.1 / 30;
            taken += model.mass[i] - (1 - weights[i]) * 0.1 / 30;
            EXPECT_GT(model.mass[i], 0);
        }
        EXPECT_NEAR(taken, 0.7, 1e-12) << rim;
        EXPECT_NEAR(sumOf(model.mass), kept + 0.7, 1e-12) << rim;
    }
}

TEST(SoftRim, ThatHardlyTouchesANodeHardlyLoadsIt) {
    Project project = row(30);
    for (const double gap : {0.0011, 0.0015, 0.0019, 0.00199999}) {
        project.regions = {lump(-0.005 - gap, 0.002)}; // node 0 alone lies in its rim
        project.regions[0].held.mass = 0.7;
        const double weight = nodeWeights(*project.network, project.regions[0])[0];
        ASSERT_GT(weight, 0);
        const TissueModel model = evaluateModel(project);
        const double beneath = 0.1 / 30;
        EXPECT_NEAR(model.mass[0], beneath + weight * (0.7 - beneath), 1e-12) << gap;
        EXPECT_EQ(model.mass[1], beneath) << gap;
    }
}

TEST(SoftRim, OfNoWidthGivesWhatASharpRegionGives) {
    Project project = row(30);
    project.regions = {lump(0.0035, 0), lump(0.0201, 1e-30)};
    for (Region& region : project.regions)
        region.held = {77.7, 0.3, 1.0 / 3};
    const TissueModel model = evaluateModel(project);
    for (std::size_t i = 0; i < 30; ++i) {
        const bool first = i <= 8, second = i >= 16 && i <= 25;
        EXPECT_EQ(model.springConstant[i], first || second ? 77.7 : 16) << i;
        EXPECT_EQ(model.viscosity[i], first || second ? 0.3 : 3) << i;
        EXPECT_EQ(model.mass[i], first ? 1.0 / 3 / 9 : second ? 1.0 / 3 / 10 : 0.1 / 30) << i;
    }
}

TEST(SoftRim, NeedsNoOrderAmongRegionsThatDoNotMeet) {
    Project project = row(40);
    project.regions = {lump(0.005, 0.004), lump(0.025, 0.006)};
    project.regions[0].held = {40, 2, 0.3};
    project.regions[1].held = {7, 9, 0.2};
    const TissueModel model = evaluateModel(project);
    std::swap(project.regions[0], project.regions[1]);
    const TissueModel swapped = evaluateModel(project);
    EXPECT_EQ(model.springConstant, swapped.springConstant);
    EXPECT_EQ(model.viscosity, swapped.viscosity);
    EXPECT_EQ(model.mass, swapped.mass);
}

TEST(SoftRim, LiesOverTheRegionsBeneath) {
    Project project = row(30);
    project.regions = {lump(0.005, 0), lump(0.012, 0.004)};
    project.regions[0].held.springConstant = 100;
    project.regions[1].held.springConstant = 0;
    const TissueModel model = evaluateModel(project);
    EXPECT_EQ(model.springConstant[7], 0);
    EXPECT_NEAR(model.springConstant[5], 50, 1e-9) << "half of what lies beneath";
    EXPECT_NEAR(model.springConstant[19], 8, 1e-9);
    EXPECT_EQ(model.springConstant[2], 100);
}

TEST(SoftRim, IsCountedApartFromTheInside) {
    const Project project = row(30);
    const RegionCount sharp = countOf(*project.network, lump(0.0105, 0));
    EXPECT_EQ(sharp.nodes, 10);
    EXPECT_EQ(sharp.springs, 9);
    EXPECT_EQ(sharp.rimNodes, 0);
    EXPECT_EQ(sharp.rimSprings, 0);
    const RegionCount soft = countOf(*project.network, lump(0.0105, 0.002));
    EXPECT_EQ(soft.nodes, 10);
    EXPECT_EQ(soft.springs, 9);
    EXPECT_EQ(soft.rimNodes, 4);
    EXPECT_EQ(soft.rimSprings, 4);
    Region beside = lump(0.5, 0.48);
    beside.ellipsoid->radii.setConstant(0.001);
    EXPECT_THAT(evaluateRegion(project, beside).tissue.warnings, ElementsAre(HasSubstr("only its soft rim")));
}
