#include "core/texture/photo/round_field.h"

#include <Eigen/Dense>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <tbb/parallel_for.h>
#include <vector>

namespace esm {

namespace {

using Points = std::vector<Eigen::Vector2d>;

struct Circle {
    Eigen::Vector2d centre;
    double radius;
    double distance(const Eigen::Vector2d& point) const { return std::abs((point - centre).norm() - radius); }
};

constexpr int darkest = 40; ///< brightest level that passes for the dark outside
constexpr std::array<int, 3> aboveDark{8, 16,
                                       32}; ///< levels by which the field exceeds it, with a glow around it
constexpr int linesPerSide = 400;           ///< rows and columns that are searched
constexpr int trials = 600;                 ///< of three points
constexpr double fewestInliers = 0.35;      ///< share of the border points on the circle
constexpr std::size_t arcs = 36, fewestArcs = 12;

/// The brightest channel, without the noise of single pixels; a straight border stays where it is.
cv::Mat brightness(const Image& photo) {
    cv::Mat grey(photo.height, photo.width, CV_8U);
    for (int y = 0; y < photo.height; ++y)
        for (int x = 0; x < photo.width; ++x) {
            const std::uint8_t* pixel = photo.at(x, y);
            grey.at<std::uint8_t>(y, x) = std::max({pixel[0], pixel[1], pixel[2]});
        }
    cv::medianBlur(grey, grey, 5);
    return grey;
}

/// The level of the darkest corner, which an endoscope's field does not reach. Its 95 % quantile: nearly all
/// noise of the dark lies below it, and a few bright pixels, as of a date, do not raise it.
int darkLevel(const cv::Mat& grey) {
    const int side = std::max(1, std::min(grey.cols, grey.rows) / 25);
    int level = 255;
    for (const int x : {0, grey.cols - side})
        for (const int y : {0, grey.rows - side}) {
            const cv::Mat corner = grey(cv::Rect(x, y, side, side)).clone();
            std::vector<std::uint8_t> levels(corner.begin<std::uint8_t>(), corner.end<std::uint8_t>());
            const auto high = levels.begin() + static_cast<std::ptrdiff_t>(levels.size() * 95 / 100);
            std::nth_element(levels.begin(), high, levels.end());
            level = std::min<int>(level, *high);
        }
    return level;
}

/// Where the light begins along a line, from its dark end; nothing where it begins lit or stays dark. Four
/// lit pixels on end are asked for, as one may be noise, and four dark ones before, as a border at the
/// photo's own side is none.
void addBorder(const cv::Mat& grey, cv::Point start, cv::Point step, int level, Points& points) {
    constexpr int lasting = 4;
    const cv::Rect all(0, 0, grey.cols, grey.rows);
    int lit = 0, place = 0;
    for (cv::Point at = start; all.contains(at); at += step, ++place) {
        lit = grey.at<std::uint8_t>(at) > level ? lit + 1 : 0;
        if (lit < lasting) continue;
        const int first = place - lasting + 1;
        if (first < lasting) return;
        const cv::Point border = start + first * step;
        points.emplace_back(border.x + 0.5 - 0.5 * step.x, border.y + 0.5 - 0.5 * step.y);
        return;
    }
}

Points borderPoints(const cv::Mat& grey, int level) {
    Points points;
    const int rows = std::max(1, grey.rows / linesPerSide), columns = std::max(1, grey.cols / linesPerSide);
    for (int y = 0; y < grey.rows; y += rows) {
        addBorder(grey, {0, y}, {1, 0}, level, points);
        addBorder(grey, {grey.cols - 1, y}, {-1, 0}, level, points);
    }
    for (int x = 0; x < grey.cols; x += columns) {
        addBorder(grey, {x, 0}, {0, 1}, level, points);
        addBorder(grey, {x, grey.rows - 1}, {0, -1}, level, points);
    }
    return points;
}

/// Least squares of x² + y² = 2·a·x + 2·b·y + c (Kåsa 1976), which is linear, unlike that of the distances.
/// Its circles come out too small where points cover a short arc; a third of the turn is asked for elsewhere.
/// Around the mean, so that squares of large coordinates do not cancel.
std::optional<Circle> fitted(const Points& points) {
    if (points.size() < 3) return std::nullopt;
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& point : points)
        mean += point / static_cast<double>(points.size());
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const Eigen::Vector2d& point : points) {
        const Eigen::Vector2d d = point - mean;
        const Eigen::Vector3d row(2 * d.x(), 2 * d.y(), 1);
        normal += row * row.transpose();
        right += row * d.squaredNorm();
    }
    const Eigen::Vector3d found = normal.fullPivLu().solve(right);
    const double square = found.z() + found.head<2>().squaredNorm();
    if (!found.allFinite() || !(square > 0)) return std::nullopt;
    return Circle{mean + found.head<2>(), std::sqrt(square)};
}

Points near(const Points& points, const Circle& circle, double tolerance) {
    Points on;
    std::copy_if(points.begin(), points.end(), std::back_inserter(on),
                 [&](const Eigen::Vector2d& point) { return circle.distance(point) <= tolerance; });
    return on;
}

/// The circle through three of the points that meets most of them: RANSAC (Fischler and Bolles 1981).
/// Instruments, dark organs and straight edges of the photo are border points too, and least squares of all
/// would be drawn aside by them. If a share q of the points lies on the circle, three random ones do with q³:
/// for q = 0.35, the least that is accepted, 600 trials miss it with a probability of (1 − 0.043)⁶⁰⁰ < 10⁻¹¹.
/// The generator is written out (Knuth's constants for a linear congruential one) and begins at the same
/// state, so that a photo always has the same field.
Points largestConsensus(const Points& points, double tolerance, double longest) {
    std::uint64_t state = 1;
    const auto any = [&] {
        state = state * 6364136223846793005U + 1442695040888963407U;
        return points[(state >> 33) % points.size()];
    };
    Points best;
    for (int i = 0; i < trials; ++i) {
        const auto circle = fitted({any(), any(), any()});
        if (!circle || circle->radius > longest || circle->radius < longest / 8) continue;
        Points on = near(points, *circle, tolerance);
        if (on.size() > best.size()) best = std::move(on);
    }
    return best;
}

/// A circle of which a short arc alone is seen is not known well: points must lie in a third of all
/// directions.
bool goesRound(const Points& points, const Circle& circle) {
    std::bitset<arcs> seen;
    for (const Eigen::Vector2d& point : points) {
        const Eigen::Vector2d d = point - circle.centre;
        const double turn = std::atan2(d.y(), d.x()) / (2 * M_PI) + 0.5;
        seen.set(std::min(arcs - 1, static_cast<std::size_t>(turn * arcs)));
    }
    return seen.count() >= fewestArcs;
}

/// A circle and how many of the border points lie on it, 0 to 1.
struct FittedCircle {
    Circle circle;
    double share;
};

/// The best circle of three points is only as good as those three. It is fitted again to all near it, with
/// half the tolerance and five times, until it has settled.
std::optional<FittedCircle> fittedBorder(const cv::Mat& grey, int level) {
    const Points points = borderPoints(grey, level);
    if (points.size() < 40) return std::nullopt;
    const double size = std::max(grey.cols, grey.rows);
    Points on = largestConsensus(points, std::max(1.5, 0.004 * size), 0.75 * size);
    std::optional<Circle> circle = fitted(on);
    for (int i = 0; i < 5 && circle; ++i) {
        on = near(points, *circle, std::max(1.0, 0.002 * size));
        circle = fitted(on);
    }
    if (!circle || !goesRound(on, *circle)) return std::nullopt;
    const double share = static_cast<double>(on.size()) / static_cast<double>(points.size());
    if (share < fewestInliers) return std::nullopt;
    return FittedCircle{*circle, share};
}

} // namespace

std::optional<RoundField> findRoundField(const Image& photo) {
    if (photo.width < 32 || photo.height < 32) return std::nullopt;
    const cv::Mat grey = brightness(photo);
    const int dark = darkLevel(grey);
    if (dark > darkest) return std::nullopt;
    std::optional<FittedCircle> best;
    for (const int above : aboveDark) {
        const auto found = fittedBorder(grey, dark + above);
        if (found && (!best || found->share > best->share)) best = found;
    }
    if (!best) return std::nullopt;
    const Circle& circle = best->circle;
    return RoundField{circle.centre, circle.radius, RoundField().trim};
}

void maskField(Image& photo, const RoundField& field) {
    const double radius = field.radius * (1 - field.trim / 100);
    tbb::parallel_for(0, photo.height, [&](int y) {
        for (int x = 0; x < photo.width; ++x) {
            const double inside =
                radius + 0.5 - std::hypot(x + 0.5 - field.centre.x(), y + 0.5 - field.centre.y());
            std::uint8_t& alpha = photo.at(x, y)[3];
            alpha = static_cast<std::uint8_t>(std::lround(alpha * std::clamp(inside, 0.0, 1.0)));
        }
    });
}

} // namespace esm
