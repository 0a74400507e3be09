#include "core/texture/photo/field_border.h"

#include "core/texture/photo/photo_overlays.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace esm {

namespace {

constexpr int brightestOutside = 48; ///< brightest level that passes for the dark outside
constexpr int mostUneven = 14;       ///< by how much its levels may differ in a corner
constexpr int plateauReach = 5;      ///< pixels within which a border reaches its full brightness
constexpr int sideReach = 20;        ///< pixels beyond, with which it is compared

/// What lies between the fifth and the ninetieth hundredth of a corner's levels: nearly all noise, and not a
/// few bright pixels, as of a date.
struct CornerLevels {
    int low, middle, high;
    bool isOutside() const { return high <= brightestOutside && high - low <= mostUneven; }
};

CornerLevels cornerLevels(const cv::Mat& corner) {
    const cv::Mat copy = corner.clone();
    std::vector<std::uint8_t> levels(copy.begin<std::uint8_t>(), copy.end<std::uint8_t>());
    std::sort(levels.begin(), levels.end());
    const auto at = [&](std::size_t percent) { return int{levels[(levels.size() - 1) * percent / 100]}; };
    return {at(5), at(50), at(90)};
}

/// The largest connected part of a mask.
cv::Mat largestPart(const cv::Mat& mask) {
    cv::Mat labels, boxes, middles;
    const int count = cv::connectedComponentsWithStats(mask, labels, boxes, middles);
    int largest = 0, most = 0;
    for (int label = 1; label < count; ++label)
        if (const int area = boxes.at<int>(label, cv::CC_STAT_AREA); area > most) {
            most = area;
            largest = label;
        }
    return largest > 0 ? cv::Mat(labels == largest) : cv::Mat(cv::Mat::zeros(mask.size(), CV_8U));
}

/// One line through the photo from its frame inwards.
struct FrameRay {
    cv::Point start, step;
    int length;
    cv::Point at(int i) const { return start + i * step; }
};

int brightestAlong(const cv::Mat& brightness, const FrameRay& ray, int from, int to) {
    int most = 0;
    for (int i = from; i < std::min(to, ray.length); ++i)
        most = std::max<int>(most, brightness.at<std::uint8_t>(ray.at(i)));
    return most;
}

/// Where the light begins along a ray, at half its height between two pixels, as a blurred border is lit
/// beyond its place. Nothing where it begins within the frame's first pixels, which is the frame's own side,
/// or rises slowly: dark tissue ends so, a field does not.
void addBorderPoint(const cv::Mat& brightness, const cv::Mat& lit, int level, const FrameRay& ray,
                    std::vector<Eigen::Vector2d>& points) {
    int first = 0;
    while (first < ray.length && lit.at<std::uint8_t>(ray.at(first)) == 0)
        ++first;
    if (first < 3 || first >= ray.length) return;
    const int plateau = brightestAlong(brightness, ray, first, first + plateauReach);
    const int beyond = brightestAlong(brightness, ray, first, first + sideReach);
    const int before = brightness.at<std::uint8_t>(ray.at(first - 3));
    if (5 * (plateau - before) < 2 * (beyond - level)) return;
    const double half = (level + plateau) / 2.0;
    int place = std::max(1, first - 2);
    while (place < first + plateauReach && brightness.at<std::uint8_t>(ray.at(place)) < half)
        ++place;
    const double below = brightness.at<std::uint8_t>(ray.at(place - 1));
    const double after = brightness.at<std::uint8_t>(ray.at(place));
    const double share = after > below ? std::clamp((half - below) / (after - below), 0.0, 1.0) : 0.5;
    const double along = place - 1 + share;
    points.emplace_back(ray.start.x + 0.5 + along * ray.step.x, ray.start.y + 0.5 + along * ray.step.y);
}

} // namespace

ReducedPhoto reducedPhoto(const Image& photo, int mostAcross) {
    ReducedPhoto reduced{cv::Mat(photo.height, photo.width, CV_8U),
                         cv::Mat(photo.height, photo.width, CV_8U)};
    for (int y = 0; y < photo.height; ++y)
        for (int x = 0; x < photo.width; ++x) {
            const std::uint8_t* p = photo.at(x, y);
            reduced.brightness.at<std::uint8_t>(y, x) = p[3] > 0 ? std::max({p[0], p[1], p[2]}) : 255;
            reduced.burntIn.at<std::uint8_t>(y, x) = isNoTissue(p) ? 255 : 0;
        }
    reduced.scale = std::max(1.0, static_cast<double>(std::max(photo.width, photo.height)) / mostAcross);
    for (cv::Mat* mat : {&reduced.brightness, &reduced.burntIn}) {
        const double share = 1 / reduced.scale;
        if (share < 1) cv::resize(*mat, *mat, {}, share, share, cv::INTER_AREA);
        cv::medianBlur(*mat, *mat, 3);
    }
    reduced.burntIn = reduced.burntIn >= 128;
    cv::dilate(reduced.burntIn, reduced.burntIn, {}, {-1, -1}, 2);
    return reduced;
}

std::optional<int> darkLevel(const cv::Mat& brightness) {
    const int side = std::max(3, std::min(brightness.cols, brightness.rows) / 50);
    std::optional<int> level;
    for (const int x : {0, brightness.cols - side})
        for (const int y : {0, brightness.rows - side}) {
            const CornerLevels corner = cornerLevels(brightness(cv::Rect(x, y, side, side)));
            if (corner.isOutside() && (!level || corner.middle < *level)) level = corner.middle;
        }
    return level;
}

/// What is as dark as the corners is outside, be it black or grey; tissue that is darker than a grey corner
/// is not. Thin letters are opened away, and what does not hang together with the picture, as boxes in the
/// corners, counts as outside.
FieldBorder borderOf(const cv::Mat& brightness, int level, int tolerance) {
    FieldBorder border;
    cv::Mat lit;
    cv::inRange(brightness, level - tolerance, level + tolerance, border.outside);
    cv::bitwise_not(border.outside, lit);
    const int width = 2 * std::max(1, std::min(lit.cols, lit.rows) / 200) + 1;
    cv::morphologyEx(lit, lit, cv::MORPH_OPEN, cv::getStructuringElement(cv::MORPH_ELLIPSE, {width, width}));
    border.lit = largestPart(lit);
    for (int y = 0; y < lit.rows; ++y) {
        addBorderPoint(brightness, border.lit, level, {{0, y}, {1, 0}, lit.cols}, border.points);
        addBorderPoint(brightness, border.lit, level, {{lit.cols - 1, y}, {-1, 0}, lit.cols}, border.points);
    }
    for (int x = 0; x < lit.cols; ++x) {
        addBorderPoint(brightness, border.lit, level, {{x, 0}, {0, 1}, lit.rows}, border.points);
        addBorderPoint(brightness, border.lit, level, {{x, lit.rows - 1}, {0, -1}, lit.rows}, border.points);
    }
    return border;
}

} // namespace esm
