#include "core/texture/atlas/own_layout.h"

#include "core/support/errors.h"
#include "core/support/offenders.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {

namespace {

/// Places a side at which overlaps are looked for: as many as a usual page has texels.
constexpr int gridSize = 2048;
/// Of the area that triangles cover, the part that may be covered twice; borders rounded to the digits of a
/// text file overlap by less.
constexpr double mostOverlap = 1e-3;
/// A place this far beyond the picture, in parts of it, is on its border.
constexpr double borderTolerance = 1e-6;
/// Of a triangle's longest side squared, an area that is none.
constexpr double flatShare = 1e-10;

double doubledArea(const CornerCoordinates& places) {
    const Eigen::Vector2d a = places[1] - places[0], b = places[2] - places[0];
    return a.x() * b.y() - a.y() * b.x();
}

bool isWithoutArea(const CornerCoordinates& places) {
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i)
        longest = std::max(longest, (places[(i + 1) % 3] - places[i]).squaredNorm());
    return !(std::abs(doubledArea(places)) > flatShare * longest);
}

bool leavesPicture(const CornerCoordinates& places) {
    return std::any_of(places.begin(), places.end(), [](const Eigen::Vector2d& place) {
        return !(place.minCoeff() >= -borderTolerance && place.maxCoeff() <= 1 + borderTolerance);
    });
}

/// The part of a line of height y that lies in a triangle; turned round where there is none.
std::pair<double, double> spanAt(const CornerCoordinates& places, double y) {
    std::pair<double, double> span{std::numeric_limits<double>::infinity(),
                                   -std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector2d &from = places[i], &to = places[(i + 1) % 3];
        if ((from.y() > y) == (to.y() > y)) continue;
        const double x = from.x() + (y - from.y()) / (to.y() - from.y()) * (to.x() - from.x());
        span.first = std::min(span.first, x);
        span.second = std::max(span.second, x);
    }
    return span;
}

struct Overlap {
    std::size_t covered = 0, again = 0;  ///< places of the grid, and those of them in a second triangle
    std::uint32_t first = 0, second = 0; ///< two triangles that overlap, where any do
    /// Of all that triangles cover, one after the other.
    double share() const {
        return again > 0 ? static_cast<double>(again) / static_cast<double>(covered + again) : 0;
    }
};

/// Asks at the middle of every cell of a grid which triangles lie there. Cheaper than to cut triangles with
/// each other, and as exact as painting needs: what overlaps between the places of the grid is less than a
/// texel.
Overlap overlapOf(const std::vector<CornerCoordinates>& triangles) {
    constexpr double edge = 1e-6; // of a cell: neighbours that meet at a place do not overlap there
    std::vector<std::uint32_t> owners(std::size_t{gridSize} * gridSize, noIndex);
    Overlap overlap;
    for (std::uint32_t triangle = 0; triangle < triangles.size(); ++triangle) {
        CornerCoordinates places = triangles[triangle];
        for (Eigen::Vector2d& place : places)
            place *= gridSize;
        const auto [low, high] = std::minmax({places[0].y(), places[1].y(), places[2].y()});
        const int end = std::min(gridSize, static_cast<int>(std::ceil(high)));
        for (int y = std::max(0, static_cast<int>(low)); y < end; ++y) {
            const auto [left, right] = spanAt(places, y + 0.5);
            if (!(right - left > 2 * edge)) continue;
            const int last = std::min(gridSize - 1, static_cast<int>(std::floor(right - edge - 0.5)));
            for (int x = std::max(0, static_cast<int>(std::ceil(left + edge - 0.5))); x <= last; ++x) {
                std::uint32_t& owner =
                    owners[static_cast<std::size_t>(y) * gridSize + static_cast<std::size_t>(x)];
                if (owner == noIndex) {
                    owner = triangle;
                    ++overlap.covered;
                } else if (overlap.again++ == 0) {
                    overlap.first = owner;
                    overlap.second = triangle;
                }
            }
        }
    }
    return overlap;
}

/// With one digit behind the point.
std::string rounded(double value) {
    std::string text = std::to_string(std::round(10 * value) / 10);
    return text.substr(0, text.find('.') + 2);
}

void reportOverlap(std::vector<std::string>& problems, const std::vector<CornerCoordinates>& places) {
    const Overlap overlap = overlapOf(places);
    if (overlap.share() <= mostOverlap) return;
    problems.push_back("triangles lie over each other on " + rounded(100 * overlap.share()) +
                       " % of the area that they cover, such as triangles " + std::to_string(overlap.first) +
                       " and " + std::to_string(overlap.second) +
                       ": what is painted on one would show on both");
}

double coveredArea(const std::vector<CornerCoordinates>& places) {
    double doubled = 0;
    for (const CornerCoordinates& triangle : places)
        doubled += std::abs(doubledArea(triangle));
    return doubled / 2;
}

} // namespace

std::vector<std::string> ownLayoutProblems(const TriangleMesh& mesh) {
    const std::vector<CornerCoordinates>& places = mesh.textureCoordinates;
    if (places.empty()) return {"the surface brought no texture coordinates of its own"};
    std::vector<std::string> problems;
    reportOffenders(problems, "triangle", "whose texture coordinates leave the picture (0 to 1)",
                    placesWhere(places.size(), [&](std::size_t i) { return leavesPicture(places[i]); }));
    if (std::all_of(places.begin(), places.end(), isWithoutArea))
        problems.emplace_back("its texture coordinates give no triangle an area");
    if (!problems.empty()) return problems;
    // What covers more than the picture overlaps for certain; what does not is soon looked through.
    if (const double covered = coveredArea(places); covered > 1 + mostOverlap)
        problems.push_back("triangles lie over each other: together they cover " + rounded(covered) +
                           " times the picture, and what is painted on one would show on others");
    else
        reportOverlap(problems, places);
    return problems;
}

std::vector<std::string> ownLayoutWarnings(const TriangleMesh& mesh) {
    const std::vector<CornerCoordinates>& places = mesh.textureCoordinates;
    double turned = 0; // area that is the right way round, less the rest
    for (const CornerCoordinates& triangle : places)
        turned += doubledArea(triangle);
    // A layout that is mirrored as a whole is as good as any; who looks at the page sees it at once.
    const double usual = turned < 0 ? -1 : 1;
    std::vector<std::string> warnings;
    reportOffenders(warnings, "triangle", "mirrored against the others in the mesh's own layout",
                    placesWhere(places.size(), [&](std::size_t i) {
                        return !isWithoutArea(places[i]) && usual * doubledArea(places[i]) < 0;
                    }));
    reportOffenders(warnings, "triangle",
                    "without an area in the mesh's own layout, where one colour alone shows",
                    placesWhere(places.size(), [&](std::size_t i) { return isWithoutArea(places[i]); }));
    return warnings;
}

Atlas ownLayout(const TriangleMesh& mesh, const AtlasOptions& options) {
    if (options.pages != 1 || options.texelsPerMetre > 0)
        throw InvalidModel(
            "the mesh's own layout takes one page and has a density of its own; ask for neither "
            "pages nor texels per metre");
    if (std::vector<std::string> problems = ownLayoutProblems(mesh); !problems.empty())
        throw InvalidModel(std::move(problems));
    Atlas atlas;
    atlas.options = options;
    atlas.page.assign(mesh.triangles.size(), 0);
    atlas.corners.reserve(mesh.textureCoordinates.size());
    for (const CornerCoordinates& places : mesh.textureCoordinates) {
        auto& corners = atlas.corners.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) {
            const Eigen::Vector2d inside = places[i].cwiseMax(0).cwiseMin(1);
            corners[i] = options.size * Eigen::Vector2d(inside.x(), 1 - inside.y());
        }
    }
    atlas.utilisation = coveredArea(mesh.textureCoordinates);
    atlas.texelsPerMetre = options.size * std::sqrt(atlas.utilisation / surfaceArea(mesh));
    return atlas;
}

} // namespace esm
