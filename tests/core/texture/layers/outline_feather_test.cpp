#include "core/texture/layers/composite.h"
#include "core/texture/layers/patch_scan.h"
#include "tests/core/texture/layers/painted_pages.h"
#include "tests/support/test_surfaces.h"

#include <gtest/gtest.h>

using namespace esm;
using namespace esm::test;

namespace {

/// A sheet that lies in the plane z = 0 and is folded over itself along y: its profile overhangs like a wave
/// that is about to break. Finer and coarser triangles beside each other.
TriangleMesh foldedSheet(int columns, int rows) {
    TriangleMesh mesh;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column) {
            const double s = 2.0 * column / columns - 1, y = 0.2 * (row / double(rows) - 0.5);
            const double wave = std::exp(-8 * s * s);
            mesh.vertices.emplace_back(0.1 * s + 0.08 * (1 + 0.5 * std::sin(20 * y)) * wave, y - 0.02 * wave,
                                       0.05 * wave);
        }
    const auto index = [&](int row, int column) { return std::uint32_t(row * (columns + 1) + column); };
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            mesh.triangles.push_back(
                {index(row, column), index(row, column + 1), index(row + 1, column + 1)});
            mesh.triangles.push_back(
                {index(row, column), index(row + 1, column + 1), index(row + 1, column)});
        }
    return mesh;
}

int difference(const Colour& a, const Colour& b) {
    int largest = 0;
    for (std::size_t channel = 0; channel < 3; ++channel)
        largest = std::max(largest, std::abs(int(a[channel]) - int(b[channel])));
    return largest;
}

/// The largest difference of a channel between texels side by side within a patch of the first page.
int largestStepWithin(const Atlas& atlas, const Image& page) {
    const PageStrip whole{0, 0, page.height, {}};
    std::vector<std::size_t> owners(std::size_t(page.width) * std::size_t(page.height), atlas.corners.size());
    const auto ownerAt = [&](int x, int y) -> std::size_t& {
        return owners[std::size_t(y) * std::size_t(page.width) + std::size_t(x)];
    };
    int largest = 0;
    for (std::size_t i = 0; i < atlas.corners.size(); ++i)
        PatchScan(atlas.corners[i]).forEachPlace(whole, page.width, 0, [&](int x, int y) {
            ownerAt(x, y) = i;
            for (const auto& [left, up] : {std::pair{x - 1, y}, std::pair{x, y - 1}}) {
                if (left >= 0 && up >= 0 && ownerAt(left, up) == i)
                    largest = std::max(largest, difference(pixelAt(page, x, y), pixelAt(page, left, up)));
            }
        });
    return largest;
}

/// A photo without detail, from an angle to the z-axis.
TextureLayer layerAt(ProjectorKind kind, double degrees) {
    TextureLayer layer = layerFromAbove(
        makePhoto(400, 400,
                  [](int x, int y) {
                      return Colour{std::uint8_t(80 + x / 8), std::uint8_t(60 + y / 8), 90, 255};
                  }),
        0.3);
    layer.projector.kind = kind;
    layer.projector.pose =
        Eigen::AngleAxisd(degrees * M_PI / 180, Eigen::Vector3d::UnitY()) * Eigen::Translation3d(0, 0, 0.35);
    return layer;
}

/// What photos make of a surface from angles up to nearly along it.
void expectSoftEdges(const TriangleMesh& mesh) {
    const Atlas atlas = packAtlas(mesh, {1024, 1, 4, AtlasLayout::UnfoldedGroups});
    int hardest = 0;
    for (const ProjectorKind kind : {ProjectorKind::Parallel, ProjectorKind::Perspective})
        for (const double degrees : {0.0, 40.0, 60.0, 80.0}) {
            TextureLayer layer = layerAt(kind, degrees);
            layer.blendPixels = 32;
            const std::vector<Image> pages = composite(mesh, atlas, {layer}, baseColour);
            EXPECT_LE(largestStepWithin(atlas, pages[0]), 8) << degrees;
            EXPECT_LE(seamError(mesh, atlas, pages), 8) << degrees;
            EXPECT_GT(coverage(mesh, atlas, layer).texels, 100000U);
            layer.blendPixels = 0;
            hardest =
                std::max(hardest, largestStepWithin(atlas, composite(mesh, atlas, {layer}, baseColour)[0]));
        }
    EXPECT_GT(hardest, 80) << "without a border there is a step";
}

} // namespace

TEST(OutlineFeather, LeaveNoStepPastAFold) {
    expectSoftEdges(foldedSheet(60, 30));
}

TEST(OutlineFeather, LeaveNoStepPastAFoldOfLargeTriangles) {
    expectSoftEdges(foldedSheet(24, 12));
}

TEST(OutlineFeather, LeaveNoStepAllAroundABody) {
    expectSoftEdges(lumpySurface(40, 60));
}

/// The brush is wide beside the triangles and is led around a bend of the surface.
TEST(OutlineFeather, LeaveNoStepInAStrokeOverLargeTriangles) {
    const TriangleMesh mesh = lumpySurface(12, 16);
    const std::vector<Eigen::Vector3d> normals = vertexNormals(mesh.vertices, mesh.triangles);
    TextureLayer layer;
    BrushStroke stroke;
    stroke.kind = BrushKind::Colour;
    stroke.colour = {80, 60, 90};
    stroke.radius = 0.06;
    for (const std::size_t vertex : {70U, 71U, 72U, 74U})
        stroke.path.push_back({mesh.vertices[vertex], normals[vertex]});
    layer.strokes.push_back(std::make_shared<const BrushStroke>(stroke));
    const Atlas atlas = packAtlas(mesh, {1024, 1, 4, AtlasLayout::UnfoldedGroups});
    const std::vector<Image> pages = composite(mesh, atlas, {layer}, baseColour);
    EXPECT_LE(largestStepWithin(atlas, pages[0]), 8);
    EXPECT_LE(seamError(mesh, atlas, pages), 8);
    EXPECT_GT(coverage(mesh, atlas, layer).texels, 50000U);
}
