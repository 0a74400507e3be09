#pragma once

#include "core/geometry/triangle_mesh.h"
#include "tests/support/flat_nets.h"

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <Eigen/SVD>

#include <algorithm>
#include <optional>
#include <set>

/// Pieces of curved surfaces, laid flat.
namespace esm::test {

struct FlatPatch {
    TriangleMesh mesh; ///< in the plane z = 0
    std::vector<std::uint32_t>
        vertices;   ///< of the surface; the one in the middle first, then as they were met
    double stretch; ///< of edges, the root of the mean square, as a share of their lengths
};

/// The triangles at each vertex.
inline std::vector<std::vector<std::uint32_t>> trianglesAt(const TriangleMesh& mesh) {
    std::vector<std::vector<std::uint32_t>> result(mesh.vertices.size());
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
        for (const std::uint32_t vertex : mesh.triangles[i])
            result[vertex].push_back(i);
    return result;
}

/// The `count` vertices that one reaches along the surface, always going to the nearest in space next.
inline std::vector<std::uint32_t> verticesAround(const TriangleMesh& mesh,
                                                 const std::vector<std::vector<std::uint32_t>>& at,
                                                 std::uint32_t middle, std::size_t count) {
    std::set<std::pair<double, std::uint32_t>> next{{0, middle}};
    std::vector<std::uint32_t> reached;
    std::set<std::uint32_t> met{middle};
    while (!next.empty() && reached.size() < count) {
        const std::uint32_t vertex = next.begin()->second;
        next.erase(next.begin());
        reached.push_back(vertex);
        for (const std::uint32_t triangle : at[vertex])
            for (const std::uint32_t other : mesh.triangles[triangle])
                if (met.insert(other).second)
                    next.insert({(mesh.vertices[other] - mesh.vertices[middle]).norm(), other});
    }
    return reached;
}

/// Lays a surface that was projected into the plane out as rigidly as possible (Sorkine and Alexa 2007,
/// Liu et al. 2008): triangles turn to where they lie, vertices then go where triangles want them.
inline void layOut(const TriangleMesh& surface, TriangleMesh& flat) {
    const auto count = static_cast<Eigen::Index>(flat.vertices.size());
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<std::array<Eigen::Vector2d, 3>> sides; // of each triangle in its own plane
    std::vector<std::array<double, 3>> weights;
    for (const Triangle& t : surface.triangles) {
        const Eigen::Vector3d normal = areaNormal(surface.vertices, t).normalized();
        const Eigen::Vector3d x = (surface.vertices[t[1]] - surface.vertices[t[0]]).normalized();
        const Eigen::Vector3d y = normal.cross(x);
        sides.emplace_back();
        weights.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) {
            const Eigen::Vector3d way = surface.vertices[t[(i + 1) % 3]] - surface.vertices[t[i]];
            sides.back()[i] = {way.dot(x), way.dot(y)};
            weights.back()[i] = 1 / way.squaredNorm();
            const auto a = static_cast<Eigen::Index>(t[i]), b = static_cast<Eigen::Index>(t[(i + 1) % 3]);
            for (const auto& [r, c, sign] : {std::tuple{a, a, 1}, {b, b, 1}, {a, b, -1}, {b, a, -1}})
                entries.emplace_back(r, c, sign * weights.back()[i]);
        }
    }
    entries.emplace_back(0, 0, 1); // holds the middle
    Eigen::SparseMatrix<double> matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    for (int round = 0; round < 60; ++round) {
        Eigen::MatrixX2d wanted = Eigen::MatrixX2d::Zero(count, 2);
        for (std::size_t t = 0; t < flat.triangles.size(); ++t) {
            const Triangle& corners = flat.triangles[t];
            Eigen::Matrix2d both = Eigen::Matrix2d::Zero();
            for (std::size_t i = 0; i < 3; ++i)
                both += weights[t][i] *
                        (flat.vertices[corners[(i + 1) % 3]] - flat.vertices[corners[i]]).head<2>() *
                        sides[t][i].transpose();
            const double angle = std::atan2(both(1, 0) - both(0, 1), both.trace());
            for (std::size_t i = 0; i < 3; ++i) {
                const Eigen::RowVector2d way =
                    weights[t][i] * (Eigen::Rotation2Dd(angle) * sides[t][i]).transpose();
                wanted.row(static_cast<Eigen::Index>(corners[(i + 1) % 3])) += way;
                wanted.row(static_cast<Eigen::Index>(corners[i])) -= way;
            }
        }
        const Eigen::MatrixX2d places = solver.solve(wanted);
        for (Eigen::Index i = 0; i < count; ++i)
            flat.vertices[static_cast<std::size_t>(i)].head<2>() = places.row(i).transpose();
    }
}

/// The piece of a surface around a vertex, laid flat; nothing where it is no disc that can be seen from one
/// side, or some triangle would be turned over.
inline std::optional<FlatPatch> flatPatch(const TriangleMesh& mesh,
                                          const std::vector<std::vector<std::uint32_t>>& at,
                                          std::uint32_t middle, std::size_t count) {
    FlatPatch patch{{}, verticesAround(mesh, at, middle, count), 0};
    std::vector<std::uint32_t> place(mesh.vertices.size(), noIndex);
    for (std::uint32_t i = 0; i < patch.vertices.size(); ++i)
        place[patch.vertices[i]] = i;
    TriangleMesh surface;
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    std::vector<std::uint32_t> triangles;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const Triangle& corners = mesh.triangles[t];
        const Triangle own{place[corners[0]], place[corners[1]], place[corners[2]]};
        if (std::count(own.begin(), own.end(), noIndex) > 0) continue;
        surface.triangles.push_back(own);
        normal += areaNormal(mesh.vertices, corners);
    }
    for (const std::uint32_t vertex : patch.vertices)
        surface.vertices.push_back(mesh.vertices[vertex]);
    normal.normalize();
    const Eigen::Vector3d x = normal.unitOrthogonal(), y = normal.cross(x);
    patch.mesh.triangles = surface.triangles;
    for (const Eigen::Vector3d& vertex : surface.vertices)
        patch.mesh.vertices.emplace_back(vertex.dot(x), vertex.dot(y), 0);
    std::set<std::uint32_t> used;
    for (const Triangle& t : patch.mesh.triangles) {
        used.insert(t.begin(), t.end());
        if (areaNormal(patch.mesh.vertices, t).z() <= 0) return std::nullopt;
    }
    if (used.size() != count) return std::nullopt;
    layOut(surface, patch.mesh);
    for (const Triangle& t : patch.mesh.triangles) {
        if (areaNormal(patch.mesh.vertices, t).z() <= 0) return std::nullopt;
        for (std::size_t i = 0; i < 3; ++i) {
            const double flat = (patch.mesh.vertices[t[(i + 1) % 3]] - patch.mesh.vertices[t[i]]).norm();
            const double length = (surface.vertices[t[(i + 1) % 3]] - surface.vertices[t[i]]).norm();
            patch.stretch += (flat / length - 1) * (flat / length - 1);
        }
    }
    patch.stretch = std::sqrt(patch.stretch / static_cast<double>(3 * patch.mesh.triangles.size()));
    return patch;
}

} // namespace esm::test
