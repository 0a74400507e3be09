#include "core/geometry/triangle_mesh.h"

#include "core/geometry/sorted_by_vertex.h"
#include "core/support/offenders.h"

#include <algorithm>

namespace esm {

Eigen::AlignedBox3d boundingBox(const std::vector<Eigen::Vector3d>& points) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& point : points)
        box.extend(point);
    return box;
}

// In the order of the triangles and not in that of the numbers: springs that are made of neighbouring
// triangles then lie close together in memory. Repeats are found by counting (sorted_by_vertex.h), in time
// linear in the triangles.
std::vector<Edge> uniqueEdges(const std::vector<Triangle>& triangles) {
    std::vector<Edge> edges;
    edges.reserve(3 * triangles.size());
    for (const Triangle& triangle : triangles)
        for (std::size_t corner = 0; corner < 3; ++corner)
            edges.push_back(std::minmax({triangle[corner], triangle[(corner + 1) % 3]}));
    const std::vector<bool> isRepeated = repeats(edges);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < edges.size(); ++i)
        if (!isRepeated[i]) edges[kept++] = edges[i];
    edges.resize(kept);
    edges.shrink_to_fit();
    return edges;
}

double surfaceArea(const TriangleMesh& mesh) {
    double twice = 0;
    for (const Triangle& t : mesh.triangles)
        twice += areaNormal(mesh.vertices, t).norm();
    return twice / 2;
}

// Sum of the tetrahedra from one point to each triangle, positive or negative as it faces away or not (the
// divergence theorem). Of a closed surface any point gives the same; one in the middle gives small
// tetrahedra, so that a surface far from the origin does not lose its volume in the difference of large ones.
double enclosedVolume(const TriangleMesh& mesh) {
    if (mesh.vertices.empty()) return 0;
    const Eigen::Vector3d origin = boundingBox(mesh.vertices).center();
    double sixfold = 0;
    for (const Triangle& triangle : mesh.triangles)
        sixfold += sixfoldVolume(mesh.vertices, triangle, origin);
    return sixfold / 6;
}

Eigen::Vector3d areaNormal(const std::vector<Eigen::Vector3d>& vertices, const Triangle& triangle) {
    const Eigen::Vector3d& a = vertices[triangle[0]];
    return (vertices[triangle[1]] - a).cross(vertices[triangle[2]] - a);
}

double sixfoldVolume(const std::vector<Eigen::Vector3d>& vertices, const Triangle& triangle,
                     const Eigen::Vector3d& point) {
    const auto& [a, b, c] = triangle;
    return (vertices[a] - point).dot((vertices[b] - point).cross(vertices[c] - point));
}

// The cross product is as long as twice the area, so that its plain sum weighs by area. Slivers, whose own
// normals are uncertain, then count next to nothing.
std::vector<Eigen::Vector3d> vertexNormals(const std::vector<Eigen::Vector3d>& positions,
                                           const std::vector<Triangle>& triangles) {
    std::vector<Eigen::Vector3d> normals(positions.size(), Eigen::Vector3d::Zero());
    for (const Triangle& t : triangles) {
        const Eigen::Vector3d normal = areaNormal(positions, t);
        for (const std::uint32_t vertex : t)
            normals[vertex] += normal;
    }
    for (Eigen::Vector3d& normal : normals) {
        const double length = normal.norm();
        normal = length > 0 ? Eigen::Vector3d(normal / length) : Eigen::Vector3d::UnitZ();
    }
    return normals;
}

std::vector<std::string> validate(const TriangleMesh& mesh) {
    std::vector<std::string> problems;
    reportOffenders(
        problems, "mesh point", "without a finite position",
        placesWhere(mesh.vertices.size(), [&](std::size_t i) { return !mesh.vertices[i].allFinite(); }));
    reportOffenders(problems, "triangle", "with a corner that does not exist",
                    placesWhere(mesh.triangles.size(), [&](std::size_t i) {
                        const Triangle& triangle = mesh.triangles[i];
                        return *std::max_element(triangle.begin(), triangle.end()) >= mesh.vertices.size();
                    }));
    if (!mesh.textureCoordinates.empty() && mesh.textureCoordinates.size() != mesh.triangles.size())
        problems.push_back("the mesh has places in its own texture for " +
                           std::to_string(mesh.textureCoordinates.size()) + " of " +
                           std::to_string(mesh.triangles.size()) + " triangles");
    reportOffenders(problems, "triangle", "without a finite place in the mesh's own texture",
                    placesWhere(mesh.textureCoordinates.size(), [&](std::size_t i) {
                        return !std::all_of(mesh.textureCoordinates[i].begin(),
                                            mesh.textureCoordinates[i].end(),
                                            [](const Eigen::Vector2d& place) { return place.allFinite(); });
                    }));
    return problems;
}

} // namespace esm
