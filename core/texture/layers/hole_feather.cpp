#include "core/texture/layers/hole_feather.h"

#include "core/texture/parallel_steps.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace esm {

namespace {

bool hasHoles(const Image& photo) {
    for (std::size_t i = 3; i < photo.pixels.size(); i += 4)
        if (photo.pixels[i] == 0) return true;
    return false;
}

/// 0 where the photo is wholly transparent, else 255.
cv::Mat shownRows(const Image& photo, int from, int to) {
    cv::Mat shown(to - from, photo.width, CV_8U);
    for (int y = from; y < to; ++y) {
        std::uint8_t* row = shown.ptr<std::uint8_t>(y - from);
        for (int x = 0; x < photo.width; ++x)
            row[x] = photo.at(x, y)[3] > 0 ? 255 : 0;
    }
    return shown;
}

/// Nodes of one row, from distances (pixels) between the middles of pixels and of holes.
void fadeRow(PhotoFade& feather, int row, const float* distances, int width, double blendPixels) {
    constexpr float halfAPixel = 0.5F; // from a hole's middle to its side
    float* nodes = &feather.faded[static_cast<std::size_t>(row) * static_cast<std::size_t>(feather.columns)];
    for (int column = 0; column < feather.columns; ++column) {
        const int x = std::min(static_cast<int>(column * feather.spacing), width - 1);
        const float left = (distances[x] - halfAPixel) / static_cast<float>(blendPixels);
        nodes[column] = 1 - std::clamp(left, 0.0F, 1.0F);
    }
}

} // namespace

/// Distances to the nearest hole (Felzenszwalb and Huttenlocher 2012, exact), strip by strip with what lies
/// around within reach, so that a photo of any size takes little memory.
PhotoFade holeFeather(const Image& photo, double blendPixels, const Progress& progress) {
    if (!(blendPixels > 0) || !hasHoles(photo)) return {};
    PhotoFade feather = unfaded({photo.width, photo.height}, blendPixels);
    const int reach = static_cast<int>(std::min(std::ceil(blendPixels) + 1, double(photo.height)));
    const auto rowsPerStrip =
        std::max<std::size_t>(64, static_cast<std::size_t>(2 * reach / feather.spacing));
    const auto rows = static_cast<std::size_t>(feather.rows);
    forEachInParallel((rows + rowsPerStrip - 1) / rowsPerStrip, progress, [&](std::size_t strip) {
        const auto pixelOf = [&](std::size_t row) {
            return std::min(static_cast<int>(static_cast<double>(row) * feather.spacing), photo.height - 1);
        };
        const std::size_t first = strip * rowsPerStrip, end = std::min(first + rowsPerStrip, rows);
        const int from = std::max(0, pixelOf(first) - reach);
        const int to = std::min(photo.height, pixelOf(end - 1) + reach + 1);
        cv::Mat distances;
        cv::distanceTransform(shownRows(photo, from, to), distances, cv::DIST_L2, cv::DIST_MASK_PRECISE);
        for (std::size_t row = first; row < end; ++row)
            fadeRow(feather, static_cast<int>(row), distances.ptr<float>(pixelOf(row) - from), photo.width,
                    blendPixels);
    });
    return feather;
}

} // namespace esm
