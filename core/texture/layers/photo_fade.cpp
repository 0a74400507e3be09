#include "core/texture/layers/photo_fade.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

/// The first of the two nodes between which a place lies in a row or column of `count`.
int nodeBefore(double place, int count) {
    return std::min(static_cast<int>(std::clamp(place, 0.0, count - 1.0)), count - 2);
}

} // namespace

double PhotoFade::weightAt(double x, double y) const {
    if (faded.empty()) return 1;
    const double column = std::clamp(x / spacing, 0.0, columns - 1.0),
                 row = std::clamp(y / spacing, 0.0, rows - 1.0);
    const int left = nodeBefore(column, columns), top = nodeBefore(row, rows);
    const double u = column - left, v = row - top;
    const float* upper = &faded[static_cast<std::size_t>(top) * static_cast<std::size_t>(columns) +
                                static_cast<std::size_t>(left)];
    const float* lower = upper + columns;
    return 1 - ((1 - v) * ((1 - u) * upper[0] + u * upper[1]) + v * ((1 - u) * lower[0] + u * lower[1]));
}

bool PhotoFade::isClear(const Eigen::AlignedBox2d& box) const {
    if (faded.empty()) return true;
    const int left = nodeBefore(box.min().x() / spacing, columns),
              right = nodeBefore(box.max().x() / spacing, columns) + 1;
    const int bottom = nodeBefore(box.max().y() / spacing, rows) + 1;
    for (int row = nodeBefore(box.min().y() / spacing, rows); row <= bottom; ++row) {
        const auto first = faded.begin() + std::ptrdiff_t{row} * columns;
        if (std::any_of(first + left, first + right + 1, [](float share) { return share > 0; })) return false;
    }
    return true;
}

double nodeSpacing(double blendPixels) {
    constexpr double nodesPerBlend = 8;
    return std::max(1.0, blendPixels / nodesPerBlend);
}

PhotoFade unfaded(PhotoSize photo, double blendPixels) {
    PhotoFade fade;
    constexpr double mostNodes = 4096; // a side: more are none the finer for a photo so large, and no texture
    fade.spacing = std::max(nodeSpacing(blendPixels), std::max(photo.width, photo.height) / mostNodes);
    fade.columns = static_cast<int>(std::ceil(photo.width / fade.spacing)) + 1;
    fade.rows = static_cast<int>(std::ceil(photo.height / fade.spacing)) + 1;
    fade.faded.resize(static_cast<std::size_t>(fade.columns) * static_cast<std::size_t>(fade.rows));
    return fade;
}

PhotoFade fadedByBoth(PhotoFade fade, const PhotoFade& other) {
    if (fade.faded.empty()) return other;
    for (std::size_t i = 0; i < other.faded.size(); ++i)
        fade.faded[i] = 1 - (1 - fade.faded[i]) * (1 - other.faded[i]);
    return fade;
}

} // namespace esm
