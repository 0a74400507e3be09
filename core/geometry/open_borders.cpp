#include "core/geometry/open_borders.h"

#include "core/geometry/border_search.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace esm {

namespace {

// The middle of all distances: a few corners have nothing opposite, as those at the ends of a slit.
double middleOf(std::vector<double> distances) {
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    return *middle;
}

std::vector<double> gapsOf(const std::vector<BorderLoop>& loops,
                           const std::vector<Eigen::Vector3d>& vertices) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const BorderCorners corners(loops);
    const BorderSearch search(vertices, corners);
    std::vector<std::vector<double>> distances(loops.size());
    for (std::uint32_t i = 0; i < corners.size(); ++i) {
        const auto opposite = search.oppositeOf(i, infinite);
        distances[corners.loop[i]].push_back(opposite ? opposite->distance : infinite);
    }
    std::vector<double> gaps;
    gaps.reserve(distances.size());
    for (std::vector<double>& ofLoop : distances)
        gaps.push_back(middleOf(std::move(ofLoop)));
    return gaps;
}

} // namespace

std::vector<OpenBorder> openBordersOf(const TriangleMesh& mesh) {
    std::vector<BorderLoop> loops = bordersOf(mesh.triangles).loops;
    const std::vector<double> gaps = gapsOf(loops, mesh.vertices);
    std::vector<OpenBorder> borders;
    for (std::size_t i = 0; i < loops.size(); ++i) {
        const double length = lengthOf(loops[i], mesh.vertices);
        borders.push_back({std::move(loops[i]), length, gaps[i]});
    }
    std::stable_sort(borders.begin(), borders.end(),
                     [](const OpenBorder& a, const OpenBorder& b) { return a.loop.size() > b.loop.size(); });
    return borders;
}

std::size_t edgesOf(const std::vector<OpenBorder>& borders) {
    return std::accumulate(
        borders.begin(), borders.end(), std::size_t{0},
        [](std::size_t sum, const OpenBorder& border) { return sum + border.loop.size(); });
}

} // namespace esm
