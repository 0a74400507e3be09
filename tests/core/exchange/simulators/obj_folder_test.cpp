#include "core/exchange/simulators/obj_folder.h"

#include "core/exchange/simulators/exporters.h"
#include "core/support/errors.h"
#include "tests/support/exchange_projects.h"
#include "tests/support/temporary_folder.h"

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <gmock/gmock.h>

#include <fstream>
#include <set>
#include <sstream>

namespace esm {
namespace {

/// A table as a script would read it: the fields of each line, none of which holds a comma.
struct CsvTable {
    std::vector<std::string> headings;
    std::vector<std::vector<double>> rows;

    explicit CsvTable(const std::filesystem::path& file) {
        std::ifstream stream(file);
        std::string line, field;
        std::getline(stream, line);
        for (std::istringstream fields(line); std::getline(fields, field, ',');)
            headings.push_back(field);
        while (std::getline(stream, line)) {
            rows.emplace_back();
            for (std::istringstream fields(line); std::getline(fields, field, ',');)
                rows.back().push_back(std::stod(field));
        }
    }
};

class ObjFolder : public testing::Test {
protected:
    void exportTo(const Project& project, const std::filesystem::path& folder) const {
        exportProject(project, exporterFor(folder), folder);
    }
    std::set<std::string> names() const {
        std::set<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(m_target))
            names.insert(entry.path().filename().string());
        return names;
    }

    TemporaryFolder m_folder;
    std::filesystem::path m_target = m_folder / "organ.tables";
};

TEST_F(ObjFolder, TablesReadBackToTheLastBit) {
    const Project project = richProject();
    const TissueModel tissue = evaluateModel(project);
    exportTo(project, m_target);
    const CsvTable springs(m_target / "springs.csv"), nodes(m_target / "nodes.csv");
    EXPECT_THAT(springs.headings, testing::ElementsAre("node_1", "node_2", "rest_length_m",
                                                       "spring_constant_n_per_m", "viscosity_ns_per_m"));
    ASSERT_EQ(springs.rows.size(), tissue.network->springs.size());
    for (std::size_t i = 0; i < springs.rows.size(); ++i) {
        const Spring& spring = tissue.network->springs[i];
        const SpringValues values = valuesOf(tissue, i);
        EXPECT_THAT(springs.rows[i], testing::ElementsAre(spring.first, spring.second, spring.restLength,
                                                          values.springConstant, values.viscosity));
    }
    EXPECT_THAT(nodes.headings,
                testing::ElementsAre("x_m", "y_m", "z_m", "mass_kg", "spring_constant_n_per_m",
                                     "viscosity_ns_per_m", "fixed", "region"));
    ASSERT_EQ(nodes.rows.size(), tissue.mass.size());
    for (std::size_t i = 0; i < nodes.rows.size(); ++i) {
        EXPECT_EQ(nodes.rows[i][1], tissue.network->restPositions[i].y());
        EXPECT_EQ(nodes.rows[i][3], tissue.mass[i]);
    }
}

TEST_F(ObjFolder, ItsSurfaceAndItsPictureAreReadByAssimp) {
    const Project project = paintedProject();
    exportTo(project, m_target);
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile((m_target / "surface.obj").string(), aiProcess_Triangulate);
    ASSERT_NE(scene, nullptr) << importer.GetErrorString();
    std::size_t triangles = 0;
    for (unsigned mesh = 0; mesh < scene->mNumMeshes; ++mesh) {
        triangles += scene->mMeshes[mesh]->mNumFaces;
        EXPECT_TRUE(scene->mMeshes[mesh]->HasTextureCoords(0));
        aiString picture;
        const aiMaterial* material = scene->mMaterials[scene->mMeshes[mesh]->mMaterialIndex];
        ASSERT_EQ(material->GetTexture(aiTextureType_DIFFUSE, 0, &picture), aiReturn_SUCCESS);
        EXPECT_TRUE(std::filesystem::is_regular_file(m_target / picture.C_Str())) << picture.C_Str();
    }
    EXPECT_EQ(triangles, project.mesh->triangles.size());
}

TEST_F(ObjFolder, HasNoPictureWithoutTexture) {
    exportTo(sheetProject(), m_target);
    EXPECT_THAT(names(),
                testing::UnorderedElementsAre("surface.obj", "surface.mtl", "model.csv", "nodes.csv",
                                              "regions.csv", "springs.csv", "tethers.csv", "vertices.csv"));
}

TEST_F(ObjFolder, DrawsSpringsOrNodesWithoutASurface) {
    Project project = bareProject();
    exportTo(project, m_target);
    EXPECT_THAT(names(),
                testing::UnorderedElementsAre("network.obj", "model.csv", "nodes.csv", "springs.csv"));
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile((m_target / "network.obj").string(), 0);
    ASSERT_NE(scene, nullptr) << importer.GetErrorString();
    ASSERT_EQ(scene->mNumMeshes, 1U);
    EXPECT_EQ(scene->mMeshes[0]->mNumFaces, project.network->springs.size());
    EXPECT_EQ(scene->mMeshes[0]->mPrimitiveTypes, static_cast<unsigned>(aiPrimitiveType_LINE));
}

TEST_F(ObjFolder, LeavesAFolderThatHoldsSomethingAlone) {
    std::filesystem::create_directory(m_target);
    std::ofstream(m_target / "notes.txt") << "mine";
    EXPECT_THROW(exportTo(bareProject(), m_target), FileError);
    EXPECT_THAT(names(), testing::ElementsAre("notes.txt"));
}

} // namespace
} // namespace esm
