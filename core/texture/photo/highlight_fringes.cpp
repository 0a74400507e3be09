#include "core/texture/photo/highlight_fringes.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace esm {

namespace {

// Rims of a laparoscope and of a rhinoscope had 0.7 to 0.95 times as much blue as red where the tissue around
// had 0.35 to 0.45, and 0.7 to 0.86 times as much green as the lesser of both. What is pale under a bluish
// lamp has as much blue, but more green.
constexpr int partsAcross = 24;       ///< of the longer side: as wide is what a rim is compared with
constexpr int darkestCompared = 32;   ///< red; what is darker has no colour to compare
constexpr float bluer = 1.15F;        ///< times as much blue to red as around …
constexpr float bluerAtLeast = 0.04F; ///< … and so much more is no tissue's
constexpr float lilac = 0.88F;        ///< times as much green as the lesser of red and blue, at most

/// Blue to red, and 1 where that says what tissue is like.
struct Blueness {
    cv::Mat1f ratio, counts;
};

Blueness bluenessOf(const Image& photo, const cv::Mat& left) {
    Blueness blueness{cv::Mat1f(photo.height, photo.width, 0.0F), cv::Mat1f(photo.height, photo.width, 0.0F)};
    for (int y = 0; y < photo.height; ++y)
        for (int x = 0; x < photo.width; ++x) {
            const std::uint8_t* pixel = photo.at(x, y);
            if (pixel[3] == 0 || pixel[0] < darkestCompared) continue;
            blueness.ratio(y, x) = static_cast<float>(pixel[2]) / static_cast<float>(pixel[0]);
            blueness.counts(y, x) = left.at<std::uint8_t>(y, x) > 0 ? 0.0F : 1.0F;
        }
    return blueness;
}

/// The mean ratio around each pixel; 0 where nothing counts.
cv::Mat1f around(const Blueness& blueness) {
    const cv::Size size = blueness.ratio.size();
    const int window = 2 * (std::max(size.width, size.height) / (2 * partsAcross)) + 1;
    cv::Mat1f sum, share, mean;
    cv::multiply(blueness.ratio, blueness.counts, sum);
    cv::boxFilter(sum, sum, CV_32F, {window, window}, {-1, -1}, true, cv::BORDER_REFLECT);
    cv::boxFilter(blueness.counts, share, CV_32F, {window, window}, {-1, -1}, true, cv::BORDER_REFLECT);
    cv::divide(sum, cv::max(share, 1e-6F), mean);
    return mean;
}

} // namespace

void addFringes(cv::Mat& mask, const Image& photo, int reach) {
    if (cv::countNonZero(mask) == 0) return;
    cv::Mat near;
    cv::dilate(mask, near, cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * reach + 1, 2 * reach + 1}));
    const Blueness blueness = bluenessOf(photo, near);
    const cv::Mat1f tissue = around(blueness);
    for (int y = 0; y < photo.height; ++y)
        for (int x = 0; x < photo.width; ++x) {
            if (near.at<std::uint8_t>(y, x) == 0 || !(tissue(y, x) > 0)) continue;
            const std::uint8_t* pixel = photo.at(x, y);
            const bool isLilac =
                static_cast<float>(pixel[1]) < lilac * static_cast<float>(std::min(pixel[0], pixel[2]));
            if (isLilac && blueness.ratio(y, x) > bluer * tissue(y, x) + bluerAtLeast)
                mask.at<std::uint8_t>(y, x) = 255;
        }
}

} // namespace esm
