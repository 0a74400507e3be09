#include "core/texture/maps/finish_pages.h"
#include "tests/core/texture/layers/painted_pages.h"
#include "tests/support/test_surfaces.h"

#include <Eigen/Dense>

using namespace esm;
using namespace esm::test;

namespace {

constexpr double waveWidth = 0.02, waveHeight = 0.001; // m
constexpr double squareWidth = 0.1;                    // m

/// Heights that rise and fall from left to right, as blue says them.
double waveAt(double x) {
    return waveHeight * std::sin(2 * M_PI * x / waveWidth);
}
double slopeOfWaveAt(double x) {
    return waveHeight * 2 * M_PI / waveWidth * std::cos(2 * M_PI * x / waveWidth);
}

FinishLayers waves() {
    constexpr int size = 512;
    TextureLayer layer =
        layerFromAbove(makePhoto(size, size,
                                 [](int x, int) {
                                     const double place = (x + 0.5) / size - 0.5;
                                     const double height = waveAt(2 * squareWidth * place);
                                     const double blue = 128 + 127 * height / waveHeight;
                                     return Colour{200, 90, std::uint8_t(std::lround(blue)), 255};
                                 }),
                       2 * squareWidth);
    return {{layer}, {0, 153, 128}, waveHeight};
}

Atlas packedAs(const TriangleMesh& mesh, AtlasLayout layout) {
    AtlasOptions options;
    options.size = 512;
    options.layout = layout;
    return packAtlas(mesh, options);
}

std::vector<Image> imagesOf(const TiledPages& pages) {
    std::vector<Image> images;
    for (const TiledImage& page : pages)
        images.push_back(page.image());
    return images;
}

/// What a normal map's x and y mean on the surface, from the three corners alone: tangent to the page's
/// right, bitangent at right angles to it, to the page's top.
Eigen::Vector3d normalOnSurface(const TriangleMesh& mesh, const Atlas& atlas, std::size_t triangle,
                                const Eigen::Vector2d& tilt) {
    Eigen::Matrix<double, 3, 2> sides;
    Eigen::Matrix2d texels;
    for (Eigen::Index i = 0; i < 2; ++i) {
        const auto corner = static_cast<std::size_t>(i + 1);
        sides.col(i) =
            mesh.vertices[mesh.triangles[triangle][corner]] - mesh.vertices[mesh.triangles[triangle][0]];
        texels.col(i) = atlas.corners[triangle][corner] - atlas.corners[triangle][0];
    }
    const Eigen::Matrix<double, 3, 2> perTexel = sides * texels.inverse();
    const Eigen::Vector3d tangent = perTexel.col(0).normalized();
    const Eigen::Vector3d up = (-perTexel.col(1) + tangent * tangent.dot(perTexel.col(1))).normalized();
    return tilt.x() * tangent + tilt.y() * up +
           std::sqrt(1 - tilt.squaredNorm()) * sides.col(0).cross(sides.col(1)).normalized();
}

/// The largest difference between a normal that was made of the waves and theirs.
double worstNormal(const TriangleMesh& mesh, const Atlas& atlas) {
    CompositionCache cache;
    const FinishComposition made = composedFinish(mesh, atlas, {}, waves(), cache);
    double worst = 0;
    forEachTexelInside(mesh, atlas, imagesOf(*made.pages),
                       [&](const Eigen::Vector3d& place, const Colour& finish, std::size_t triangle) {
                           EXPECT_EQ(finish[0], 200);
                           EXPECT_EQ(finish[1], 90);
                           const Eigen::Vector2d tilt((finish[2] - 128) / 127.0, (finish[3] - 128) / 127.0);
                           const double slope = slopeOfWaveAt(place.x());
                           const Eigen::Vector3d expected = Eigen::Vector3d(-slope, 0, 1).normalized();
                           worst = std::max(worst,
                                            (normalOnSurface(mesh, atlas, triangle, tilt) - expected).norm());
                       });
    return worst;
}

} // namespace

TEST(FinishPages, TiltNormalsAsTheSurfaceOfKnownHeightsIsTilted) {
    const TriangleMesh mesh = flatSquare(squareWidth, 4);
    for (const AtlasLayout layout : atlasLayouts) {
        const double worst = worstNormal(mesh, packedAs(mesh, layout));
        // Half a step of blue to either side is 1.6 % of slope; texels beside a patch's border see one
        // neighbour.
        EXPECT_LT(worst, 0.05) << wordOf(layout);
        EXPECT_GT(worst, 0);
    }
}

TEST(FinishPages, TiltNormalsAlikeWhereTheMeshsOwnLayoutIsStretchedAndMirrored) {
    TriangleMesh mesh = stretchedSheet(squareWidth, 4);
    EXPECT_LT(worstNormal(mesh, packedAs(mesh, AtlasLayout::Own)), 0.05);
    for (CornerCoordinates& places : mesh.textureCoordinates)
        for (Eigen::Vector2d& place : places)
            place.x() = 1 - place.x();
    EXPECT_LT(worstNormal(mesh, packedAs(mesh, AtlasLayout::Own)), 0.05);
}

TEST(FinishPages, OfFlatTissueAreUpright) {
    const TriangleMesh mesh = lumpySurface(12, 16);
    const Atlas atlas = packedAs(mesh, AtlasLayout::MatchedRows);
    TextureLayer layer = layerFromAbove(checkerboard(), 0.1);
    layer.finish = LayerFinish{{0.3, 1}, 0, 0, false};
    const auto pages = finishPages(mesh, atlas, {layer}, SurfaceFinish{0.6, 0});
    ASSERT_TRUE(pages);
    const MaterialPage material = materialPage(pages->front());
    EXPECT_TRUE(material.normals.empty());
    std::size_t wet = 0;
    for (std::size_t i = 0; i < material.wetnessAndRoughness.pixels.size(); i += 4) {
        const std::uint8_t* pixel = &material.wetnessAndRoughness.pixels[i];
        wet += pixel[0] == 255 ? 1 : 0;
        ASSERT_EQ(pixel[2], 0); // no metal
    }
    EXPECT_GT(wet, 1000U);
    EXPECT_LT(wet, material.wetnessAndRoughness.pixels.size() / 4);
}

TEST(FinishPages, MadeOfWhatChangedAreThoseMadeOfAll) {
    const TriangleMesh mesh = flatSquare(squareWidth, 4);
    const Atlas atlas = packedAs(mesh, AtlasLayout::UnfoldedGroups);
    CompositionCache cache;
    FinishLayers layers = waves();
    const FinishComposition before = composedFinish(mesh, atlas, {}, layers, cache);
    BrushStroke erased;
    erased.radius = 0.01;
    erased.path = {{{0.02, 0.01, 0}, Eigen::Vector3d::UnitZ()}};
    layers.layers[0].strokes = {std::make_shared<const BrushStroke>(erased)};
    const FinishComposition after = composedFinish(mesh, atlas, before, layers, cache);
    CompositionCache fresh;
    const FinishComposition whole = composedFinish(mesh, atlas, {}, layers, fresh);
    EXPECT_EQ(after.pages->front().image().pixels, whole.pages->front().image().pixels);
    EXPECT_NE(after.pages->front().image().pixels, before.pages->front().image().pixels);
}

TEST(FinishPages, ComeBackFromTheMaterialThatTheyMake) {
    const TriangleMesh mesh = flatSquare(squareWidth, 4);
    const Atlas atlas = packedAs(mesh, AtlasLayout::Rows);
    CompositionCache cache;
    const auto pages = composedFinish(mesh, atlas, {}, waves(), cache).pages;
    const MaterialPage material = materialPage(pages->front());
    ASSERT_FALSE(material.normals.empty());
    EXPECT_EQ(finishPage(material).image().pixels, pages->front().image().pixels);
}

TEST(FinishPages, AreNoneWhereNoLayerLendsAFinish) {
    const TriangleMesh mesh = flatSquare(squareWidth, 2);
    const Atlas atlas = packedAs(mesh, AtlasLayout::Rows);
    EXPECT_FALSE(finishPages(mesh, atlas, {layerFromAbove(checkerboard(), 0.1)}, SurfaceFinish{0.6, 1}));
}
