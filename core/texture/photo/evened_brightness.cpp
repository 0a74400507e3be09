#include "core/texture/photo/evened_brightness.h"

#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>

namespace esm {

namespace {

constexpr int windowsAcross = 10;    ///< the width of what counts as surroundings, in the longer side
constexpr double leastDeviation = 4; ///< of brightness: what differs by less is noise
constexpr std::uint8_t opaque = 128; ///< alpha from which on a pixel counts

/// The mean around each pixel, over the pixels that count.
cv::Mat1f meanAround(const cv::Mat1f& values, const cv::Mat1f& counts, int window) {
    cv::Mat1f sum, share;
    const cv::Size size(window, window);
    cv::multiply(values, counts, sum);
    cv::boxFilter(sum, sum, CV_32F, size, {-1, -1}, true, cv::BORDER_REFLECT);
    cv::boxFilter(counts, share, CV_32F, size, {-1, -1}, true, cv::BORDER_REFLECT);
    cv::max(share, 1e-6F, share);
    cv::Mat1f mean;
    cv::divide(sum, share, mean);
    return mean;
}

} // namespace

/// Mean and standard deviation of a window around each pixel are taken out, as in normalised
/// cross-correlation.
EvenedBrightness evenedBrightness(const Image& picture, const Image& surroundings) {
    cv::Mat1f brightness(picture.height, picture.width), around(picture.height, picture.width);
    EvenedBrightness evened{picture.width, picture.height, {}, {}};
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const std::uint8_t* pixel = picture.at(x, y);
            brightness(y, x) = 0.299F * pixel[0] + 0.587F * pixel[1] + 0.114F * pixel[2];
            const bool isOpaque = pixel[3] >= opaque;
            evened.counts.push_back(isOpaque ? 1 : 0);
            around(y, x) = isOpaque && surroundings.at(x, y)[3] >= opaque ? 1 : 0;
        }
    const int window = 2 * (std::max(picture.width, picture.height) / (2 * windowsAcross)) + 1;
    const cv::Mat1f mean = meanAround(brightness, around, window);
    cv::Mat1f off, squares, deviation, values;
    cv::subtract(brightness, mean, off);
    cv::multiply(off, off, squares);
    cv::add(meanAround(squares, around, window), leastDeviation * leastDeviation, deviation);
    cv::sqrt(deviation, deviation);
    cv::divide(off, deviation, values);
    evened.values.assign(values.begin(), values.end());
    return evened;
}

std::optional<BrightnessAt> brightnessAt(const EvenedBrightness& picture, const Eigen::Vector2d& place) {
    const double x = place.x() - 0.5, y = place.y() - 0.5;
    if (!(x >= 0 && y >= 0 && x < picture.width - 1 && y < picture.height - 1)) return std::nullopt;
    const int column = static_cast<int>(x), row = static_cast<int>(y);
    const std::array<std::size_t, 4> around{picture.index(column, row), picture.index(column + 1, row),
                                            picture.index(column, row + 1),
                                            picture.index(column + 1, row + 1)};
    for (const std::size_t pixel : around)
        if (picture.counts[pixel] == 0) return std::nullopt;
    const double u = x - column, v = y - row;
    const std::vector<float>& of = picture.values;
    const double left = (1 - v) * of[around[0]] + v * of[around[2]];
    const double right = (1 - v) * of[around[1]] + v * of[around[3]];
    const double above = (1 - u) * of[around[0]] + u * of[around[1]];
    const double below = (1 - u) * of[around[2]] + u * of[around[3]];
    return BrightnessAt{(1 - u) * left + u * right, {right - left, below - above}};
}

} // namespace esm
