#include "app/editor/panels/tissue/region_counts.h"

#include "core/samples/samples.h"

#include <gtest/gtest.h>

using namespace esm;

namespace {

/// A tube with one region around all of it.
Project wrappedTube() {
    Project project = makeSample("tube");
    const auto box = boundingBox(project.network->restPositions);
    Ellipsoid ellipsoid;
    ellipsoid.centre = box.center();
    ellipsoid.radii = box.sizes();
    Region region;
    region.ellipsoid = ellipsoid;
    project.regions = {region};
    numberByPlace(project.regions);
    return project;
}

} // namespace

TEST(RegionCounts, CountsWhatLiesInside) {
    const Project project = wrappedTube();
    RegionCounts counts;
    EXPECT_EQ(counts.of(project, project.regions[0]).nodes, project.network->restPositions.size());
    EXPECT_EQ(counts.of(project, project.regions[0]).springs, project.network->springs.size());
}

TEST(RegionCounts, CountAnewWhereTheEllipsoidMoves) {
    Project project = wrappedTube();
    RegionCounts counts;
    counts.of(project, project.regions[0]);
    project.regions[0].ellipsoid->centre += Eigen::Vector3d(10, 0, 0);
    EXPECT_EQ(counts.of(project, project.regions[0]).nodes, 0U);
    project.regions[0].ellipsoid.reset();
    EXPECT_EQ(counts.of(project, project.regions[0]).nodes, project.network->restPositions.size());
}

TEST(RegionCounts, CountAnewWhereTheRimIsWidened) {
    Project project = wrappedTube();
    project.regions[0].ellipsoid->radii *= 0.2;
    RegionCounts counts;
    EXPECT_EQ(counts.of(project, project.regions[0]).rimNodes, 0U);
    project.regions[0].rim = 1;
    EXPECT_GT(counts.of(project, project.regions[0]).rimNodes, 0U);
}

TEST(RegionCounts, CountAnewInAnotherOrgan) {
    Project project = wrappedTube();
    RegionCounts counts;
    counts.of(project, project.regions[0]);
    project.network = makeSample("liver").network;
    project.regions[0].ellipsoid->radii = {100, 100, 100};
    const std::size_t before = counts.of(project, project.regions[0]).nodes;
    EXPECT_EQ(before, project.network->restPositions.size());
    project.network = makeSample("tube").network;
    EXPECT_EQ(counts.of(project, project.regions[0]).nodes, project.network->restPositions.size());
}

TEST(RegionCounts, FollowTheRegionsOrder) {
    Project project = wrappedTube();
    project.regions.push_back(project.regions[0]);
    project.regions[1].id = {2};
    project.regions[1].ellipsoid->centre += Eigen::Vector3d(10, 0, 0);
    RegionCounts counts;
    EXPECT_GT(counts.of(project, project.regions[0]).nodes, 0U);
    EXPECT_EQ(counts.of(project, project.regions[1]).nodes, 0U);
    std::swap(project.regions[0], project.regions[1]);
    EXPECT_EQ(counts.of(project, project.regions[0]).nodes, 0U);
    project.regions.resize(1);
    EXPECT_EQ(counts.of(project, project.regions[0]).nodes, 0U);
}
