#pragma once

#include "core/geometry/adjacency.h"
#include "core/geometry/triangle_mesh.h"

#include <cmath>
#include <random>

/// Flat sheets of triangles in the plane z = 0, of many kinds.
namespace esm::test {

/// Equilateral triangles of edge 1: rows of `columns` of them, every other row half an edge to the right.
inline TriangleMesh regularNet(std::uint32_t columns, std::uint32_t rows) {
    TriangleMesh mesh;
    const auto index = [=](std::uint32_t column, std::uint32_t row) { return row * (columns + 1) + column; };
    for (std::uint32_t row = 0; row <= rows; ++row)
        for (std::uint32_t column = 0; column <= columns; ++column)
            mesh.vertices.emplace_back(column + 0.5 * (row % 2), row * std::sqrt(0.75), 0);
    for (std::uint32_t row = 0; row < rows; ++row)
        for (std::uint32_t column = 0; column < columns; ++column) {
            const std::uint32_t a = index(column, row), b = index(column + 1, row);
            const std::uint32_t c = index(column, row + 1), d = index(column + 1, row + 1);
            mesh.triangles.push_back({a, b, row % 2 == 0 ? c : d});
            mesh.triangles.push_back(row % 2 == 0 ? Triangle{b, d, c} : Triangle{a, d, c});
        }
    return mesh;
}

/// Nearly square, of about so many nodes.
inline TriangleMesh regularNetOf(std::size_t nodes) {
    const double side = std::sqrt(static_cast<double>(nodes));
    return regularNet(static_cast<std::uint32_t>(std::lround(side * 0.93)) - 1,
                      static_cast<std::uint32_t>(std::lround(side / 0.93)) - 1);
}

inline std::vector<bool> isAtBorder(const TriangleMesh& mesh) {
    std::vector<bool> result(mesh.vertices.size(), false);
    forEachEdge(sidesByEdge(mesh.triangles), [&](auto first, auto last) {
        if (last - first == 1) result[first->edge.first] = result[first->edge.second] = true;
    });
    return result;
}

/// Every node within moved to anywhere in a disc of this radius around its place; the border stays.
inline TriangleMesh jittered(TriangleMesh mesh, double radius, std::uint32_t seed) {
    std::mt19937 random(seed);
    const auto upTo = [&](double most) { return most * static_cast<double>(random()) / 4294967296.0; };
    const std::vector<bool> stays = isAtBorder(mesh);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const double distance = radius * std::sqrt(upTo(1)), angle = upTo(2 * M_PI);
        if (!stays[i]) mesh.vertices[i] += distance * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0);
    }
    return mesh;
}

/// Edges `ratio` times as long at the right end as at the left: the plane's exponential keeps the triangles'
/// shapes and bends their rows into arcs.
inline TriangleMesh graded(TriangleMesh mesh, double ratio) {
    const double rate = std::log(ratio) / boundingBox(mesh.vertices).sizes().x();
    for (Eigen::Vector3d& vertex : mesh.vertices) {
        const double radius = std::exp(rate * vertex.x()) / rate;
        vertex = radius * Eigen::Vector3d(std::cos(rate * vertex.y()), std::sin(rate * vertex.y()), 0);
    }
    return mesh;
}

/// Triangles drawn out along x.
inline TriangleMesh drawnOut(TriangleMesh mesh, double ratio) {
    for (Eigen::Vector3d& vertex : mesh.vertices)
        vertex.x() *= ratio;
    return mesh;
}

} // namespace esm::test
