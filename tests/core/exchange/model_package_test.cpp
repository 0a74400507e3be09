#include "tests/core/exchange/model_package_fixture.h"

#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/exchange/meshes/mesh_file.h"
#include "core/exchange/package/glb.h"
#include "core/exchange/project/model_json.h"
#include "core/exchange/project/project_file.h"
#include "tests/core/exchange/overwrite.h"
#include "tests/core/exchange/rounded_tissue.h"
#include "tests/core/exchange/strangers_reader.h"
#include "tests/support/exchange_projects.h"
#include "tests/support/full_disk.h"
#include "tests/support/same_project.h"

#include <cstdlib>

namespace esm {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

TEST_F(ModelPackageFile, HoldsTheTissueRoundedToFloat) {
    const Project project = richProject();
    const ModelPackage package = exported(project);
    EXPECT_EQ(package.name, project.name);
    EXPECT_EQ(package.mesh.vertices, rounded(project.mesh->vertices));
    EXPECT_EQ(package.mesh.triangles, project.mesh->triangles);
    expectSameTissue(package.tissue, evaluateModel(project));
    EXPECT_EQ(package.base.mass, project.base.mass);
    EXPECT_EQ(package.baseColour, project.texture.baseColour);
}

TEST_F(ModelPackageFile, ShowsAPictureOfItsOrganBesideTheTexture) {
    const Project project = richProject();
    Image drawn{2, 1, {10, 20, 30, 255, 40, 50, 60, 255}};
    exportPackage(project, m_file, {{}, [&](const Project& packed, const auto& pages) {
                                        EXPECT_EQ(pages.colours->size(),
                                                  static_cast<std::size_t>(packed.atlas->options.pages));
                                        return drawn;
                                    }});
    const ModelPackage package = loadPackage(m_file);
    EXPECT_EQ(package.preview.pixels, drawn.pixels);
    EXPECT_EQ(package.textures.size(), exported(project).textures.size());
    EXPECT_TRUE(loadPackage(m_file).preview.empty()) << "exported without one";
}

TEST_F(ModelPackageFile, APreviewThatIsNoneOrFillsTheMemoryIsRefused) {
    exportPackage(richProject(), m_file, {{}, [](const Project&, const auto&) {
                                              return Image{5000, 1, Bytes(std::size_t{4} * 5000, 255)};
                                          }});
    EXPECT_THAT(loadingError(), HasSubstr("at most 4096 pixels"));
    Glb glb = parseGlb(readFile(m_file));
    glb.json["extensions"]["ESM_spring_mass"]["preview"] = 99;
    rewrite(glb);
    EXPECT_THAT(loadingError(), HasSubstr("preview"));
}

TEST_F(ModelPackageFile, KeepsRegionsAsTheyWerePutIn) {
    const Project project = richProject();
    const ModelPackage package = exported(project);
    expectSameRegions(package.regions, project.regions);
}

TEST_F(ModelPackageFile, HoldsTheWayToStepThatIsRecommended) {
    Project project = richProject();
    expectSameStepping(exported(project).stepping, project.stepping);
    project.stepping.reset();
    EXPECT_FALSE(exported(project).stepping);
}

TEST_F(ModelPackageFile, HoldsBiphasicSprings) {
    const Project project = biphasicProject();
    const ModelPackage package = exported(project);
    expectSameTissue(package.tissue, evaluateModel(project));
    expectSameStiffening(package.base.stiffening, project.base.stiffening);
}

TEST_F(ModelPackageFile, IsReadByAStrangersReader) {
    Project project = richProject();
    expectReadIndependently(project, m_folder.path());
    project.layers.clear();
    project.atlas = nullptr;
    project.regions.clear();
    project.scene = {};
    expectReadIndependently(project, m_folder.path());
    expectReadIndependently(bareProject(), m_folder.path());
    expectReadIndependently(biphasicProject(), m_folder.path());
    expectReadIndependently(extendedInferenceProject(), m_folder.path());
    expectReadIndependently(softProject(), m_folder.path());
}

TEST_F(ModelPackageFile, IsReadByTheReaderOfTheSpecification) {
    exportPackage(biphasicProject(), m_file);
    const std::string source = ESM_SOURCE_DIR, counts = (m_folder / "counts.json").string();
    const std::string command = "python3 '" + source + "/tests/cli/documented_reader.py' '" + source +
                                "/docs/model-package.md' '" + m_file.string() + "' > '" + counts + "'";
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
    const Bytes text = readFile(counts);
    const Json json = Json::parse(text.begin(), text.end());
    EXPECT_EQ(json["nodes"]["restPosition"], 3 * 48);
    EXPECT_EQ(json["springs"]["nodes"], 2 * 144);
    EXPECT_EQ(json["springs"]["restLength"], 144);
    EXPECT_EQ(json["tethers"]["viscosity"], 23);
    EXPECT_EQ(json["fixedNodes"]["nodes"], 2);
    EXPECT_EQ(json["surface"]["triangles"], 3 * 96);
    EXPECT_EQ(json["stiffening"], writtenFields(*biphasicProject().base.stiffening));
}

TEST_F(ModelPackageFile, DrawnVerticesMayOutnumberTheNodes) {
    Project project = richProject();
    project.atlas = nullptr;
    project.layers.clear();
    auto network = std::make_shared<SpringNetwork>(*project.network);
    // The last two vertices hang on node 0, as where the drawn surface is finer than the simulated one.
    network->vertexNodes[46] = network->vertexNodes[47] = 0;
    project.network = network;
    expectReadIndependently(project, m_folder.path());
    EXPECT_EQ(exported(project).tissue.network->vertexNodes, network->vertexNodes);
}

TEST_F(ModelPackageFile, HoldsHowFewerNodesCarryTheSurface) {
    for (Project project : {boundProject({Detail::Kind::Nodes, 20}), boundProject({Detail::Kind::Rigid, 0}),
                            latticeProject(), rowsProject(3), rowsProject(4), rowsProject(9)}) {
        expectReadIndependently(project, m_folder.path());
        expectSameTissue(exported(project).tissue, evaluateModel(project));
        project.layers.clear();
        project.atlas = nullptr;
        expectReadIndependently(project, m_folder.path());
        expectSameTissue(exported(project).tissue, evaluateModel(project));
    }
}

TEST_F(ModelPackageFile, GivesSimulatorsRowsOfAnyNumberOfNodes) {
    for (const Project& project : {latticeProject(), rowsProject(4)}) {
        exportPackage(project, m_file);
        const PackagedTissue package = loadPackagedTissue(m_file);
        expectSameTissue(package.tissue, evaluateModel(project));
        const std::vector<Eigen::Vector3d> drawn =
            drawnPositions(package.mesh, *package.tissue.network, package.tissue.network->restPositions);
        for (std::size_t i = 0; i < drawn.size(); ++i)
            EXPECT_LT((drawn[i] - project.mesh->vertices[i]).norm(), 1e-8);
    }
}

TEST_F(ModelPackageFile, IsOfTheVersionThatItsReadersNeed) {
    const auto version = [&](const Project& project) {
        exportPackage(project, m_file);
        return parseGlb(readFile(m_file)).json["extensions"]["ESM_spring_mass"]["version"].get<int>();
    };
    EXPECT_EQ(version(richProject()), 1);
    EXPECT_EQ(version(boundProject({Detail::Kind::Nodes, 20})), 2);
    EXPECT_EQ(version(boundProject({Detail::Kind::Rigid, 0})), 2);
    EXPECT_EQ(version(biphasicProject()), 3);
    EXPECT_EQ(version(extendedInferenceProject()), 4);
    EXPECT_EQ(version(softProject()), 5);
    EXPECT_EQ(version(latticeProject()), 6);
    EXPECT_EQ(version(rowsProject(1)), 2);
    EXPECT_EQ(version(rowsProject(3)), 2);
    EXPECT_EQ(version(rowsProject(4)), 6);
}

TEST_F(ModelPackageFile, OpensWithAWarningWhatViewersShowOtherwise) {
    exportPackage(richProject(), m_file);
    EXPECT_THAT(openPackage(m_file).warnings, testing::IsEmpty());
    Glb glb = parseGlb(readFile(m_file));
    glb.json["nodes"][0]["scale"] = {1000, 1000, 1000};
    glb.json["images"][0]["uri"] = "skin.png";
    rewrite(glb);
    const OpenedPackage opened = openPackage(m_file);
    expectSameTissue(opened.package.tissue, evaluateModel(richProject()));
    EXPECT_THAT(opened.warnings,
                testing::ElementsAre(HasSubstr("nodes[0] should have no scale"), HasSubstr("images[0]")));
    EXPECT_EQ(validatePackage(m_file), opened.warnings);
}

TEST_F(ModelPackageFile, WarnsOfSpringsThatAreMuchTooLong) {
    Project project = richProject();
    SpringNetwork network = *project.network;
    network.springs[0].restLength = 50;
    project.network = std::make_shared<SpringNetwork>(network);
    exportPackage(project, m_file);
    EXPECT_THAT(openPackage(m_file).warnings, testing::ElementsAre(HasSubstr("rest length")));
}

TEST_F(ModelPackageFile, ModelsWithoutSurfaceShowTheirSprings) {
    const ModelPackage package = exported(bareProject());
    expectSameTissue(package.tissue, evaluateModel(bareProject()));
    EXPECT_TRUE(package.mesh.triangles.empty());
    EXPECT_EQ(parseGlb(readFile(m_file)).json["meshes"][0]["primitives"][0]["mode"], 1);
}

TEST_F(ModelPackageFile, OtherReadersSeeTheSurface) {
    const Project project = richProject();
    exportPackage(project, m_file);
    const PolygonSoup soup = readMeshFile(m_file);
    ASSERT_EQ(soup.polygons.size(), project.mesh->triangles.size());
    const std::vector<Eigen::Vector3d> expected = rounded(project.mesh->vertices);
    for (std::size_t i = 0; i < soup.polygons.size(); ++i)
        for (std::size_t corner = 0; corner < 3; ++corner)
            EXPECT_EQ(soup.vertices[soup.polygons[i][corner]], expected[project.mesh->triangles[i][corner]]);
}

TEST_F(ModelPackageFile, TheSameProjectGivesTheSameBytes) {
    exportPackage(richProject(), m_file);
    const Bytes once = readFile(m_file);
    exportPackage(richProject(), m_file);
    EXPECT_EQ(once, readFile(m_file));
}

TEST_F(ModelPackageFile, NumbersThatFloatsCannotHoldAreRefused) {
    Project project = bareProject();
    project.base.springConstant = 1e39;
    EXPECT_THAT(exportError(project),
                testing::AllOf(HasSubstr("organ.glb: "), HasSubstr("spring constant must be")));
    project = bareProject();
    project.base.mass = 1e-44;
    EXPECT_THAT(exportError(project), HasSubstr("mass must be above 0"));
    project = richProject();
    auto mesh = std::make_shared<TriangleMesh>(*project.mesh);
    mesh->vertices[3].y() = 1e200;
    project.mesh = mesh;
    EXPECT_THAT(exportError(project), HasSubstr("coordinate of a vertex"));
    EXPECT_FALSE(std::filesystem::exists(m_file));
}

TEST_F(ModelPackageFile, AnExportThatFailsLeavesTheOldFile) {
    exportPackage(bareProject(), m_file);
    const Bytes before = readFile(m_file);
    const Project project = richProject();
    EXPECT_THROW(exportPackage(project, m_file, {[](double fraction) { return fraction < 0.7; }, {}}),
                 Cancelled);
    EXPECT_EQ(before, readFile(m_file));
    EXPECT_TRUE(throwsOnFullDisk<FileError>(before.size(), [&] { exportPackage(project, m_file); }));
    EXPECT_EQ(before, readFile(m_file));
    Project impossible = richProject();
    impossible.atlas = nullptr;
    impossible.texture.atlas = {4, 1, 2};
    EXPECT_THROW(exportPackage(impossible, m_file), FileError);
    EXPECT_EQ(before, readFile(m_file));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(m_folder.path()), {}), 1);
}

TEST_F(ModelPackageFile, IsToldFromAProjectByItsFirstBytes) {
    const auto written = [&](const char* name, const std::string& content) {
        overwrite(m_folder / name, content);
        return m_folder / name;
    };
    EXPECT_TRUE(isModelPackage(written("a.esm", "glTF and more")));
    EXPECT_FALSE(isModelPackage(written("b.glb", "PK\3\4 and more")));
    EXPECT_TRUE(isModelPackage(written("c.glb", "gl")));
    EXPECT_FALSE(isModelPackage(written("d.esm", "gl")));
    EXPECT_TRUE(isModelPackage(m_folder / "missing.glb"));
    EXPECT_FALSE(isModelPackage(m_folder.path()));
}

} // namespace
} // namespace esm
