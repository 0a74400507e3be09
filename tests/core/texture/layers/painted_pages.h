#pragma once

#include "core/texture/layers/composite.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>

/// Photos and pages whose colours tests know.
namespace esm::test {

using Colour = std::array<std::uint8_t, 4>;

inline constexpr std::array<std::uint8_t, 3> baseColour{200, 101, 50};

inline constexpr Colour base{200, 101, 50, 255}, green{0, 255, 0, 255};

inline std::shared_ptr<const Photo> makePhoto(int width, int height,
                                              const std::function<Colour(int x, int y)>& colour) {
    auto photo = std::make_shared<Photo>();
    photo->image.width = width;
    photo->image.height = height;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const std::uint8_t channel : colour(x, y))
                photo->image.pixels.push_back(channel);
    return photo;
}

inline std::shared_ptr<const Photo> plainPhoto(const Colour& colour) {
    return makePhoto(8, 8, [&](int, int) { return colour; });
}

/// 8 × 8 squares of 32 pixels, black and white, the first one red.
inline std::shared_ptr<const Photo> checkerboard() {
    return makePhoto(256, 256, [](int x, int y) {
        if (x < 32 && y < 32) return Colour{255, 0, 0, 255};
        return (x / 32 + y / 32) % 2 == 0 ? Colour{255, 255, 255, 255} : Colour{0, 0, 0, 255};
    });
}

/// What the checkerboard shows at a place counted in its squares from its top left corner, and the base
/// colour around it.
inline Colour colourOfSquare(double column, double row) {
    if (!(column > 0 && column < 8 && row > 0 && row < 8)) return base;
    if (column < 1 && row < 1) return {255, 0, 0, 255};
    return (int(column) + int(row)) % 2 == 0 ? Colour{255, 255, 255, 255} : Colour{0, 0, 0, 255};
}

/// How many squares a place lies from a line between them.
inline double fromLine(double column, double row) {
    return std::min(std::abs(column - std::round(column)), std::abs(row - std::round(row)));
}

/// Projected from z = 1 m straight down onto the origin.
inline TextureLayer layerFromAbove(std::shared_ptr<const Photo> photo, double width) {
    TextureLayer layer;
    layer.photo = std::move(photo);
    layer.projector.pose.translation().z() = 1;
    layer.projector.width = layer.projector.height = width;
    layer.blendPixels = 0;
    return layer;
}

inline Colour pixelAt(const Image& page, int x, int y) {
    const std::uint8_t* pixel = page.at(x, y);
    return {pixel[0], pixel[1], pixel[2], pixel[3]};
}

/// Calls `visit(surface point, colour, triangle)` for every texel whose centre lies inside a patch, and fails
/// where there are too few to tell anything.
inline void
forEachTexelInside(const TriangleMesh& mesh, const Atlas& atlas, const std::vector<Image>& pages,
                   const std::function<void(const Eigen::Vector3d&, const Colour&, std::size_t)>& visit) {
    std::size_t visited = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& patch = atlas.corners[i];
        Eigen::AlignedBox2d box;
        for (const Eigen::Vector2d& corner : patch)
            box.extend(corner);
        Eigen::Matrix2d sides;
        sides << patch[1] - patch[0], patch[2] - patch[0];
        for (int y = int(box.min().y()); y <= int(box.max().y()); ++y) {
            for (int x = int(box.min().x()); x <= int(box.max().x()); ++x) {
                const Eigen::Vector2d w = sides.inverse() * (Eigen::Vector2d(x + 0.5, y + 0.5) - patch[0]);
                if (w.minCoeff() < 0 || w.sum() > 1) continue;
                ++visited;
                const Triangle& t = mesh.triangles[i];
                visit((1 - w.sum()) * mesh.vertices[t[0]] + w.x() * mesh.vertices[t[1]] +
                          w.y() * mesh.vertices[t[2]],
                      pixelAt(pages[atlas.page[i]], x, y), i);
            }
        }
    }
    EXPECT_GT(visited, 2000U);
}

/// Visits every texel's surface point and colour after composing.
template<class Visit>
void onPages(const TriangleMesh& mesh, const Atlas& atlas, const std::vector<TextureLayer>& layers,
             Visit visit) {
    forEachTexelInside(mesh, atlas, composite(mesh, atlas, layers, baseColour), visit);
}

inline bool isNear(const Colour& colour, const Colour& expected, int tolerance) {
    for (std::size_t i = 0; i < 3; ++i)
        if (std::abs(int(colour[i]) - int(expected[i])) > tolerance) return false;
    return true;
}

} // namespace esm::test
