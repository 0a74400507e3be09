#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace esm {

using Triangle = std::array<std::uint32_t, 3>;        ///< vertex indices, counter-clockwise seen from outside
using Edge = std::pair<std::uint32_t, std::uint32_t>; ///< vertex indices, the smaller first

/// Marks a vertex or triangle that has no number.
inline constexpr std::uint32_t noIndex = std::numeric_limits<std::uint32_t>::max();

/// Where a triangle's corners lie in a picture, by parts of its width and height: u to the right, v up, (0,
/// 0) its lower left corner.
using CornerCoordinates = std::array<Eigen::Vector2d, 3>;

/// An organ's surface. Immutable once built: held by `std::shared_ptr<const TriangleMesh>` and replaced
/// whole.
struct TriangleMesh {
    std::vector<Eigen::Vector3d> vertices; ///< m
    std::vector<Triangle> triangles;
    /// Per triangle, in the texture for which the surface was made (its own UVs); empty where it brought
    /// none.
    std::vector<CornerCoordinates> textureCoordinates = {};
};

/// The box that holds every point; empty (`isEmpty()`) without points.
Eigen::AlignedBox3d boundingBox(const std::vector<Eigen::Vector3d>& points);

/// Every edge once, in the order in which the triangles first use it.
std::vector<Edge> uniqueEdges(const std::vector<Triangle>& triangles);

/// Sum of the triangles' areas, m².
double surfaceArea(const TriangleMesh& mesh);

/// Volume enclosed by a closed, consistently oriented surface, m³; negative when it faces inwards.
double enclosedVolume(const TriangleMesh& mesh);

/// As long as twice the triangle's area, m².
Eigen::Vector3d areaNormal(const std::vector<Eigen::Vector3d>& vertices, const Triangle& triangle);

/// Six times the volume, m³, of the tetrahedron between a triangle and a point; positive when the triangle
/// faces away from the point.
double sixfoldVolume(const std::vector<Eigen::Vector3d>& vertices, const Triangle& triangle,
                     const Eigen::Vector3d& point);

/// Unit normals at the vertices, area-weighted. A vertex whose triangles have no area gets (0, 0, 1).
std::vector<Eigen::Vector3d> vertexNormals(const std::vector<Eigen::Vector3d>& positions,
                                           const std::vector<Triangle>& triangles);

/// Points without a finite position, triangles with a corner that does not exist, or without finite own
/// places where others have some.
std::vector<std::string> validate(const TriangleMesh& mesh);

} // namespace esm
