#include "core/project/project.h"

#include "core/project/surroundings.h"
#include "core/support/errors.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numeric>

using namespace esm;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

/// A square sheet in z = 0 with `cells` × `cells` cells and the given side, m; open.
TriangleMesh sheet(std::uint32_t cells, double side) {
    TriangleMesh mesh;
    const std::uint32_t row = cells + 1;
    for (std::uint32_t y = 0; y < row; ++y)
        for (std::uint32_t x = 0; x < row; ++x)
            mesh.vertices.emplace_back(side * x / cells, side * y / cells, 0);
    for (std::uint32_t y = 0; y < cells; ++y)
        for (std::uint32_t x = 0; x < cells; ++x) {
            const std::uint32_t corner = y * row + x;
            mesh.triangles.push_back({corner, corner + 1, corner + row + 1});
            mesh.triangles.push_back({corner, corner + row + 1, corner + row});
        }
    return mesh;
}

TriangleMesh tetrahedron(double side) {
    return {{{0, 0, 0}, {side, 0, 0}, {0, side, 0}, {0, 0, side}},
            {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

Project projectOf(TriangleMesh mesh, bool closed, std::optional<double> mass = std::nullopt) {
    RepairedMesh surface{std::move(mesh), {}};
    surface.report.boundaryEdges = closed ? 0 : 4;
    return makeProject("trial", std::move(surface), mass);
}

Region ball(const Eigen::Vector3d& centre, double radius) {
    Region region;
    region.ellipsoid = Ellipsoid{};
    region.ellipsoid->centre = centre;
    region.ellipsoid->radii.setConstant(radius);
    return region;
}

double total(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

} // namespace

TEST(Project, WeighsWhatItIsGivenElseItsVolumeElseItsWall) {
    EXPECT_DOUBLE_EQ(projectOf(tetrahedron(0.1), true, 0.25).base.mass, 0.25);
    EXPECT_NEAR(projectOf(tetrahedron(0.1), true).base.mass, 1000 * 0.001 / 6, 1e-12);
    EXPECT_NEAR(projectOf(sheet(10, 0.1), false).base.mass, 0.01 * 0.003 * 1000, 1e-12);
}

TEST(Project, WeighsAFlatClosedSurfaceByItsWall) {
    TriangleMesh flat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}};
    EXPECT_NEAR(projectOf(flat, true).base.mass, 3, 1e-12);
}

TEST(Project, WeighsByItsWallWhereInsideAndOutsideCannotBeToldApart) {
    RepairedMesh surface{tetrahedron(0.1), {}};
    surface.report.inconsistentEdges = 1;
    EXPECT_NEAR(makeProject("trial", surface).base.mass, surfaceArea(surface.mesh) * 0.003 * 1000, 1e-12);
}

TEST(Project, RefusesAMassThatIsNone) {
    for (const double mass : {0.0, -1.0, double{NAN}, double{INFINITY}, 1e-40})
        EXPECT_THROW(projectOf(tetrahedron(0.1), true, mass), InvalidModel) << mass;
}

TEST(Project, IsSoundAtAnySize) {
    for (const double side : {1e-6, 1e-3, 0.1, 10.0, 1e4}) {
        EXPECT_THAT(validate(projectOf(sheet(6, side), false)), IsEmpty()) << side;
        EXPECT_THAT(validate(projectOf(tetrahedron(side), true)), IsEmpty()) << side;
    }
}

TEST(Project, TiesEveryPartWithThreeTethersAtLeast) {
    TriangleMesh parts = sheet(8, 0.1);
    EXPECT_EQ(projectOf(parts, false).scene.tethers.at(0).every, 3);
    const auto corner = static_cast<std::uint32_t>(parts.vertices.size());
    parts.vertices.insert(parts.vertices.end(), {{1, 0, 0}, {1, 1, 0}, {1, 1, 1}});
    parts.triangles.push_back({corner, corner + 1, corner + 2});
    EXPECT_EQ(projectOf(parts, false).scene.tethers.at(0).every, 1);
}

TEST(Model, SpreadsTheMassEvenlyAndTakesTheBaseTissue) {
    Project project = projectOf(sheet(4, 0.1), false, 0.5);
    project.base.springConstant = 7;
    project.base.viscosity = 2;
    project.base.stiffening = SpringStiffening{0.2, 5};
    const TissueModel model = evaluateModel(project);
    EXPECT_THAT(model.mass, Each(0.5 / 25));
    EXPECT_THAT(model.springConstant, Each(7.0));
    EXPECT_THAT(model.viscosity, Each(2.0));
    ASSERT_TRUE(model.stiffening);
    EXPECT_EQ(model.stiffening->strain, 0.2);
    EXPECT_EQ(model.stiffening->factor, 5);
    EXPECT_THAT(validate(model), IsEmpty());
}

TEST(Model, BendsFreelyOrAsAWallOfItsThickness) {
    Project project = projectOf(sheet(4, 0.1), false, 0.5);
    EXPECT_THAT(evaluateModel(project).hinges, IsEmpty());
    project.base.resistsBending = true;
    const TissueModel model = evaluateModel(project);
    EXPECT_EQ(model.hinges.size(), 40U); // of 56 edges, 16 of them at the border
    EXPECT_THAT(validate(project), IsEmpty());
    project.base.wallThickness = 0;
    EXPECT_THAT(validate(project), ElementsAre(HasSubstr("the wall's thickness must be")));
}

TEST(Model, LaysLaterRegionsOverEarlierOnes) {
    Project project = projectOf(sheet(2, 2), false); // nodes at 0, 1, 2 in x and y
    Region whole, corner = ball({0, 0, 0}, 1.1), nothing = ball({9, 9, 9}, 1);
    whole.held = {40, 4, {}};
    corner.held = {{}, 8, 0.6};
    nothing.held = {99, 99, 99};
    project.regions = {whole, corner, nothing};
    const TissueModel model = evaluateModel(project);
    EXPECT_THAT(model.springConstant, Each(40.0));
    EXPECT_THAT(model.viscosity, ElementsAre(8, 8, 4, 8, 4, 4, 4, 4, 4));
    for (const std::size_t node : {0U, 1U, 3U})
        EXPECT_DOUBLE_EQ(model.mass[node], 0.2);
    EXPECT_DOUBLE_EQ(model.mass[4], project.base.mass / 9);
    EXPECT_NEAR(total(model.mass), project.base.mass * 6 / 9 + 0.6, 1e-12);

    std::swap(project.regions[0], project.regions[1]);
    EXPECT_THAT(evaluateModel(project).viscosity, Each(4.0));
}

TEST(Model, TakesTethersAndFixedNodesFromTheScene) {
    const Project project = projectOf(sheet(2, 2), false);
    Scene scene;
    scene.tethers = {{4, 1.5, 2.5}};
    Ellipsoid corner;
    corner.radii.setConstant(1.1);
    scene.fixed = {{{8, 1}, {}}, {{1}, corner}};
    const TissueModel model = evaluateModel(project, scene);
    EXPECT_THAT(model.fixedNodes, ElementsAre(0, 1, 3, 8));
    ASSERT_EQ(model.tethers.size(), 3);
    EXPECT_EQ(tetherCountOf(*model.network, scene), 3);
    EXPECT_EQ(model.tethers[2].node, 8);
    EXPECT_EQ(model.tethers[2].springConstant, 1.5);
    EXPECT_EQ(model.tethers[2].viscosity, 2.5);
}

TEST(SceneWarnings, NameWhatHasNoEffect) {
    const Project project = projectOf(sheet(2, 2), false);
    Scene scene;
    Ellipsoid corner, nowhere;
    corner.radii.setConstant(1.1);
    nowhere.centre = {9, 9, 9};
    scene.fixed = {{{8}, {}}, {{}, corner}, {{4}, nowhere}};
    scene.forces = {{5, {0, 0, 1}, 0, 1}, {8, {0, 0, 1}, 0, 1}};
    scene.moves = {{0, {{0, {0, 0, 0}}}}, {7, {{0, {0, 0, 0}}}}};
    EXPECT_THAT(sceneWarnings(scene, evaluateModel(project, scene)),
                ElementsAre(HasSubstr("fixed[2]: the ellipsoid holds no node"),
                            HasSubstr("forces[1]: node 8 is fixed"), HasSubstr("moves[0]: node 0 is fixed")));
    EXPECT_THAT(sceneWarnings(project.scene, evaluateModel(project)), IsEmpty());
}

TEST(RegionResult, CountsNodesAndTheSpringsBetweenThem) {
    const Project project = projectOf(sheet(2, 2), false);
    const RegionResult corner = evaluateRegion(project, ball({0, 0, 0}, 1.1));
    EXPECT_EQ(corner.nodes, 3);
    EXPECT_EQ(corner.springs, 2);
    const RegionResult whole = evaluateRegion(project, Region{});
    EXPECT_EQ(whole.nodes, 9);
    EXPECT_EQ(whole.springs, project.network->springs.size());
    EXPECT_THAT(whole.tissue.warnings, IsEmpty());
}

TEST(RegionResult, WarnsOfARegionWithoutNodes) {
    const RegionResult result = evaluateRegion(projectOf(sheet(2, 2), false), ball({9, 9, 9}, 1));
    EXPECT_EQ(result.nodes, 0);
    EXPECT_EQ(result.springs, 0);
    EXPECT_THAT(result.tissue.warnings, ElementsAre(HasSubstr("holds no node")));
}

TEST(Project, ReportsTheProblemsOfAllItsParts) {
    Project project = projectOf(sheet(2, 2), false);
    project.base.mass = 0;
    project.base.stiffening = SpringStiffening{NAN, 0};
    project.scene.duration = -1;
    project.scene.forces = {{77, {0, 0, 0}, 0, 1}};
    Region region = ball({0, 0, 0}, -1);
    region.name = "tumour";
    region.held.viscosity = -3;
    region.rim = NAN;
    project.regions = {region};
    project.layers = {{}};
    project.layers[0].blending = Blending::MultiBand;
    project.layers[0].projector.width = NAN;
    EXPECT_THAT(validate(project),
                ElementsAre(HasSubstr("organ's mass"), HasSubstr("the strain"), HasSubstr("the factor"),
                            HasSubstr("scene: duration"), HasSubstr("forces[0]"),
                            HasSubstr("region 1 (tumour): ellipsoid"),
                            HasSubstr("the soft rim must be 0 or more"),
                            HasSubstr("the viscosity must be 0 or more"), HasSubstr("blended in bands"),
                            HasSubstr("width")));
    EXPECT_THAT(validate(Project{}), ElementsAre(HasSubstr("no organ")));
}

TEST(Project, ReportsTexturesAndPhotosBeyondAllUse) {
    Project project = projectOf(sheet(2, 2), false);
    const Atlas packed = packAtlas(*project.mesh, {64, 1, 1});
    project.atlas = std::make_shared<Atlas>(packed);
    ASSERT_THAT(validate(project), ElementsAre());
    project.texture.atlas = {16384, 256, 1};
    Atlas beyond = packed;
    beyond.corners[0][0].x() = 1e300;
    project.atlas = std::make_shared<Atlas>(beyond);
    EXPECT_THAT(validate(project), ElementsAre(HasSubstr("number of pages"), HasSubstr("(triangle 0)")));

    project.texture.atlas = {};
    project.atlas = nullptr;
    TextureLayer layer;
    layer.photo = std::make_shared<Photo>();
    layer.projector.width = 1e-308;
    layer.projector.height = 1e4;
    project.layers = {layer};
    EXPECT_THAT(validate(project),
                ElementsAre(HasSubstr("projector's width"), HasSubstr("projector's height")));
    Projector& projector = project.layers[0].projector;
    projector.kind = ProjectorKind::Perspective;
    EXPECT_TRUE(validate(project).empty()) << "width and height say nothing";
    projector.fieldOfView = NAN;
    EXPECT_THAT(validate(project), ElementsAre(HasSubstr("field of view")));
    projector.intrinsics = Intrinsics{0, 1, NAN, 0};
    EXPECT_THAT(validate(project), ElementsAre(HasSubstr("focal length fx"), HasSubstr("principal point")));
    projector.intrinsics = Intrinsics{1, 1, 0, 0};
    EXPECT_TRUE(validate(project).empty());
}
