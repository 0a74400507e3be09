#include "core/texture/photo/field_border.h"
#include "core/texture/photo/field_fit.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace esm {

namespace {

constexpr int mostAcross = 960;                     ///< pixels that fields are looked for in
constexpr std::array<int, 3> tolerances{8, 16, 32}; ///< of the outside's level, with a glow around the field
constexpr double leastSupport = 0.45, leastSupportOfPolygon = 0.6,
                 leastEmptiness = 0.6; ///< see FieldCandidate
constexpr double gainOfShape = 0.06;   ///< by which a shape of more numbers must explain the border better

/// A field and how well it explains the photo, each number from 0 to 1.
struct FieldCandidate {
    PhotoField field;
    double support = 0;   ///< share of its rim within the photo that border points lie on
    double met = 0;       ///< share of the border points that lie on it
    double emptiness = 0; ///< share of what it leaves out that is as dark as the corners
    double cutOff = 0;    ///< share of the photo that it leaves out

    double worth() const { return support + met > 0 ? 2 * support * met / (support + met) : 0; }
    bool isGood() const {
        const bool isPolygon = field.shape == FieldShape::Polygon; // may go around anything
        return support >= (isPolygon ? leastSupportOfPolygon : leastSupport) && emptiness >= leastEmptiness &&
               cutOff > 0.004 && cutOff < 0.9;
    }
};

/// Distance of every pixel from the nearest border point.
cv::Mat distancesFrom(const FieldPoints& points, cv::Size size) {
    cv::Mat empty(size, CV_8U, 255), distances;
    for (const Eigen::Vector2d& point : points)
        empty.at<std::uint8_t>(std::clamp(static_cast<int>(point.y()), 0, size.height - 1),
                               std::clamp(static_cast<int>(point.x()), 0, size.width - 1)) = 0;
    cv::distanceTransform(empty, distances, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    return distances;
}

/// The rim in steps of a pixel or so, where it lies well within the photo.
FieldPoints rimWithin(const PhotoField& field, cv::Size size) {
    constexpr double edge = 3;
    const PhotoOutline outline = outlineOf(field, false);
    FieldPoints rim;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Eigen::Vector2d &from = outline[i], &to = outline[(i + 1) % outline.size()];
        const int steps = std::max(1, static_cast<int>((to - from).norm()));
        for (int step = 0; step < steps; ++step) {
            const Eigen::Vector2d place = from + (to - from) * step / steps;
            if (place.minCoeff() > edge && place.x() < size.width - edge && place.y() < size.height - edge)
                rim.push_back(place);
        }
    }
    return rim;
}

FieldCandidate judged(const PhotoField& field, const FieldBorder& border, const cv::Mat& distances,
                      double tolerance) {
    FieldCandidate candidate{field};
    const cv::Size size = distances.size();
    const FieldPoints rim = rimWithin(field, size);
    const auto isMet = [&](const Eigen::Vector2d& p) {
        return distances.at<float>(static_cast<int>(p.y()), static_cast<int>(p.x())) <= tolerance + 1;
    };
    if (!rim.empty())
        candidate.support = static_cast<double>(std::count_if(rim.begin(), rim.end(), isMet)) /
                            static_cast<double>(rim.size());
    const auto liesOn = [&](const Eigen::Vector2d& p) {
        return std::abs(distanceInside(field, p)) <= tolerance;
    };
    candidate.met = static_cast<double>(std::count_if(border.points.begin(), border.points.end(), liesOn)) /
                    static_cast<double>(std::max<std::size_t>(1, border.points.size()));
    const std::vector<float> cover = coverOf(outlineOf(field, false), size.width, size.height);
    const cv::Mat beyond = cv::Mat(size, CV_32F, const_cast<float*>(cover.data())) < 0.5;
    const int left = cv::countNonZero(beyond);
    candidate.cutOff = left / static_cast<double>(size.area());
    candidate.emptiness =
        cv::countNonZero(beyond & border.outside) / std::max(1.0, static_cast<double>(left));
    return candidate;
}

/// The simplest shape that explains the border: one with more numbers must do so clearly better.
std::optional<FieldCandidate> bestShape(const cv::Mat& brightness, int level, int within) {
    const FieldBorder border = borderOf(brightness, level, within);
    const cv::Size size = brightness.size();
    const double tolerance = std::max(1.0, 0.003 * std::max(size.width, size.height));
    const cv::Mat distances = distancesFrom(border.points, size);
    std::optional<FieldCandidate> best;
    for (const auto& field :
         {circleThrough(border.points, size, tolerance), ellipseThrough(border.points, size, tolerance),
          polygonAround(border.lit, border.points, tolerance)}) {
        if (!field) continue;
        const FieldCandidate candidate = judged(*field, border, distances, tolerance);
        if (candidate.isGood() && (!best || candidate.worth() > best->worth() + gainOfShape))
            best = candidate;
    }
    return best;
}

PhotoField enlarged(PhotoField field, double scale) {
    field.centre *= scale;
    field.radii *= scale;
    for (Eigen::Vector2d& corner : field.corners)
        corner *= scale;
    return field;
}

} // namespace

/// Three notions of dark are tried, since around some fields there is a glow, and the one is taken by which a
/// shape explains the border best.
std::optional<PhotoField> findField(const Image& photo) {
    if (photo.width < 32 || photo.height < 32) return std::nullopt;
    ReducedPhoto reduced = reducedPhoto(photo, mostAcross);
    const std::optional<int> level = darkLevel(reduced.brightness);
    if (!level) return std::nullopt;
    reduced.brightness.setTo(*level, reduced.burntIn);
    std::optional<FieldCandidate> best;
    for (const int tolerance : tolerances) {
        const auto found = bestShape(reduced.brightness, *level, tolerance);
        if (found && (!best || found->worth() > best->worth() + 0.02)) best = found;
    }
    return best ? std::optional(enlarged(best->field, reduced.scale)) : std::nullopt;
}

} // namespace esm
