#include "core/exchange/simulators/inventor_file.h"

#include "core/exchange/simulators/exporters.h"
#include "core/support/errors.h"
#include "core/texture/layers/composite.h"
#include "tests/support/exchange_projects.h"
#include "tests/support/inventor_scene.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace esm {
namespace {

class InventorFile : public testing::Test {
protected:
    test::InventorScene exported(const Project& project) const {
        exportProject(project, exporterFor(m_file), m_file);
        return test::InventorScene(m_file);
    }

    TemporaryFolder m_folder;
    std::filesystem::path m_file = m_folder / "organ.iv";
};

template<class Things, class Value> std::vector<float> floatsOf(const Things& things, Value valueOf) {
    std::vector<float> values;
    for (const auto& thing : things)
        values.push_back(static_cast<float>(valueOf(thing)));
    return values;
}

std::vector<float> floatsOf(const std::vector<double>& values) {
    return floatsOf(values, [](double value) { return value; });
}

TEST_F(InventorFile, HoldsNodesAndSpringsAsFloats) {
    const Project project = richProject();
    const TissueModel tissue = evaluateModel(project);
    const test::InventorScene scene = exported(project);
    EXPECT_EQ(scene.floats("nodesMass"), floatsOf(tissue.mass));
    EXPECT_EQ(scene.floats("nodesSpringConstant"), floatsOf(tissue.springConstant));
    EXPECT_EQ(scene.floats("nodesViscosity"), floatsOf(tissue.viscosity));
    std::vector<std::int32_t> ends;
    for (const Spring& spring : tissue.network->springs)
        for (const std::uint32_t end : {spring.first, spring.second})
            ends.push_back(static_cast<std::int32_t>(end));
    EXPECT_EQ(scene.integers("springsNodes"), ends);
    EXPECT_EQ(scene.floats("springsRestLength"),
              floatsOf(tissue.network->springs, [](const Spring& spring) { return spring.restLength; }));
    const std::vector<SpringValues> values = springValues(tissue);
    EXPECT_EQ(scene.floats("springsSpringConstant"),
              floatsOf(values, [](const SpringValues& value) { return value.springConstant; }));
    EXPECT_EQ(scene.floats("springsViscosity"),
              floatsOf(values, [](const SpringValues& value) { return value.viscosity; }));
    const std::vector<Eigen::Vector3f> places = scene.vectors("nodesRestPosition");
    ASSERT_EQ(places.size(), tissue.network->restPositions.size());
    for (std::size_t node = 0; node < places.size(); ++node)
        EXPECT_EQ(places[node], tissue.network->restPositions[node].cast<float>());
}

TEST_F(InventorFile, HoldsWhatHoldsTheOrgan) {
    const Project project = richProject();
    const TissueModel tissue = evaluateModel(project);
    const test::InventorScene scene = exported(project);
    const std::vector<std::int32_t> fixed = scene.integers("nodesFixed"),
                                    tethered = scene.integers("tethersNode");
    for (std::uint32_t node = 0; node < fixed.size(); ++node)
        EXPECT_EQ(fixed[node], std::ranges::count(tissue.fixedNodes, node)) << node;
    ASSERT_EQ(tethered.size(), tissue.tethers.size());
    for (std::size_t i = 0; i < tethered.size(); ++i)
        EXPECT_EQ(static_cast<std::uint32_t>(tethered[i]), tissue.tethers[i].node);
    EXPECT_EQ(scene.floats("tethersSpringConstant"),
              floatsOf(tissue.tethers, [](const Tether& tether) { return tether.springConstant; }));
}

TEST_F(InventorFile, DrawsEveryTriangleWithTheTexelsThatAreItsOwn) {
    const Project project = paintedProject();
    const test::InventorScene scene = exported(project);
    const std::vector<test::InventorTriangle> triangles = scene.triangles();
    ASSERT_EQ(triangles.size(), project.mesh->triangles.size());
    for (std::size_t triangle = 0; triangle < triangles.size(); ++triangle)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Eigen::Vector3d& vertex = project.mesh->vertices[project.mesh->triangles[triangle][corner]];
            const Eigen::Vector2d place =
                project.atlas->corners[triangle][corner] / project.atlas->options.size;
            EXPECT_EQ(triangles[triangle].places[corner], vertex.cast<float>());
            EXPECT_NEAR(triangles[triangle].texture[corner].x(), place.x(), 1e-6);
            EXPECT_NEAR(triangles[triangle].texture[corner].y(), 1 - place.y(), 1e-6);
        }
    const std::vector<Image> pages =
        composite(*project.mesh, *project.atlas, project.layers, project.texture.baseColour);
    const std::vector<Image> read = scene.pages();
    ASSERT_EQ(read.size(), 1U);
    ASSERT_EQ(read[0].pixels.size(), pages[0].pixels.size());
    std::size_t others = 0;
    for (std::size_t i = 0; i < read[0].pixels.size(); ++i)
        others += i % 4 != 3 && read[0].pixels[i] != pages[0].pixels[i];
    EXPECT_EQ(others, 0U) << "of the page's channels";
}

TEST_F(InventorFile, DrawsEachPageByItself) {
    Project project = richProject();
    project.texture.atlas.pages = 3;
    project.atlas = std::make_shared<Atlas>(packAtlas(*project.mesh, project.texture.atlas));
    const test::InventorScene scene = exported(project);
    EXPECT_EQ(scene.pages().size(), 3U);
    EXPECT_EQ(scene.triangles().size(), project.mesh->triangles.size());
}

TEST_F(InventorFile, IsColouredAsTheOrganWithoutTexture) {
    const Project project = sheetProject();
    const test::InventorScene scene = exported(project);
    EXPECT_TRUE(scene.pages().empty());
    EXPECT_EQ(scene.triangles().size(), project.mesh->triangles.size());
    const Eigen::Vector3f colour = scene.colour();
    for (int channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(colour[channel], project.texture.baseColour[static_cast<std::size_t>(channel)] / 255.0,
                    1e-6);
}

TEST_F(InventorFile, IsWrittenAgainUnchangedByWhoDoesNotKnowTheModel) {
    for (const Project& project : {richProject(), filledProject(), boundProject({Detail::Kind::Nodes, 20})}) {
        const test::InventorScene scene = exported(project);
        const std::filesystem::path again = m_folder / "again.iv";
        scene.write(again);
        EXPECT_TRUE(scene.hasSameModelAs(test::InventorScene(again)));
        EXPECT_FALSE(scene.hasSameModelAs(exported(biphasicProject())));
    }
}

TEST_F(InventorFile, HoldsTheTetrahedraOfAFilledOrganAndWhatCarriesItsSurface) {
    const Project project = filledProject();
    const test::InventorScene scene = exported(project);
    const auto corners = scene.integers("tetrahedraNodes");
    const std::vector<Tetrahedron>& tetrahedra = project.network->lattice->tetrahedra;
    ASSERT_EQ(corners.size(), 4 * tetrahedra.size());
    for (std::size_t i = 0; i < corners.size(); ++i)
        EXPECT_EQ(static_cast<std::uint32_t>(corners[i]), tetrahedra[i / 4][i % 4]);
    const auto vertices = scene.integers("bindingVertex"), nodes = scene.integers("bindingNode");
    const std::vector<float> shares = scene.floats("bindingShare");
    const std::vector<Eigen::Vector3f> places = scene.vectors("nodesRestPosition");
    std::vector<Eigen::Vector3f> carried(project.mesh->vertices.size(), Eigen::Vector3f::Zero());
    for (std::size_t i = 0; i < vertices.size(); ++i)
        carried[static_cast<std::size_t>(vertices[i])] +=
            shares[i] * places[static_cast<std::size_t>(nodes[i])];
    for (std::size_t vertex = 0; vertex < carried.size(); ++vertex)
        EXPECT_LT((carried[vertex] - project.mesh->vertices[vertex].cast<float>()).norm(), 1e-6) << vertex;
}

TEST_F(InventorFile, ShowsSpringsOrNodesWithoutASurface) {
    Project project = bareProject();
    EXPECT_EQ(exported(project).lineCount(), project.network->springs.size());
    SpringNetwork network = *project.network;
    network.springs.clear();
    project.network = std::make_shared<SpringNetwork>(network);
    const test::InventorScene scene = exported(project);
    EXPECT_EQ(scene.lineCount(), 0U);
    EXPECT_EQ(scene.pointCount(), network.restPositions.size());
    EXPECT_FALSE(scene.has("springsNodes"));
}

TEST_F(InventorFile, KeepsNamesOfAnyLetters) {
    Project project = bareProject();
    Region region;
    region.held.viscosity = 1;
    for (const std::string name :
         {"Leber / „rechts“ \"außen\"", "", "\"", "2. Lappen {x} # [y], z", "a\\", "b\\\"c", "line\nbreak"}) {
        project.name = region.name = name;
        project.regions = {region, region};
        const test::InventorScene scene = exported(project);
        std::string kept = name;
        std::ranges::replace(kept, '\\', '/');
        std::ranges::replace(kept, '\n', ' ');
        EXPECT_THAT(scene.words("modelName"), testing::ElementsAre(kept));
        EXPECT_THAT(scene.words("regionsName"), testing::ElementsAre(kept, kept));
        EXPECT_EQ(scene.integers("nodesRegion").size(), project.network->restPositions.size());
    }
}

TEST_F(InventorFile, RefusesWhatFloatsCannotHold) {
    Project project = richProject();
    TriangleMesh mesh = *project.mesh;
    mesh.vertices[7].x() = 1e39;
    project.mesh = std::make_shared<TriangleMesh>(mesh);
    try {
        exported(project);
        ADD_FAILURE() << "it would stand at infinity";
    } catch (const FileError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("beyond the range of Open Inventor's 32-bit numbers"));
    }
    EXPECT_FALSE(std::filesystem::exists(m_file));
}

} // namespace
} // namespace esm
