#include "core/texture/photo/region_growing.h"

#include "core/texture/photo/mask_outlines.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr int aroundSeed = 2;         ///< pixels to each side, of which the colour is taken
constexpr double outlineDetail = 0.7; ///< pixels

/// CIE L*a*b*, without the noise of single pixels, of an opaque picture.
cv::Mat calmLab(const Image& photo) {
    const cv::Mat all(photo.height, photo.width, CV_8UC4, const_cast<std::uint8_t*>(photo.pixels.data()));
    cv::Mat colours, lab;
    cv::cvtColor(all, colours, cv::COLOR_RGBA2RGB);
    cv::medianBlur(colours, colours, 5);
    colours.convertTo(lab, CV_32FC3, 1 / 255.0);
    cv::cvtColor(lab, lab, cv::COLOR_RGB2Lab);
    return lab;
}

cv::Mat opaquePart(const Image& photo) {
    cv::Mat alpha;
    cv::extractChannel(
        cv::Mat(photo.height, photo.width, CV_8UC4, const_cast<std::uint8_t*>(photo.pixels.data())), alpha,
        3);
    return alpha > 0;
}

/// Where a colour is like the seed's. Lightness counts half: a shaft of metal is one thing from its shine to
/// its shade, while blood and tissue differ by colour.
cv::Mat likeColour(const cv::Mat& lab, const cv::Scalar& seed, double tolerance) {
    cv::Mat like(lab.size(), CV_8U);
    for (int y = 0; y < lab.rows; ++y)
        for (int x = 0; x < lab.cols; ++x) {
            const auto& p = lab.at<cv::Vec3f>(y, x);
            const double difference = std::hypot((p[0] - seed[0]) / 2, p[1] - seed[1], p[2] - seed[2]);
            like.at<std::uint8_t>(y, x) = difference <= tolerance ? 255 : 0;
        }
    return like;
}

} // namespace

/// All that is like the seed and joined to it, not step by step from neighbour to neighbour: colours of
/// tissue pass into each other slowly, and such a region would run over the whole photo.
std::vector<PhotoStroke> growRegion(const Image& photo, const Eigen::Vector2d& seed, double tolerance) {
    if (!(seed.minCoeff() >= 0) || !(seed.x() < photo.width) || !(seed.y() < photo.height)) return {};
    const cv::Point place(static_cast<int>(seed.x()), static_cast<int>(seed.y()));
    if (photo.at(place.x, place.y)[3] == 0) return {};
    const cv::Mat lab = calmLab(photo);
    const cv::Rect around =
        cv::Rect(place.x - aroundSeed, place.y - aroundSeed, 2 * aroundSeed + 1, 2 * aroundSeed + 1) &
        cv::Rect({}, lab.size());
    cv::Mat like = likeColour(lab, cv::mean(lab(around)), tolerance) & opaquePart(photo);
    cv::morphologyEx(like, like, cv::MORPH_CLOSE, cv::getStructuringElement(cv::MORPH_ELLIPSE, {5, 5}));
    cv::bitwise_and(like, opaquePart(photo), like);
    cv::Mat labels;
    cv::connectedComponents(like, labels);
    const int label = labels.at<int>(place);
    return label > 0 ? strokesAround(labels == label, outlineDetail, true) : std::vector<PhotoStroke>();
}

} // namespace esm
