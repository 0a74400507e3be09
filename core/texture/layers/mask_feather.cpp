#include "core/texture/layers/mask_feather.h"

#include "core/support/parallel_steps.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace esm {

namespace {

bool isMasked(const Image& photo) {
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

/// The pixel below or right of a place between pixels.
int pixelAfter(double place, int pixels) {
    return static_cast<int>(std::min(place, pixels - 1.0));
}

/// Nodes of one row.
/// @param above, below pixels' distances (pixels) from their middles to those of what is masked, in the rows
/// between which the nodes lie
void fadeRow(PhotoFade& fade, int row, const float* above, const float* below, int width,
             double blendPixels) {
    constexpr float halfAPixel = 0.5F; // from a masked pixel's middle to its side
    float* nodes = &fade.faded[static_cast<std::size_t>(row) * static_cast<std::size_t>(fade.columns)];
    for (int column = 0; column < fade.columns; ++column) {
        const int right = pixelAfter(column * fade.spacing, width), left = std::max(0, right - 1);
        const float distance = (above[left] + above[right] + below[left] + below[right]) / 4;
        const float shown = (distance - halfAPixel) / static_cast<float>(blendPixels);
        nodes[column] = 1 - std::clamp(shown, 0.0F, 1.0F);
    }
}

} // namespace

/// Distances to the nearest masked pixel (Felzenszwalb and Huttenlocher 2012, exact), strip by strip with
/// what lies around within reach. A strip of two blending widths reads twice what it says; a higher one would
/// leave too few for the threads.
PhotoFade maskFeather(const Image& photo, double blendPixels, const Progress& progress) {
    constexpr std::size_t rowsPerStrip = 16;
    if (!(blendPixels > 0) || !isMasked(photo)) return {};
    PhotoFade fade = unfaded({photo.width, photo.height}, blendPixels);
    const int reach = static_cast<int>(std::min(std::ceil(blendPixels) + 1, double(photo.height)));
    const auto rows = static_cast<std::size_t>(fade.rows);
    forEachInParallel((rows + rowsPerStrip - 1) / rowsPerStrip, progress, [&](std::size_t strip) {
        const auto pixelBelow = [&](std::size_t row) {
            return pixelAfter(static_cast<double>(row) * fade.spacing, photo.height);
        };
        const std::size_t first = strip * rowsPerStrip, end = std::min(first + rowsPerStrip, rows);
        const int from = std::max(0, pixelBelow(first) - reach);
        const int to = std::min(photo.height, pixelBelow(end - 1) + reach + 1);
        cv::Mat distances;
        cv::distanceTransform(shownRows(photo, from, to), distances, cv::DIST_L2, cv::DIST_MASK_PRECISE);
        for (std::size_t row = first; row < end; ++row) {
            const int below = pixelBelow(row) - from, above = std::max(0, below - 1);
            fadeRow(fade, static_cast<int>(row), distances.ptr<float>(above), distances.ptr<float>(below),
                    photo.width, blendPixels);
        }
    });
    return fade;
}

} // namespace esm
