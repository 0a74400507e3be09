#include "tests/core/exchange/model_package_fixture.h"

#include "core/exchange/package/glb.h"
#include "core/texture/layers/composite.h"
#include "core/texture/maps/finish_pages.h"
#include "tests/core/exchange/overwrite.h"
#include "tests/core/exchange/rounded_tissue.h"
#include "tests/core/exchange/strangers_reader.h"
#include "tests/support/exchange_projects.h"
#include "tests/support/same_project.h"

namespace esm {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

TEST_F(ModelPackageFile, HoldsTheBakedTextureAndItsPlaces) {
    const Project project = richProject();
    const ModelPackage package = exported(project);
    const std::vector<Image> pages =
        composite(*project.mesh, *project.atlas, project.layers, project.texture.baseColour);
    ASSERT_EQ(package.textures.size(), 1U);
    EXPECT_EQ(package.textures[0].pixels, pages[0].pixels);
    ASSERT_TRUE(package.atlas);
    EXPECT_EQ(package.atlas->options.size, project.atlas->options.size);
    EXPECT_EQ(package.atlas->texelsPerMetre, project.atlas->texelsPerMetre);
    for (std::size_t i = 0; i < project.atlas->corners.size(); ++i)
        for (std::size_t corner = 0; corner < 3; ++corner)
            EXPECT_LT((package.atlas->corners[i][corner] - project.atlas->corners[i][corner]).norm(), 1e-4);
}

TEST_F(ModelPackageFile, HoldsHowTheSurfaceShines) {
    const Project project = shiningProject();
    const ModelPackage package = exported(project);
    const auto pages = finishPages(*project.mesh, *project.atlas, project.layers, project.texture.finish);
    ASSERT_TRUE(package.finishPages);
    EXPECT_EQ(package.finishPages->front().image().pixels, pages->front().image().pixels);
    EXPECT_FALSE(package.finish); // pages say it
    Project plain = project;
    plain.layers.clear();
    EXPECT_EQ(exported(plain).finish, project.texture.finish);
    plain.texture.finish.reset();
    EXPECT_FALSE(exported(plain).finish);
}

TEST_F(ModelPackageFile, HoldsHowTheSurfaceShinesInTheMeshsOwnLayout) {
    const Project own = ownLayoutProject();
    Project project = shiningProject();
    project.mesh = own.mesh;
    project.atlas = own.atlas;
    project.texture.atlas = own.texture.atlas;
    expectReadIndependently(project, m_folder.path());
    const ModelPackage package = exported(project);
    const auto pages = finishPages(*project.mesh, *project.atlas, project.layers, project.texture.finish);
    ASSERT_TRUE(package.finishPages);
    EXPECT_EQ(package.finishPages->front().image().pixels, pages->front().image().pixels);
    const Json gltf = parseGlb(readFile(m_file)).json;
    const Json& attributes = gltf["meshes"][0]["primitives"][0]["attributes"];
    const auto countOf = [&](const char* name) {
        return gltf["accessors"][attributes[name].get<std::size_t>()]["count"];
    };
    EXPECT_EQ(countOf("TANGENT"), countOf("POSITION"));
}

// The last row of squares lies upside down in the texture, on itself: of the line beside it its ends and
// its middle keep their places, where tangents on one side are mirrored.
TEST_F(ModelPackageFile, DrawsAVertexTwiceWhereTheTextureIsMirroredOnOneSide) {
    const Project own = ownLayoutProject();
    Project project = shiningProject();
    auto mesh = std::make_shared<TriangleMesh>(*own.mesh);
    for (std::size_t i = mesh->triangles.size() - 12; i < mesh->triangles.size(); ++i)
        for (Eigen::Vector2d& place : mesh->textureCoordinates[i])
            place.y() = 1 - place.y();
    project.mesh = mesh;
    project.texture.atlas = own.texture.atlas;
    project.atlas = std::make_shared<Atlas>(packAtlas(*mesh, project.texture.atlas));
    expectReadIndependently(project, m_folder.path());
    const auto drawnVertices = [&](const Project& exportedProject) {
        exported(exportedProject);
        const Json gltf = parseGlb(readFile(m_file)).json;
        const Json& positions = gltf["meshes"][0]["primitives"][0]["attributes"]["POSITION"];
        return gltf["accessors"][positions.get<std::size_t>()]["count"].get<int>();
    };
    const int withNormals = drawnVertices(project);
    for (TextureLayer& layer : project.layers)
        layer.finish.reset();
    EXPECT_GT(withNormals, drawnVertices(project));
}

TEST_F(ModelPackageFile, HoldsOcclusionWhereAsked) {
    Project project = richProject();
    project.texture.occlusionReach = 0.01;
    expectReadIndependently(project, m_folder.path());
    exported(project);
    const Glb glb = parseGlb(readFile(m_file));
    const Json& place = glb.json["materials"][0]["occlusionTexture"]["index"];
    ASSERT_TRUE(place.is_number());
    EXPECT_NE(place, glb.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"]);
    project.layers.clear();
    project.atlas = nullptr;
    exported(project);
    EXPECT_TRUE(parseGlb(readFile(m_file)).json["materials"][0].contains("occlusionTexture"))
        << "a surface without photos is laid out for it";
    project.texture.occlusionReach = 0;
    exported(project);
    EXPECT_FALSE(parseGlb(readFile(m_file)).json["materials"][0].contains("occlusionTexture"));
}

TEST_F(ModelPackageFile, HoldsItsPagesAsJpegWhereAsked) {
    const Project project = richProject();
    const ModelPackage exact = exported(project);
    HandoverMeans means;
    means.drawPreview = [](const Project&, const auto&) { return Image{1, 1, {1, 2, 3, 255}}; };
    means.pictures = {PictureFormat::Jpeg, 95};
    exportPackage(project, m_file, means);
    EXPECT_THAT(validatePackage(m_file), testing::IsEmpty());
    const ModelPackage package = loadPackage(m_file);
    ASSERT_EQ(package.textures.size(), exact.textures.size());
    double difference = 0;
    for (std::size_t i = 0; i < exact.textures[0].pixels.size(); ++i)
        difference += std::abs(exact.textures[0].pixels[i] - package.textures[0].pixels[i]);
    EXPECT_LT(difference / static_cast<double>(exact.textures[0].pixels.size()), 4);
    const Json images = parseGlb(readFile(m_file)).json["images"];
    EXPECT_EQ(images[0]["mimeType"], "image/jpeg");
    EXPECT_EQ(images[0]["name"], "page 1");
    EXPECT_EQ(images[1]["name"], "preview");
    EXPECT_EQ(images[1]["mimeType"], "image/png") << "the preview";
    means.drawPreview = {};
    expectReadIndependently(project, m_folder.path(), means);
    means.pictures.quality = 0;
    EXPECT_THROW(exportPackage(project, m_file, means), FileError);
}

TEST_F(ModelPackageFile, PacksAnAtlasForPhotosThatHaveNone) {
    Project project = richProject();
    const ModelPackage packed = exported(project);
    project.atlas = nullptr;
    const ModelPackage package = exported(project);
    ASSERT_EQ(package.textures.size(), 1U);
    EXPECT_EQ(package.textures[0].pixels, packed.textures[0].pixels);
    project.layers.clear();
    EXPECT_TRUE(exported(project).textures.empty());
    EXPECT_EQ(exported(project).atlas, nullptr);
}

TEST_F(ModelPackageFile, KeepsTheMeshsOwnLayoutAndItsSharedVertices) {
    const Project project = ownLayoutProject();
    expectReadIndependently(project, m_folder.path());
    const ModelPackage package = exported(project);
    EXPECT_EQ(package.atlas->options.layout, AtlasLayout::Own);
    const Json gltf = parseGlb(readFile(m_file)).json;
    EXPECT_EQ(gltf["extensions"]["ESM_spring_mass"]["version"], 7);
    EXPECT_EQ(gltf["extensions"]["ESM_spring_mass"]["texture"]["layout"], "own");
    const Json& positions = gltf["meshes"][0]["primitives"][0]["attributes"]["POSITION"];
    EXPECT_EQ(gltf["accessors"][positions.get<std::size_t>()]["count"], 63)
        << "15 more than the surface's, where it was cut";
    for (std::size_t i = 0; i < project.atlas->corners.size(); ++i)
        for (std::size_t corner = 0; corner < 3; ++corner)
            EXPECT_LT((package.atlas->corners[i][corner] - project.atlas->corners[i][corner]).norm(), 1e-4);
}

TEST_F(ModelPackageFile, KeepsChartsAndTheirSharedVertices) {
    Project project = richProject(24);
    project.texture.atlas = {256, 1, 2, AtlasLayout::Charts};
    project.atlas = std::make_shared<Atlas>(packAtlas(*project.mesh, project.texture.atlas));
    expectReadIndependently(project, m_folder.path());
    const ModelPackage package = exported(project);
    EXPECT_EQ(package.atlas->options.layout, AtlasLayout::Charts);
    const Json gltf = parseGlb(readFile(m_file)).json;
    EXPECT_EQ(gltf["extensions"]["ESM_spring_mass"]["version"], 7);
    EXPECT_EQ(gltf["extensions"]["ESM_spring_mass"]["texture"]["layout"], "charts");
    EXPECT_EQ(gltf["samplers"][0]["minFilter"], 9729) << "linear, without mip-maps";
    const Json& positions = gltf["meshes"][0]["primitives"][0]["attributes"]["POSITION"];
    const auto drawn = gltf["accessors"][positions.get<std::size_t>()]["count"].get<std::size_t>();
    EXPECT_GT(drawn, project.mesh->vertices.size()) << "at least twice at seams";
    EXPECT_LT(drawn, 2 * project.mesh->triangles.size()) << "of three corners each";
    for (std::size_t i = 0; i < project.atlas->corners.size(); ++i)
        for (std::size_t corner = 0; corner < 3; ++corner)
            EXPECT_LT((package.atlas->corners[i][corner] - project.atlas->corners[i][corner]).norm(), 1e-4);
}

TEST_F(ModelPackageFile, AnUnknownLayoutOrTooLowAVersionForItsOwnIsNamed) {
    exportPackage(ownLayoutProject(), m_file);
    Glb glb = parseGlb(readFile(m_file));
    Json& extension = glb.json["extensions"]["ESM_spring_mass"];
    extension["version"] = 6;
    rewrite(glb);
    EXPECT_THAT(loadingError(), HasSubstr("version should be 7"));
    extension["version"] = 7;
    extension["texture"]["layout"] = "spiral";
    rewrite(glb);
    EXPECT_THAT(loadingError(), HasSubstr("texture.layout should be"));
}

TEST_F(ModelPackageFile, SpreadsTheTextureOverPages) {
    Project project = richProject(24);
    project.texture.atlas = {96, 3, 2};
    project.atlas = std::make_shared<Atlas>(packAtlas(*project.mesh, project.texture.atlas));
    expectReadIndependently(project, m_folder.path());
    const ModelPackage package = exported(project);
    EXPECT_EQ(package.textures.size(), 3U);
    EXPECT_EQ(package.atlas->page, project.atlas->page);
    expectSameTissue(package.tissue, evaluateModel(project));
}

} // namespace
} // namespace esm
