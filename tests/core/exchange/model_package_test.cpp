#include "core/exchange/model_package.h"

#include "core/exchange/fuzzy_file.h"
#include "core/exchange/glb.h"
#include "core/exchange/mesh_file.h"
#include "core/exchange/project_file.h"
#include "core/support/errors.h"
#include "core/texture/composite.h"
#include "tests/core/exchange/exchange_projects.h"
#include "tests/core/exchange/overwrite.h"
#include "tests/core/exchange/rounded_tissue.h"
#include "tests/support/full_disk.h"
#include "tests/support/same_project.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <cstdlib>

namespace esm {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

class ModelPackageFile : public testing::Test {
protected:
    ModelPackage exported(const Project& project) const {
        exportPackage(project, m_file);
        EXPECT_THAT(validatePackage(m_file), testing::IsEmpty());
        return loadPackage(m_file);
    }

    std::string loadingError() const {
        try {
            loadPackage(m_file);
        } catch (const FileError& error) {
            return error.what();
        }
        return "loaded";
    }

    std::string exportError(const Project& project) const {
        try {
            exportPackage(project, m_file);
        } catch (const FileError& error) {
            return error.what();
        }
        return "exported";
    }

    /// The reader that shares no code with the program, on the package and the project it was made from.
    void expectReadIndependently(const Project& project) const {
        exportPackage(project, m_file);
        const std::filesystem::path saved = m_folder / "organ.esm", expected = m_folder / "tissue.json";
        saveProject(project, saved);
        const TissueModel tissue = evaluateModel(project);
        Json json{{"mass", tissue.mass},
                  {"spring_constant", tissue.springConstant},
                  {"viscosity", tissue.viscosity},
                  {"tethers", Json::array()},
                  {"fixed", tissue.fixedNodes}};
        for (const Tether& tether : tissue.tethers)
            json["tethers"].push_back({tether.node, tether.springConstant, tether.viscosity});
        writeFileAtomically(expected, json.dump());
        const std::string command = std::string("python3 '") + ESM_SOURCE_DIR +
                                    "/tests/cli/read_package.py' '" + m_file.string() + "' --project '" +
                                    saved.string() + "' --tissue '" + expected.string() + "'";
        EXPECT_EQ(std::system(command.c_str()), 0) << command;
    }

    TemporaryFolder m_folder;
    std::filesystem::path m_file = m_folder / "organ.glb";
};

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

TEST_F(ModelPackageFile, KeepsRegionsAsTheyWerePutIn) {
    const Project project = richProject();
    const ModelPackage package = exported(project);
    expectSameRegions(package.regions, project.regions);
}

TEST_F(ModelPackageFile, HoldsTheBakedTextureAndItsPlaces) {
    const Project project = richProject();
    const ModelPackage package = exported(project);
    const std::vector<Image> pages =
        composite(*project.mesh, *project.atlas, project.photos, project.texture.baseColour);
    ASSERT_EQ(package.textures.size(), 1U);
    EXPECT_EQ(package.textures[0].pixels, pages[0].pixels);
    ASSERT_TRUE(package.atlas);
    EXPECT_EQ(package.atlas->options.size, project.atlas->options.size);
    EXPECT_EQ(package.atlas->texelsPerMetre, project.atlas->texelsPerMetre);
    for (std::size_t i = 0; i < project.atlas->corners.size(); ++i)
        for (std::size_t corner = 0; corner < 3; ++corner)
            EXPECT_LT((package.atlas->corners[i][corner] - project.atlas->corners[i][corner]).norm(), 1e-4);
}

TEST_F(ModelPackageFile, PacksAnAtlasForPhotosThatHaveNone) {
    Project project = richProject();
    const ModelPackage packed = exported(project);
    project.atlas = nullptr;
    const ModelPackage package = exported(project);
    ASSERT_EQ(package.textures.size(), 1U);
    EXPECT_EQ(package.textures[0].pixels, packed.textures[0].pixels);
    project.photos.clear();
    EXPECT_TRUE(exported(project).textures.empty());
    EXPECT_EQ(exported(project).atlas, nullptr);
}

TEST_F(ModelPackageFile, IsReadByAStrangersReader) {
    Project project = richProject();
    expectReadIndependently(project);
    project.photos.clear();
    project.atlas = nullptr;
    project.regions.clear();
    project.scene = {};
    expectReadIndependently(project);
    expectReadIndependently(bareProject());
}

TEST_F(ModelPackageFile, IsReadByTheReaderOfTheSpecification) {
    exportPackage(richProject(), m_file);
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
}

TEST_F(ModelPackageFile, SpreadsTheTextureOverPages) {
    Project project = richProject(24);
    project.texture.atlas = {96, 3, 2};
    project.atlas = std::make_shared<Atlas>(packAtlas(*project.mesh, project.texture.atlas));
    expectReadIndependently(project);
    const ModelPackage package = exported(project);
    EXPECT_EQ(package.textures.size(), 3U);
    EXPECT_EQ(package.atlas->page, project.atlas->page);
    expectSameTissue(package.tissue, evaluateModel(project));
}

TEST_F(ModelPackageFile, DrawnVerticesMayOutnumberTheNodes) {
    Project project = richProject();
    project.atlas = nullptr;
    project.photos.clear();
    auto network = std::make_shared<SpringNetwork>(*project.network);
    // The last two vertices hang on node 0, as where the drawn surface is finer than the simulated one.
    network->vertexNodes[46] = network->vertexNodes[47] = 0;
    project.network = network;
    expectReadIndependently(project);
    EXPECT_EQ(exported(project).tissue.network->vertexNodes, network->vertexNodes);
}

TEST_F(ModelPackageFile, HoldsHowFewerNodesCarryTheSurface) {
    for (const Detail& detail : {Detail{Detail::Kind::Nodes, 20}, Detail{Detail::Kind::Rigid, 0}}) {
        Project project = boundProject(detail);
        expectReadIndependently(project);
        expectSameTissue(exported(project).tissue, evaluateModel(project));
        project.photos.clear();
        project.atlas = nullptr;
        expectReadIndependently(project);
        expectSameTissue(exported(project).tissue, evaluateModel(project));
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
}

TEST_F(ModelPackageFile, ABindingThatCannotCarryTheSurfaceIsRefused) {
    const auto refusal = [&](const char* key, const Json& value) {
        exportPackage(boundProject({Detail::Kind::Nodes, 20}), m_file);
        Glb glb = parseGlb(readFile(m_file));
        glb.json["extensions"]["ESM_spring_mass"]["binding"][key] = value;
        overwrite(m_file, writeGlb(glb));
        return loadingError();
    };
    const Json extension = [&] {
        exportPackage(boundProject({Detail::Kind::Nodes, 20}), m_file);
        return parseGlb(readFile(m_file)).json["extensions"]["ESM_spring_mass"];
    }();
    EXPECT_THAT(refusal("nodes", extension["surface"]["triangles"]), HasSubstr("binding.nodes"));
    EXPECT_THAT(refusal("shares", extension["surface"]["restPosition"]), HasSubstr("shares are not of one"));
    EXPECT_THAT(refusal("triangleCount", 7), HasSubstr("binding.triangles"));
    EXPECT_THAT(refusal("lineCount", 1), HasSubstr("binding.lines is missing"));
    EXPECT_THAT(refusal("lineCount", -1), HasSubstr("binding.lineCount"));
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
    EXPECT_THROW(exportPackage(project, m_file, [](double fraction) { return fraction < 0.7; }), Cancelled);
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

TEST_F(ModelPackageFile, AFileCutOffAnywhereIsRefused) {
    exportPackage(richProject(), m_file);
    const Bytes whole = readFile(m_file);
    for (std::size_t size = 0; size < whole.size(); size += size < 64 ? 1 : 101) {
        overwrite(m_file, Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)));
        ASSERT_THAT(loadingError(), HasSubstr("organ.glb: ")) << size;
    }
}

/// A GLB has no checksums: what loads must at least be a model that runs.
TEST_F(ModelPackageFile, AFlippedByteIsRefusedOrLeavesASoundModel) {
    exportPackage(richProject(), m_file);
    const Bytes whole = readFile(m_file);
    for (std::size_t place = 0; place < whole.size(); place += place < 12000 ? 11 : 97) {
        Bytes damaged = whole;
        damaged[place] = static_cast<std::uint8_t>(damaged[place] ^ (1U << (place % 8)));
        overwrite(m_file, damaged);
        try {
            const ModelPackage package = loadPackage(m_file);
            ASSERT_THAT(validate(package.tissue), testing::IsEmpty()) << "byte " << place;
        } catch (const FileError&) {
            continue;
        }
    }
}

struct Damage {
    const char* pointer; ///< from the extension, or from the root where it starts with "//"
    Json value;
    const char* named; ///< what the message must name
};

TEST_F(ModelPackageFile, AnyWrongValueIsRefusedByItsName) {
    exportPackage(richProject(), m_file);
    const Glb whole = parseGlb(readFile(m_file));
    const std::vector<Damage> cases{
        {"/version", 3,
         "was made by a newer version (3) of the program; this one reads up to 2; update the program"},
        {"/version", "one", "version"},
        {"/damping", "axial", "damping"},
        {"/nodes", nullptr, "nodes"},
        {"/nodes/count", 47, "should have 47 elements"},
        {"/nodes/count", 4000000000U, "count"},
        {"/nodes/restPosition", 999, "restPosition"},
        {"/nodes/restPosition", "first", "restPosition"},
        {"/nodes/mass", 0, "accessors"},
        {"/springs/nodes", 1, "accessors"},
        {"/springs/springConstant", 1, "accessors"},
        {"/tethers/count", -1, "count"},
        {"/fixedNodes/nodes", nullptr, "fixedNodes"},
        {"/surface/triangles", nullptr, "triangles"},
        {"/surface/vertexCount", 1, "surface"},
        {"/regions", 5, "regions"},
        {"/regions/0/fuzzySystem", 44, "fuzzySystem"},
        {"/regions/2/held/mass", -1, "region 3"},
        {"/texture/size", 64, "64 by 64"},
        {"/texture/gap", 1e30, "gap"},
        {"/drawn", Json::array(), "drawn"},
        {"/drawn/0/primitive", 3, "primitive"},
        {"/drawn/0/mesh", 3, "mesh"},
        {"/drawn/0/vertexNodes", nullptr, "vertexNodes"},
        {"//asset/version", "1.0", "asset"},
        {"//extensionsUsed", Json::array(), "extensionsUsed"},
        {"//extensionsRequired", {"ESM_spring_mass"}, "extensionsRequired"},
        {"//extensions", Json::object(), "no model package"},
        {"//accessors", nullptr, "accessors"},
        {"//accessors/0/count", 18446744073709551615U, "accessors"},
        {"//accessors/0/byteOffset", 18446744073709551612U, "byteOffset"},
        {"//accessors/0/byteOffset", 1, "accessors"},
        {"//accessors/0/type", "VEC2", "VEC3"},
        {"//accessors/0/componentType", 5125, "componentType"},
        {"//accessors/0/sparse", Json::object(), "sparse"},
        {"//bufferViews/0/byteLength", 1U << 31, "byteLength"},
        {"//bufferViews/0/byteOffset", 18446744073709551615U, "byteOffset"},
        {"//bufferViews/0/byteStride", 16, "byteStride"},
        {"//bufferViews/0/buffer", 1, "buffer"},
        {"//materials/0/pbrMetallicRoughness/baseColorTexture/index", 4, "textures"},
        {"//textures/0/source", nullptr, "source"},
        {"//images/0/bufferView", 0, "images"},
        {"//meshes/0/primitives/0/attributes/TEXCOORD_0", 0, "accessors"},
    };
    for (const Damage& damage : cases) {
        Glb glb = whole;
        const std::string pointer = damage.pointer;
        Json& target = pointer[1] == '/' ? glb.json : glb.json["extensions"]["ESM_spring_mass"];
        target[Json::json_pointer(pointer[1] == '/' ? pointer.substr(1) : pointer)] = damage.value;
        overwrite(m_file, writeGlb(glb));
        const std::string message = loadingError();
        EXPECT_THAT(message, testing::AllOf(HasSubstr("organ.glb: "), HasSubstr(damage.named)))
            << damage.pointer << " = " << damage.value;
        EXPECT_EQ(message.find('\n'), std::string::npos);
    }
}

/// One picture for many pages would be decoded for each.
TEST_F(ModelPackageFile, PagesHaveAPictureEach) {
    Project project = richProject(24);
    project.texture.atlas = {96, 3, 2};
    project.atlas = std::make_shared<Atlas>(packAtlas(*project.mesh, project.texture.atlas));
    exportPackage(project, m_file);
    Glb glb = parseGlb(readFile(m_file));
    glb.json["textures"][2]["source"] = 1;
    overwrite(m_file, writeGlb(glb));
    EXPECT_THAT(loadingError(), HasSubstr("images/1 is the picture of two pages"));
}

TEST_F(ModelPackageFile, PagesThatDrawATriangleTwiceAreNotDecoded) {
    exportPackage(richProject(), m_file);
    Glb glb = parseGlb(readFile(m_file));
    Json& drawn = glb.json["extensions"]["ESM_spring_mass"]["drawn"];
    drawn.push_back(drawn[0]);
    glb.json["images"][0]["bufferView"] = 0; // no picture
    overwrite(m_file, writeGlb(glb));
    EXPECT_THAT(validatePackage(m_file),
                testing::ElementsAre(HasSubstr("every triangle of the surface once")));
}

TEST_F(ModelPackageFile, ValidationFindsAllProblemsAtOnce) {
    exportPackage(richProject(), m_file);
    Glb glb = parseGlb(readFile(m_file));
    Json& extension = glb.json["extensions"]["ESM_spring_mass"];
    extension["damping"] = "none";
    extension["springs"]["restLength"] = 9999;
    extension["base"]["mass"] = "heavy";
    overwrite(m_file, writeGlb(glb));
    const std::string problems = testing::PrintToString(validatePackage(m_file));
    for (const char* named : {"damping", "restLength", "mass"})
        EXPECT_THAT(problems, HasSubstr(named));
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

TEST_F(ModelPackageFile, WhatIsNoPackageIsRefused) {
    EXPECT_THAT(loadingError(), HasSubstr("does not exist"));
    overwrite(m_file, std::string());
    EXPECT_THAT(loadingError(), HasSubstr("is empty"));
    overwrite(m_file, std::string("PK and more than twelve bytes"));
    EXPECT_THAT(loadingError(), HasSubstr("is not a binary glTF file"));
    overwrite(m_file, writeGlb({Json{{"asset", {{"version", "2.0"}}}}, {0, 0, 0, 0}}));
    EXPECT_THAT(loadingError(), HasSubstr("no model package"));
}

} // namespace
} // namespace esm
