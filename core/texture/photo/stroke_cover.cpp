#include "core/texture/photo/stroke_cover.h"

#include "core/geometry/segment_distance.h"
#include "core/texture/photo/outline_cover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tbb/parallel_for.h>

namespace esm {

namespace {

constexpr int smallestSquare = 4;       ///< pixels; asked pixel by pixel
constexpr int sharedSquare = 64;        ///< pixels; smaller ones are not worth another thread
constexpr double squareRounding = 1e-6; ///< pixels

struct StrokeSegment {
    Eigen::Vector2d from, to;

    double distance(const Eigen::Vector2d& place) const { return distanceToSegment(place, from, to); }
};
using StrokeSegments = std::vector<StrokeSegment>;

/// An outline comes back to its beginning, a dab stays.
StrokeSegments segmentsOf(const PhotoStroke& stroke) {
    const std::vector<Eigen::Vector2d>& path = stroke.path;
    const std::size_t count = stroke.isFilled ? path.size() : std::max<std::size_t>(1, path.size() - 1);
    StrokeSegments segments;
    segments.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        segments.push_back({path[i], stroke.isFilled ? path[(i + 1) % path.size()]
                                                     : path[std::min(i + 1, path.size() - 1)]});
    return segments;
}

/// All pixels that a stroke reaches, on the photo or beside it.
PixelRange reachOf(const PhotoStroke& stroke) {
    Eigen::Vector2d low = stroke.path.front(), high = low;
    for (const Eigen::Vector2d& place : stroke.path) {
        low = low.cwiseMin(place);
        high = high.cwiseMax(place);
    }
    const auto pixel = [](double place) {
        return static_cast<int>(std::clamp(std::floor(place), -1e9, 1e9));
    };
    return {pixel(low.x() - stroke.radius - 1), pixel(low.y() - stroke.radius - 1),
            pixel(high.x() + stroke.radius + 1), pixel(high.y() + stroke.radius + 1)};
}

PixelRange sharedPart(const PixelRange& a, const PixelRange& b) {
    return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right),
            std::min(a.bottom, b.bottom)};
}

/// Nothing at first, or the inside of an outline.
std::vector<float> insideOf(const PhotoStroke& stroke, const PixelRange& range) {
    PhotoOutline inside;
    if (stroke.isFilled) inside = stroke.path;
    for (Eigen::Vector2d& place : inside)
        place.x() -= range.left;
    return coverOf(inside, range.width(), range.top, range.bottom + 1);
}

/// The cover follows from the distance to the nearest segment, and few segments can be the nearest to any
/// pixel of a small square: those that its middle has hardly farther than the nearest. So the photo is halved
/// into ever smaller squares, each of which hands on what segments are left. The time goes with the pixels
/// and the segments, not with their product, however wide the brush is.
class StrokePainter {
public:
    StrokePainter(const PhotoStroke& stroke, StrokeCover& cover)
        : m_reach(stroke.radius + 0.5), m_fade(std::max(1.0, stroke.softness * stroke.radius)),
          m_cover(cover) {}

    void paint(const PixelRange& square, const StrokeSegments& segments) {
        if (square.isEmpty()) return;
        const Eigen::Vector2d middle((square.left + square.right + 1) / 2.0,
                                     (square.top + square.bottom + 1) / 2.0);
        const double half = Eigen::Vector2d(square.width(), square.height()).norm() / 2 + squareRounding;
        std::vector<double> distances(segments.size());
        std::transform(segments.begin(), segments.end(), distances.begin(),
                       [&](const StrokeSegment& segment) { return segment.distance(middle); });
        const double nearest = *std::min_element(distances.begin(), distances.end());
        if (nearest - half > m_reach) return;
        if (nearest + half < m_reach - m_fade) return fill(square);
        StrokeSegments near;
        for (std::size_t i = 0; i < segments.size(); ++i)
            if (distances[i] <= nearest + 2 * half) near.push_back(segments[i]);
        if (std::max(square.width(), square.height()) <= smallestSquare)
            paintPixels(square, near);
        else
            paintHalves(square, near);
    }

private:
    /// At least a pixel wide, the edge is that of a hard brush drawn without stairs: half at the radius.
    float coverAt(double distance) const {
        return static_cast<float>(std::clamp((m_reach - distance) / m_fade, 0.0, 1.0));
    }

    void fill(const PixelRange& square) {
        for (int y = square.top; y <= square.bottom; ++y)
            std::fill_n(&m_cover.at(square.left, y), square.width(), 1.0F);
    }

    void paintPixels(const PixelRange& square, const StrokeSegments& segments) {
        for (int y = square.top; y <= square.bottom; ++y)
            for (int x = square.left; x <= square.right; ++x) {
                double distance = std::numeric_limits<double>::infinity();
                for (const StrokeSegment& segment : segments)
                    distance = std::min(distance, segment.distance({x + 0.5, y + 0.5}));
                float& value = m_cover.at(x, y);
                value = std::max(value, coverAt(distance));
            }
    }

    /// Across the longer side, so that parts become squares.
    void paintHalves(const PixelRange& square, const StrokeSegments& segments) {
        std::array<PixelRange, 2> halves{square, square};
        if (square.width() > square.height()) {
            halves[0].right = (square.left + square.right) / 2;
            halves[1].left = halves[0].right + 1;
        } else {
            halves[0].bottom = (square.top + square.bottom) / 2;
            halves[1].top = halves[0].bottom + 1;
        }
        if (std::max(square.width(), square.height()) <= sharedSquare)
            for (const PixelRange& half : halves)
                paint(half, segments);
        else
            tbb::parallel_for(std::size_t{0}, halves.size(),
                              [&](std::size_t i) { paint(halves[i], segments); });
    }

    double m_reach; ///< pixels from the path, where the cover ends
    double m_fade;  ///< pixels before that over which it rises to 1
    StrokeCover& m_cover;
};

} // namespace

StrokeCover coverOf(const PhotoStroke& stroke, const PixelRange& part) {
    StrokeCover cover{sharedPart(reachOf(stroke), part), {}};
    if (cover.range.isEmpty()) return cover;
    cover.values = insideOf(stroke, cover.range);
    StrokePainter(stroke, cover).paint(cover.range, segmentsOf(stroke));
    return cover;
}

} // namespace esm
