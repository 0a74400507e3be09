#include "core/texture/photo/outline_cover.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <opencv2/imgproc.hpp>
#include <tbb/parallel_for.h>

namespace esm {

namespace {

constexpr int linesPerRow = 8; ///< that are cut with the outline; the edge has as many levels

/// Where an outline passes a horizontal line, and whether it goes down there.
struct Crossing {
    double x;
    int turn;
};

/// A straight part of an outline.
struct OutlineLine {
    Eigen::Vector2d from, to;
};
using OutlineLines = std::vector<OutlineLine>;

std::vector<Crossing> crossingsAt(const OutlineLines& lines, double y) {
    std::vector<Crossing> crossings;
    for (const auto& [from, to] : lines) {
        if ((from.y() <= y) == (to.y() <= y)) continue;
        const double share = (y - from.y()) / (to.y() - from.y());
        crossings.push_back({from.x() + share * (to.x() - from.x()), from.y() <= y ? 1 : -1});
    }
    std::sort(crossings.begin(), crossings.end(),
              [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
    return crossings;
}

/// Adds a part of a line to the pixels that it covers, to those at its ends by their share.
void addSpan(double from, double to, std::vector<float>& row) {
    const auto width = static_cast<double>(row.size());
    from = std::clamp(from, 0.0, width);
    to = std::clamp(to, 0.0, width);
    for (auto x = static_cast<std::size_t>(from); x < row.size() && static_cast<double>(x) < to; ++x) {
        const auto place = static_cast<double>(x);
        row[x] += static_cast<float>((std::min(to, place + 1) - std::max(from, place)) / linesPerRow);
    }
}

OutlineLines outlineLines(const PhotoOutline& outline) {
    OutlineLines lines;
    lines.reserve(outline.size());
    for (std::size_t i = 0; i < outline.size(); ++i)
        lines.push_back({outline[i], outline[(i + 1) % outline.size()]});
    return lines;
}

/// Lines through each row are cut with the outline. Across them the cover is exact, so that only nearly level
/// edges have steps, of an eighth.
/// @param lines that pass through the row, and any others
std::vector<float> rowCover(const OutlineLines& lines, int width, int y) {
    std::vector<float> row(static_cast<std::size_t>(width), 0.0F);
    if (lines.empty()) return row;
    for (int line = 0; line < linesPerRow; ++line) {
        const std::vector<Crossing> crossings = crossingsAt(lines, y + (line + 0.5) / linesPerRow);
        int around = 0;
        for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
            around += crossings[i].turn;
            if (around != 0) addSpan(crossings[i].x, crossings[i + 1].x, row);
        }
    }
    for (float& cover : row)
        cover = std::min(cover, 1.0F);
    return row;
}

} // namespace

PhotoOutline simplified(const PhotoOutline& outline, double detail) {
    if (outline.size() < 3) return outline;
    std::vector<cv::Point2f> places, fewer;
    places.reserve(outline.size());
    for (const Eigen::Vector2d& place : outline)
        places.emplace_back(static_cast<float>(place.x()), static_cast<float>(place.y()));
    cv::approxPolyDP(places, fewer, detail, true);
    PhotoOutline simple;
    simple.reserve(fewer.size());
    for (const cv::Point2f& place : fewer)
        simple.emplace_back(place.x, place.y);
    return simple;
}

std::vector<float> rowCoverOf(const PhotoOutline& outline, int width, int y) {
    return rowCover(outlineLines(outline), width, y);
}

/// Each row looks only at the lines that pass through it.
std::vector<float> coverOf(const PhotoOutline& outline, int width, int firstRow, int endRow) {
    const auto rows = static_cast<std::size_t>(endRow - firstRow);
    std::vector<float> cover(static_cast<std::size_t>(width) * rows, 0.0F);
    if (outline.empty()) return cover;
    std::vector<OutlineLines> linesOfRows(rows);
    for (const OutlineLine& line : outlineLines(outline)) {
        const double top = std::min(line.from.y(), line.to.y()),
                     bottom = std::max(line.from.y(), line.to.y());
        if (!(bottom >= firstRow) || !(top < endRow)) continue;
        const int last = static_cast<int>(std::min(bottom, endRow - 1.0));
        for (int row = static_cast<int>(std::max(top, static_cast<double>(firstRow))); row <= last; ++row)
            linesOfRows[static_cast<std::size_t>(row - firstRow)].push_back(line);
    }
    tbb::parallel_for(std::size_t{0}, rows, [&](std::size_t i) {
        const std::vector<float> row = rowCover(linesOfRows[i], width, firstRow + static_cast<int>(i));
        std::copy(row.begin(), row.end(), cover.begin() + static_cast<std::ptrdiff_t>(i) * width);
    });
    return cover;
}

std::vector<float> coverOf(const PhotoOutline& outline, int width, int height) {
    return coverOf(outline, width, 0, height);
}

} // namespace esm
