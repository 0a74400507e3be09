#pragma once

#include "core/geometry/triangle_mesh.h"

#include <cmath>

/// A closed liver-like surface with triangles of many shapes: a lumpy flattened sphere, about 0.2 m wide, of
/// 2 · rings · segments triangles or a little less.
inline esm::TriangleMesh lumpySurface(int rings, int segments) {
    esm::TriangleMesh mesh;
    const auto point = [](double polar, double around) {
        const double radius = 0.1 * (1 + 0.2 * std::sin(3 * polar + around) * std::cos(2 * around));
        return Eigen::Vector3d(radius * std::sin(polar) * std::cos(around),
                               0.6 * radius * std::sin(polar) * std::sin(around), radius * std::cos(polar));
    };
    mesh.vertices.push_back(point(0, 0));
    for (int ring = 1; ring < rings; ++ring)
        for (int segment = 0; segment < segments; ++segment)
            mesh.vertices.push_back(point(M_PI * ring / rings, 2 * M_PI * segment / segments));
    mesh.vertices.push_back(point(M_PI, 0));
    const auto index = [&](int ring, int segment) {
        if (ring == 0) return std::uint32_t{0};
        if (ring == rings) return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
        return static_cast<std::uint32_t>(1 + (ring - 1) * segments + segment % segments);
    };
    for (int ring = 0; ring < rings; ++ring) {
        for (int segment = 0; segment < segments; ++segment) {
            const std::uint32_t a = index(ring, segment), b = index(ring + 1, segment);
            const std::uint32_t c = index(ring + 1, segment + 1), d = index(ring, segment + 1);
            if (b != c) mesh.triangles.push_back({a, b, c});
            if (a != d) mesh.triangles.push_back({a, c, d});
        }
    }
    return mesh;
}

/// A square in the plane z = 0, centred on the origin and seen from +z, of 2 · cells² triangles.
inline esm::TriangleMesh flatSquare(double width, int cells) {
    esm::TriangleMesh mesh;
    for (int row = 0; row <= cells; ++row)
        for (int column = 0; column <= cells; ++column)
            mesh.vertices.emplace_back(width * (column / double(cells) - 0.5),
                                       width * (row / double(cells) - 0.5), 0);
    const auto index = [&](int row, int column) {
        return static_cast<std::uint32_t>(row * (cells + 1) + column);
    };
    for (int row = 0; row < cells; ++row) {
        for (int column = 0; column < cells; ++column) {
            mesh.triangles.push_back(
                {index(row, column), index(row, column + 1), index(row + 1, column + 1)});
            mesh.triangles.push_back(
                {index(row, column), index(row + 1, column + 1), index(row + 1, column)});
        }
    }
    return mesh;
}

/// A flat square whose own picture is stretched, up to 2.6 times as much at one side as at the other, and
/// slanted, so that no triangle is similar to its shape there.
inline esm::TriangleMesh stretchedSheet(double width, int cells) {
    esm::TriangleMesh mesh = flatSquare(width, cells);
    const auto placeOf = [&](const Eigen::Vector3d& vertex) {
        const double x = vertex.x() / width + 0.5, y = vertex.y() / width + 0.5;
        return Eigen::Vector2d(0.05 + 0.6 * x * (1 + x) / 2 + 0.2 * y, 0.1 + 0.8 * y);
    };
    for (const esm::Triangle& triangle : mesh.triangles) {
        esm::CornerCoordinates& places = mesh.textureCoordinates.emplace_back();
        for (std::size_t i = 0; i < 3; ++i)
            places[i] = placeOf(mesh.vertices[triangle[i]]);
    }
    return mesh;
}
