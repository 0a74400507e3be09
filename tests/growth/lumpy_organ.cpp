#include "tests/growth/lumpy_organ.h"

#include "core/geometry/triangle_mesh.h"
#include "tests/support/tissue_models.h"

#include <cmath>
#include <fstream>
#include <stdexcept>

namespace growth {

namespace {

struct Part {
    Eigen::Vector3d centre;
    double radius; ///< m
    int rows;      ///< of triangles on each face of the icosahedron it is made from
};

/// The same for places that are equal but for rounding, so that faces meet.
Eigen::Vector3d withoutRounding(const Eigen::Vector3d& place) {
    return (place * 1e9).array().round() * 1e-9;
}

/// A direction moved aside by part of a triangle's width, no two alike.
Eigen::Vector3d shaken(const Eigen::Vector3d& direction, double width) {
    const Eigen::Vector3d seed = 12345.678 * direction;
    const Eigen::Vector3d aside(std::sin(seed.y() + 3 * seed.z()), std::sin(seed.z() + 5 * seed.x()),
                                std::sin(seed.x() + 7 * seed.y()));
    return (direction + 0.3 * width * aside).normalized();
}

Eigen::Vector3f onOrgan(const Part& part, const Eigen::Vector3d& place) {
    const Eigen::Vector3d p = shaken(withoutRounding(place.normalized()), 1.2 / part.rows);
    const double lumps = std::sin(3 * p.x() + 1) * std::cos(4 * p.y()) +
                         0.4 * std::sin(7 * p.z() + 2 * p.x()) + 0.15 * std::sin(17 * p.y() + 11 * p.z());
    const Eigen::Vector3d stretched(1.6 * p.x(), p.y(), p.z());
    return (part.centre + part.radius * (1 + 0.12 * lumps) * stretched).cast<float>();
}

struct Surface {
    std::vector<Eigen::Vector3f> vertices;
    std::vector<esm::Triangle> triangles;
};

/// One face of the icosahedron, in rows from its first corner to the side across.
void addFace(const Part& part, const std::array<Eigen::Vector3d, 3>& corners, Surface& surface) {
    const auto base = static_cast<std::uint32_t>(surface.vertices.size());
    for (int row = 0; row <= part.rows; ++row)
        for (int i = 0; i <= row; ++i)
            surface.vertices.push_back(
                onOrgan(part, (part.rows - row) * corners[0] + (row - i) * corners[1] + i * corners[2]));
    const auto at = [base](int row, int i) {
        return base + static_cast<std::uint32_t>(row * (row + 1) / 2 + i);
    };
    for (int row = 0; row < part.rows; ++row)
        for (int i = 0; i <= row; ++i) {
            surface.triangles.push_back({at(row, i), at(row + 1, i), at(row + 1, i + 1)});
            if (i < row) surface.triangles.push_back({at(row, i), at(row + 1, i + 1), at(row, i + 1)});
        }
}

void addPart(const Part& part, Surface& surface) {
    const esm::TriangleMesh icosahedron = tissue::sphereMesh(0, 1);
    for (const auto& [a, b, c] : icosahedron.triangles)
        addFace(part, {icosahedron.vertices[a], icosahedron.vertices[b], icosahedron.vertices[c]}, surface);
}

int rowsFor(double triangles) {
    return static_cast<int>(std::lround(std::sqrt(triangles / 20)));
}

void write(const Surface& surface, const std::filesystem::path& file) {
    std::ofstream stream(file, std::ios::binary);
    stream << "ply\nformat binary_little_endian 1.0\nelement vertex " << surface.vertices.size()
           << "\nproperty float x\nproperty float y\nproperty float z\nelement face "
           << surface.triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const Eigen::Vector3f& vertex : surface.vertices)
        stream.write(reinterpret_cast<const char*>(vertex.data()), 3 * sizeof(float));
    for (const esm::Triangle& triangle : surface.triangles) {
        stream.put(3);
        stream.write(reinterpret_cast<const char*>(triangle.data()), 3 * sizeof(std::uint32_t));
    }
    if (!stream.flush()) throw std::runtime_error("cannot write " + file.string());
}

} // namespace

std::size_t writeLumpyOrgan(const std::filesystem::path& file, std::size_t triangles) {
    const auto wanted = static_cast<double>(triangles);
    Surface surface;
    addPart({{0, 0, 0}, 0.08, rowsFor(0.9 * wanted)}, surface);
    addPart({{0.25, 0, 0}, 0.03, rowsFor(0.1 * wanted)}, surface);
    write(surface, file);
    return surface.triangles.size();
}

} // namespace growth
