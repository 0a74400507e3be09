#include "core/samples/samples.h"

#include "core/dynamics/measure/scene_run.h"
#include "core/support/errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace esm {
namespace {

Edge edgeOf(const Spring& spring) {
    return std::minmax({spring.first, spring.second});
}

class AnySample : public testing::TestWithParam<std::string> {};

TEST_P(AnySample, IsAValidProject) {
    const Project project = makeSample(GetParam());
    EXPECT_THAT(validate(project), testing::IsEmpty());
    EXPECT_THAT(validate(evaluateModel(project)), testing::IsEmpty());
    std::set<Edge> edges;
    for (const Spring& spring : project.network->springs) {
        EXPECT_TRUE(edges.insert(edgeOf(spring)).second) << "one spring between two nodes";
        const auto& rest = project.network->restPositions;
        EXPECT_DOUBLE_EQ(spring.restLength, (rest[spring.first] - rest[spring.second]).norm());
        EXPECT_GT(spring.restLength, 0);
    }
}

TEST_P(AnySample, IsTheSameEveryTime) {
    const Project first = makeSample(GetParam()), second = makeSample(GetParam());
    EXPECT_EQ(first.mesh->vertices, second.mesh->vertices);
    EXPECT_EQ(first.mesh->triangles, second.mesh->triangles);
    EXPECT_EQ(first.network->restPositions, second.network->restPositions);
}

TEST_P(AnySample, MovesInItsOwnSceneAndComesBack) {
    const Project project = makeSample(GetParam());
    Scene scene = project.scene;
    scene.record.every = scene.duration / 20;
    const auto& rest = project.network->restPositions;
    double farthest = 0, last = 0;
    const auto sink = [&](double, const std::vector<Eigen::Vector3d>& positions) {
        last = 0;
        for (std::size_t i = 0; i < rest.size(); ++i)
            last = std::max(last, (positions[i] - rest[i]).norm());
        farthest = std::max(farthest, last);
    };
    const SceneOutcome outcome = runScene({evaluateModel(project), project.mesh->triangles, scene}, sink);
    EXPECT_TRUE(outcome.stable) << outcome.outcome;
    EXPECT_GT(farthest, 0.002);
    EXPECT_LT(farthest, 0.04);
    EXPECT_LT(last, 0.7 * farthest);
}

INSTANTIATE_TEST_SUITE_P(All, AnySample, testing::ValuesIn(sampleNames()),
                         [](const auto& test) { return test.param; });

TEST(Samples, TubeHasThePublishedSprings) {
    const Project tube = makeSample("tube");
    EXPECT_EQ(tube.network->restPositions.size(), 170U);
    EXPECT_EQ(tube.network->springs.size(), 340U);
    EXPECT_EQ(tube.mesh->triangles.size(), 320U);
    EXPECT_EQ(tube.importReport->boundaryEdges, 20U);
    std::size_t around = 0, along = 0, across = 0;
    for (const Spring& spring : tube.network->springs) {
        const auto [low, high] = edgeOf(spring);
        if (high - low == 10)
            ++along;
        else if (high - low == 5)
            ++across;
        else if (high - low == 1 || high - low == 9)
            ++around;
    }
    EXPECT_EQ(around, 170U);
    EXPECT_EQ(along, 160U);
    EXPECT_EQ(across, 10U);

    const TissueModel model = evaluateModel(tube);
    EXPECT_EQ(model.tethers.size(), 57U);
    EXPECT_EQ(model.tethers[1].node, 3U);
    EXPECT_DOUBLE_EQ(model.tethers[1].springConstant, 2.41327);
    EXPECT_DOUBLE_EQ(model.tethers[1].viscosity, 10.6875);
    EXPECT_NEAR(valuesOf(model, 0).springConstant, 16.2606, 2e-4 * 16.26);
    EXPECT_NEAR(valuesOf(model, 0).viscosity, 2.87713, 2e-4 * 2.877);
    double mass = 0;
    for (const double nodeMass : model.mass)
        mass += nodeMass;
    EXPECT_NEAR(mass, 0.010, 1e-12);
    const Eigen::Vector3d size = boundingBox(tube.mesh->vertices).sizes();
    EXPECT_NEAR(size.maxCoeff(), 0.1, 0.01);
}

TEST(Samples, UterusIsThePublishedMotionModel) {
    const Project uterus = makeSample("uterus");
    EXPECT_EQ(uterus.network->restPositions.size(), 8U);
    EXPECT_EQ(uterus.network->springs.size(), 7U);
    ASSERT_TRUE(uterus.mesh);
    EXPECT_TRUE(uterus.mesh->triangles.empty());
    const TissueModel model = evaluateModel(uterus);
    EXPECT_EQ(model.fixedNodes, (std::vector<std::uint32_t>{2, 3, 4, 5, 6, 7}));
    EXPECT_NEAR(model.springConstant[0], 81.3091, 2e-4 * 81.31);
    EXPECT_NEAR(model.viscosity[0], 6, 2e-4 * 6);
    EXPECT_NEAR(model.mass[0], 0.5 / 8, 1e-12);
}

TEST(Samples, VentricleIsAClosedCavityWithThePublishedTissue) {
    const Project ventricle = makeSample("ventricle");
    EXPECT_TRUE(ventricle.importReport->isClosed());
    EXPECT_EQ(ventricle.importReport->components, 1U);
    EXPECT_EQ(ventricle.importReport->nonManifoldEdges + ventricle.importReport->inconsistentEdges, 0U);
    EXPECT_NEAR(double(ventricle.network->restPositions.size()), 1500, 150);
    const double volume = enclosedVolume(*ventricle.mesh);
    EXPECT_GT(volume, 10e-6);
    EXPECT_LT(volume, 30e-6);
    const TissueModel model = evaluateModel(ventricle);
    EXPECT_NEAR(model.springConstant[0], 45.4871, 2e-4 * 45.49);
    EXPECT_NEAR(model.viscosity[0], 72.8125, 2e-4 * 72.81);
}

TEST(Samples, LiverIsClosedEvenAndOfTheRightSize) {
    const Project liver = makeSample("liver");
    EXPECT_TRUE(liver.importReport->isClosed());
    EXPECT_EQ(liver.importReport->components, 1U);
    EXPECT_EQ(liver.importReport->nonManifoldEdges + liver.importReport->inconsistentEdges, 0U);
    EXPECT_NEAR(double(liver.network->restPositions.size()), 2500, 100);
    const Eigen::Vector3d size = boundingBox(liver.mesh->vertices).sizes();
    EXPECT_NEAR(size.x(), 0.22, 0.02);
    EXPECT_NEAR(size.y(), 0.15, 0.02);
    EXPECT_NEAR(size.z(), 0.10, 0.02);
    EXPECT_NEAR(enclosedVolume(*liver.mesh), 0.0015, 0.0002);
    double longest = 0, mean = 0;
    for (const Spring& spring : liver.network->springs) {
        longest = std::max(longest, spring.restLength);
        mean += spring.restLength / double(liver.network->springs.size());
    }
    EXPECT_LT(longest, 2 * mean);
    const TissueModel model = evaluateModel(liver);
    EXPECT_GT(model.fixedNodes.size(), 20U);
    ASSERT_EQ(liver.regions.size(), 2U);
    const RegionResult softer = evaluateRegion(liver, liver.regions[1]),
                       whole = evaluateRegion(liver, liver.regions[0]);
    EXPECT_GT(softer.nodes, 100U);
    EXPECT_LT(*softer.tissue.values.springConstant, *whole.tissue.values.springConstant);
}

TEST(Samples, AnUnknownNameIsAnsweredWithThoseThereAre) {
    try {
        makeSample("spleen");
        FAIL();
    } catch (const InvalidModel& error) {
        EXPECT_THAT(error.what(),
                    testing::AllOf(testing::HasSubstr("spleen"), testing::HasSubstr("tube, uterus")));
    }
}

} // namespace
} // namespace esm
