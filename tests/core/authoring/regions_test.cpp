#include "core/authoring/regions.h"

#include "core/samples/samples.h"

#include <gmock/gmock.h>

using namespace esm;
using testing::ElementsAre;
using testing::IsEmpty;

namespace {

std::vector<std::string> namesOf(const Project& project) {
    std::vector<std::string> names;
    for (const Region& region : project.regions)
        names.push_back(region.name);
    return names;
}

Project layered() {
    Project project = makeSample("tube");
    project.regions.clear();
    for (const char* name : {"a", "b", "c", "d"}) {
        addRegion(project, nextId(project.regions), {0, 0, 0});
        project.regions.back().name = name;
    }
    return project;
}

SurfaceSpot topOf(const Project& project) {
    const auto& vertices = project.mesh->vertices;
    return {*std::max_element(vertices.begin(), vertices.end(),
                              [](const auto& a, const auto& b) { return a.y() < b.y(); }),
            Eigen::Vector3d::UnitY()};
}

} // namespace

TEST(Regions, MoveARegionByAnyNumberOfPlaces) {
    Project project = layered();
    const RegionId a{1}, b{2}, d{4};
    moveRegion(project, a, 2);
    EXPECT_THAT(namesOf(project), ElementsAre("b", "c", "a", "d"));
    moveRegion(project, d, -3);
    EXPECT_THAT(namesOf(project), ElementsAre("d", "b", "c", "a"));
    EXPECT_FALSE(canMoveRegion(project, d, -1));
    EXPECT_FALSE(canMoveRegion(project, b, 3));
    EXPECT_FALSE(canMoveRegion(project, b, 0));
    const RegionId whole = nextId(project.regions);
    setSystem(project, whole, nullptr);
    EXPECT_FALSE(canMoveRegion(project, whole, 1)) << "the whole organ stays beneath";
    EXPECT_FALSE(canMoveRegion(project, b, -2));
    EXPECT_TRUE(canMoveRegion(project, b, -1));
}

TEST(Regions, DuplicateIsAnotherRegionOfTheSameTissue) {
    Project project = layered();
    project.regions[1].rim = 0.002;
    project.regions[1].held.viscosity = 4;
    for (int i = 0; i < 2; ++i)
        duplicateRegion(project, project.regions[1].id, nextId(project.regions));
    EXPECT_THAT(namesOf(project), ElementsAre("a", "b", "b copy 2", "b copy 1", "c", "d"));
    const Region &first = project.regions[1], &copy = project.regions[2];
    EXPECT_EQ(copy.rim, first.rim);
    EXPECT_EQ(copy.held.viscosity, 4);
    EXPECT_EQ(copy.system, first.system);
    EXPECT_EQ(copy.ellipsoid->radii, first.ellipsoid->radii);
    EXPECT_NE(copy.ellipsoid->centre, first.ellipsoid->centre);
    EXPECT_THAT(validate(project), IsEmpty());
}

TEST(Regions, PlaceLaysASelectedRegionElsewhereAndKeepsItsSize) {
    Project project = layered();
    const SurfaceSpot spot = topOf(project);
    const Ellipsoid before = *project.regions[2].ellipsoid;
    placeRegion(project, project.regions[2].id, nextId(project.regions), spot);
    ASSERT_EQ(project.regions.size(), 4U);
    EXPECT_EQ(project.regions[2].ellipsoid->centre, spot.point);
    EXPECT_EQ(project.regions[2].ellipsoid->radii, before.radii);
}

TEST(Regions, PlaceAddsARegionOfASensibleSize) {
    for (const std::string& name : sampleNames()) {
        Project project = makeSample(name);
        if (project.mesh->triangles.empty()) continue;
        const std::size_t before = project.regions.size();
        const RegionId added = nextId(project.regions);
        placeRegion(project, added, added, topOf(project));
        ASSERT_EQ(project.regions.size(), before + 1);
        EXPECT_THAT(validate(project), IsEmpty()) << name;
        const std::size_t inside = countOf(*project.network, project.regions.back()).nodes;
        EXPECT_GT(inside, 0U) << name;
        EXPECT_LT(inside, project.network->restPositions.size()) << name;
    }
}
