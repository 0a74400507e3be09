#include "core/texture/photo/highlights.h"

#include <opencv2/imgproc.hpp>
#include <opencv2/photo.hpp>

#include <algorithm>

namespace esm {

namespace {

constexpr int rim = 2;
constexpr double inpaintRadius = 4;

cv::Mat opaquePixels(const Image& photo) {
    cv::Mat mask(photo.height, photo.width, CV_8U);
    for (int y = 0; y < photo.height; ++y)
        for (int x = 0; x < photo.width; ++x)
            mask.at<std::uint8_t>(y, x) = photo.at(x, y)[3] > 0 ? 255 : 0;
    return mask;
}

cv::Mat brightPixels(const Image& photo, int threshold) {
    cv::Mat mask(photo.height, photo.width, CV_8U);
    for (int y = 0; y < photo.height; ++y)
        for (int x = 0; x < photo.width; ++x) {
            const std::uint8_t* pixel = photo.at(x, y);
            const bool bright = pixel[3] > 0 && std::min({pixel[0], pixel[1], pixel[2]}) > threshold;
            mask.at<std::uint8_t>(y, x) = bright ? 255 : 0;
        }
    return mask;
}

} // namespace

std::size_t fillHighlights(Image& photo, int threshold) {
    if (photo.empty()) return 0;
    const cv::Mat opaque = opaquePixels(photo);
    cv::Mat mask = brightPixels(photo, threshold);
    cv::dilate(mask, mask, cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * rim + 1, 2 * rim + 1}));
    cv::bitwise_and(mask, opaque, mask);
    const int filled = cv::countNonZero(mask);
    if (filled == 0 || filled == cv::countNonZero(opaque)) return 0;
    cv::Mat colours, result;
    cv::cvtColor(cv::Mat(photo.height, photo.width, CV_8UC4, photo.pixels.data()), colours,
                 cv::COLOR_RGBA2RGB);
    cv::inpaint(colours, mask, result, inpaintRadius, cv::INPAINT_TELEA);
    for (int y = 0; y < photo.height; ++y)
        for (int x = 0; x < photo.width; ++x)
            if (mask.at<std::uint8_t>(y, x) != 0)
                std::copy_n(result.ptr<std::uint8_t>(y, x), 3, photo.at(x, y));
    return static_cast<std::size_t>(filled);
}

} // namespace esm
