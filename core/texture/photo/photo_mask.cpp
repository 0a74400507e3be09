#include "core/texture/photo/photo_mask.h"

#include "core/geometry/segment_distance.h"
#include "core/texture/photo/outline_cover.h"

#include <algorithm>
#include <cmath>
#include <tbb/parallel_for.h>

namespace esm {

namespace {

/// A part of the photo, its ends included; empty where an end lies before its begin.
struct PixelRange {
    int left, top, right, bottom;
};

PixelRange reachOf(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double radius,
                   const Image& photo) {
    const auto within = [](double place, int size) {
        return static_cast<int>(std::clamp(std::floor(place), -1.0, static_cast<double>(size)));
    };
    return {std::max(0, within(low.x() - radius - 1, photo.width)),
            std::max(0, within(low.y() - radius - 1, photo.height)),
            std::min(photo.width - 1, within(high.x() + radius + 1, photo.width)),
            std::min(photo.height - 1, within(high.y() + radius + 1, photo.height))};
}

/// How much of the brush lies on a place, 0 to 1. At least a pixel wide, the edge is that of a hard brush
/// drawn without stairs: half at the radius.
double brushAt(const PhotoStroke& stroke, double distance) {
    const double fade = std::max(1.0, stroke.softness * stroke.radius);
    return std::clamp((stroke.radius + 0.5 - distance) / fade, 0.0, 1.0);
}

/// Where the segment that begins at a place ends: an outline comes back to its beginning, a dab stays.
std::size_t nextPlace(const PhotoStroke& stroke, std::size_t place) {
    if (stroke.isFilled) return (place + 1) % stroke.path.size();
    return std::min(place + 1, stroke.path.size() - 1);
}

std::size_t segmentsOf(const PhotoStroke& stroke) {
    return stroke.isFilled ? stroke.path.size() : std::max<std::size_t>(1, stroke.path.size() - 1);
}

/// What a stroke covers, 0 to 1, in the part of the photo that it reaches.
struct Coverage {
    PixelRange range;
    std::vector<float> values;

    float& at(int x, int y) {
        const int width = range.right - range.left + 1;
        return values[static_cast<std::size_t>(y - range.top) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x - range.left)];
    }
};

/// Draws one segment of a stroke where it covers more than those before it. Only the pixels around the
/// segment are looked at, so that a long stroke costs its area and not that of its box for each segment.
void drawSegment(const PhotoStroke& stroke, std::size_t segment, const Image& photo, Coverage& coverage) {
    const Eigen::Vector2d& from = stroke.path[segment];
    const Eigen::Vector2d& to = stroke.path[nextPlace(stroke, segment)];
    const PixelRange range = reachOf(from.cwiseMin(to), from.cwiseMax(to), stroke.radius, photo);
    for (int y = range.top; y <= range.bottom; ++y)
        for (int x = range.left; x <= range.right; ++x) {
            const double distance = distanceToSegment({x + 0.5, y + 0.5}, from, to);
            float& value = coverage.at(x, y);
            value = std::max(value, static_cast<float>(brushAt(stroke, distance)));
        }
}

/// Nothing at first, or the inside of an outline.
void fillInside(const PhotoStroke& stroke, Coverage& coverage) {
    const PixelRange& range = coverage.range;
    const int width = range.right - range.left + 1, height = range.bottom - range.top + 1;
    PhotoOutline inside;
    if (stroke.isFilled) inside = stroke.path;
    for (Eigen::Vector2d& place : inside)
        place -= Eigen::Vector2d(range.left, range.top);
    coverage.values = coverOf(inside, width, height);
}

/// A stroke is drawn by itself first, by the greatest cover of its segments, and laid on the mask then. Laid
/// segment by segment, a soft stroke would grow harder where segments overlap, which is everywhere along its
/// path.
Coverage coverageOf(const PhotoStroke& stroke, const Image& photo) {
    Eigen::Vector2d low = stroke.path.front(), high = low;
    for (const Eigen::Vector2d& place : stroke.path) {
        low = low.cwiseMin(place);
        high = high.cwiseMax(place);
    }
    Coverage coverage{reachOf(low, high, stroke.radius, photo), {}};
    const PixelRange& range = coverage.range;
    if (range.right < range.left || range.bottom < range.top) return coverage;
    fillInside(stroke, coverage);
    for (std::size_t segment = 0; segment < segmentsOf(stroke); ++segment)
        drawSegment(stroke, segment, photo, coverage);
    return coverage;
}

} // namespace

void maskStrokes(Image& photo, const std::vector<PhotoStroke>& strokes) {
    if (photo.empty() || strokes.empty()) return;
    const auto width = static_cast<std::size_t>(photo.width);
    std::vector<float> kept(photo.pixels.size() / 4, 1.0F);
    for (const PhotoStroke& stroke : strokes) {
        if (stroke.path.empty()) continue;
        Coverage coverage = coverageOf(stroke, photo);
        const PixelRange& range = coverage.range;
        for (int y = range.top; y <= range.bottom; ++y)
            for (int x = range.left; x <= range.right; ++x) {
                float& keeps = kept[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)];
                const float covered = coverage.at(x, y);
                keeps = stroke.takesBack ? keeps + (1 - keeps) * covered : keeps * (1 - covered);
            }
    }
    tbb::parallel_for(std::size_t{0}, kept.size(), [&](std::size_t i) {
        std::uint8_t& alpha = photo.pixels[4 * i + 3];
        alpha = static_cast<std::uint8_t>(std::lround(static_cast<float>(alpha) * kept[i]));
    });
}

} // namespace esm
