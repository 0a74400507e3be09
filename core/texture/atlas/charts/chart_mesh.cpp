#include "core/texture/atlas/charts/chart_mesh.h"

#include "core/geometry/disjoint_sets.h"

#include <algorithm>
#include <utility>

namespace esm {

namespace {

std::uint32_t cornerOf(const Triangle& triangle, std::uint32_t vertex) {
    return static_cast<std::uint32_t>(std::find(triangle.begin(), triangle.end(), vertex) - triangle.begin());
}

/// Corners that triangles share at a common edge, joined. A corner's number is three times its triangle's,
/// and its place there.
DisjointSets joinedCorners(const TriangleMesh& surface, const std::vector<Triangle>& across,
                           const std::vector<std::uint32_t>& triangles) {
    DisjointSets corners(3 * triangles.size());
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        const Triangle& own = surface.triangles[triangles[i]];
        for (std::uint32_t side = 0; side < 3; ++side) {
            const std::uint32_t next = across[i][side];
            if (next == noIndex) continue;
            const Triangle& other = surface.triangles[triangles[next]];
            for (const std::uint32_t corner : {side, (side + 1) % 3})
                corners.join(3 * i + corner, 3 * next + cornerOf(other, own[corner]));
        }
    }
    return corners;
}

/// Each vertex has one side of the border that begins there, since what touches it is one fan of triangles.
std::vector<std::vector<std::uint32_t>> chartBorders(const ChartMesh& chart,
                                                     const std::vector<Triangle>& across) {
    std::vector<std::uint32_t> after(chart.vertices.size(), noIndex);
    for (std::size_t i = 0; i < across.size(); ++i)
        for (std::size_t side = 0; side < 3; ++side)
            if (across[i][side] == noIndex) after[chart.corners[i][side]] = chart.corners[i][(side + 1) % 3];
    std::vector<std::vector<std::uint32_t>> borders;
    for (std::uint32_t start = 0; start < after.size(); ++start) {
        if (after[start] == noIndex) continue;
        std::vector<std::uint32_t>& border = borders.emplace_back();
        for (std::uint32_t vertex = start; after[vertex] != noIndex;) {
            border.push_back(vertex);
            vertex = std::exchange(after[vertex], noIndex);
        }
    }
    return borders;
}

} // namespace

// A piece in one part is a disc where vertices − edges + triangles is 1, as Euler found, and it has one
// border: a ring has two, a closed surface none.
ChartMesh chartMesh(const TriangleMesh& surface, const std::vector<Triangle>& across,
                    std::vector<std::uint32_t> triangles) {
    ChartMesh chart;
    DisjointSets joined = joinedCorners(surface, across, triangles);
    std::vector<std::uint32_t> numbers(3 * triangles.size(), noIndex);
    chart.corners.resize(triangles.size());
    for (std::uint32_t i = 0; i < 3 * triangles.size(); ++i) {
        std::uint32_t& number = numbers[joined.lowest(i)];
        if (number == noIndex) {
            number = static_cast<std::uint32_t>(chart.vertices.size());
            chart.vertices.push_back(surface.vertices[surface.triangles[triangles[i / 3]][i % 3]]);
        }
        chart.corners[i / 3][i % 3] = number;
    }
    chart.triangles = std::move(triangles);
    chart.borders = chartBorders(chart, across);
    std::size_t sides = 3 * chart.triangles.size(); // inner edges twice
    for (const auto& border : chart.borders)
        sides += border.size();
    chart.isDisc =
        chart.borders.size() == 1 && chart.vertices.size() + chart.triangles.size() == sides / 2 + 1;
    return chart;
}

} // namespace esm
