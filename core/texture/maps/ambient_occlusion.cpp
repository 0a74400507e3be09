#include "core/texture/maps/ambient_occlusion.h"

#include "core/support/parallel_steps.h"
#include "core/surface/surface_query.h"
#include "core/texture/layers/patch_scan.h"
#include "core/texture/layers/texel_owners.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace esm {

namespace {

constexpr std::size_t rayCount = 128;
constexpr double pointsPerReach = 6; ///< how densely a large triangle is asked
constexpr double mostPoints = 400'000;

/// Directions about z, more of them the steeper they are, as light counts (Hammersley's points on the disc).
std::array<Eigen::Vector3d, rayCount> directionsAboutZ() {
    std::array<Eigen::Vector3d, rayCount> directions;
    for (std::size_t i = 0; i < rayCount; ++i) {
        double mirrored = 0; // the digits of i in the base of two, behind the point
        double digit = 0.5;
        for (std::size_t rest = i; rest > 0; rest /= 2, digit /= 2)
            mirrored += static_cast<double>(rest % 2) * digit;
        const double squared = (static_cast<double>(i) + 0.5) / rayCount, turn = 2 * M_PI * mirrored;
        directions[i] = {std::sqrt(squared) * std::cos(turn), std::sqrt(squared) * std::sin(turn),
                         std::sqrt(1 - squared)};
    }
    return directions;
}

/// Asks from a place how open it is.
class Openness {
public:
    Openness(const TriangleMesh& mesh, double reach)
        : m_query(mesh.vertices, mesh.triangles), m_reach(reach),
          m_start(std::max(1e-3 * reach, 1e-5 * boundingBox(mesh.vertices).diagonal().norm())),
          m_directions(directionsAboutZ()) {}

    /// @param outward any length; of length 0 nothing can be said, and the place is open
    float at(const Eigen::Vector3d& place, const Eigen::Vector3d& outward) const {
        if (!(outward.norm() > 0)) return 1;
        const Eigen::Vector3d normal = outward.normalized();
        const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), normal);
        double open = 0;
        for (const Eigen::Vector3d& direction : m_directions) {
            const auto hit = m_query.firstHit({place + m_start * normal, turn * direction});
            const double taken = hit ? std::max(0.0, 1 - hit->distance / m_reach) : 0;
            open += 1 - taken * taken;
        }
        return static_cast<float>(open / rayCount);
    }

private:
    SurfaceQuery m_query;
    double m_reach;
    double m_start; ///< m above the surface, so that no ray meets what it starts from
    std::array<Eigen::Vector3d, rayCount> m_directions;
};

/// Points of a surface: its vertices, and where triangles are large others between them, `parts` along each
/// side. Neighbours share those of their corners and sides, so that no edge shows.
struct SurfacePoints {
    int parts = 1;
    std::vector<Eigen::Vector3d> places, normals; ///< normals of any length
    std::vector<std::uint32_t> ofTriangles; ///< perTriangle() of each: (i, j), i + j ≤ parts, row by row of j

    std::size_t perTriangle() const {
        const auto along = static_cast<std::size_t>(parts);
        return (along + 1) * (along + 2) / 2;
    }
    std::uint32_t at(std::uint32_t triangle, int i, int j) const {
        const int inTriangle = j * (parts + 1) - j * (j - 1) / 2 + i;
        return ofTriangles[triangle * perTriangle() + static_cast<std::size_t>(inTriangle)];
    }
};

class PointMaker {
public:
    PointMaker(const TriangleMesh& mesh, int parts)
        : m_mesh(mesh), m_points{parts, mesh.vertices, vertexNormals(mesh.vertices, mesh.triangles), {}} {}

    SurfacePoints make() && {
        m_points.ofTriangles.reserve(m_mesh.triangles.size() * m_points.perTriangle());
        for (const Triangle& triangle : m_mesh.triangles)
            divide(triangle);
        return std::move(m_points);
    }

private:
    void divide(const Triangle& triangle) {
        const int parts = m_points.parts;
        const auto [a, b, c] = triangle;
        const Eigen::Vector3d normal = areaNormal(m_mesh.vertices, triangle).normalized();
        for (int j = 0; j <= parts; ++j)
            for (int i = 0; i + j <= parts; ++i) {
                const std::uint32_t point = j == 0           ? onSide(a, b, i)
                                            : i == 0         ? onSide(a, c, j)
                                            : i + j == parts ? onSide(b, c, j)
                                                             : inside(triangle, i, j);
                m_points.ofTriangles.push_back(point);
                if (point >= m_mesh.vertices.size()) m_points.normals[point] += normal;
            }
    }

    std::uint32_t onSide(std::uint32_t from, std::uint32_t to, int step) {
        if (step == 0) return from;
        if (step == m_points.parts) return to;
        if (from > to) return onSide(to, from, m_points.parts - step);
        const auto next = static_cast<std::uint32_t>(m_points.places.size());
        const auto [known, isNew] = m_firstOfSides.try_emplace({from, to}, next);
        for (int made = 1; isNew && made < m_points.parts; ++made) {
            const double share = double(made) / m_points.parts;
            add((1 - share) * m_mesh.vertices[from] + share * m_mesh.vertices[to]);
        }
        return known->second + static_cast<std::uint32_t>(step - 1);
    }

    std::uint32_t inside(const Triangle& triangle, int i, int j) {
        const double second = double(i) / m_points.parts, third = double(j) / m_points.parts;
        return add((1 - second - third) * m_mesh.vertices[triangle[0]] +
                   second * m_mesh.vertices[triangle[1]] + third * m_mesh.vertices[triangle[2]]);
    }

    std::uint32_t add(const Eigen::Vector3d& place) {
        m_points.places.push_back(place);
        m_points.normals.emplace_back(Eigen::Vector3d::Zero());
        return static_cast<std::uint32_t>(m_points.places.size() - 1);
    }

    const TriangleMesh& m_mesh;
    SurfacePoints m_points;
    std::map<Edge, std::uint32_t> m_firstOfSides;
};

/// As many along each side as the longest asks for and the number of all points allows.
int partsOf(const TriangleMesh& mesh, double reach) {
    double longest = 0;
    for (const Triangle& triangle : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i)
            longest =
                std::max(longest, (mesh.vertices[triangle[i]] - mesh.vertices[triangle[(i + 1) % 3]]).norm());
    const double wanted = std::ceil(longest * pointsPerReach / reach);
    const double affordable = std::sqrt(2.0 * mostPoints / static_cast<double>(mesh.triangles.size()));
    return static_cast<int>(std::max(1.0, std::min(wanted, affordable)));
}

/// Of the points, 0 to 1.
std::vector<float> opennessOf(const SurfacePoints& points, const Openness& openness,
                              const Progress& progress) {
    std::vector<float> values(points.places.size());
    forEachInBlocks(values.size(), 64, progress,
                    [&](std::size_t i) { values[i] = openness.at(points.places[i], points.normals[i]); });
    return values;
}

/// Linear between the points. @param weights of the triangle's corners
double interpolated(const SurfacePoints& points, const std::vector<float>& values, std::uint32_t triangle,
                    const Eigen::Vector3d& weights) {
    const double x = std::clamp(weights[1], 0.0, 1.0) * points.parts;
    const double y = std::clamp(weights[2] * points.parts, 0.0, points.parts - x);
    const int i = std::min(static_cast<int>(x), points.parts - 1);
    const int j = std::min(static_cast<int>(y), points.parts - 1 - i);
    const double right = x - i, up = y - j;
    const auto value = [&](int column, int row) { return double{values[points.at(triangle, column, row)]}; };
    if (right + up <= 1 || i + j + 2 > points.parts)
        return value(i, j) * (1 - right - up) + value(i + 1, j) * right + value(i, j + 1) * up;
    return value(i + 1, j + 1) * (right + up - 1) + value(i, j + 1) * (1 - right) +
           value(i + 1, j) * (1 - up);
}

} // namespace

/// Rays are cast from the vertices and, in large triangles, from points between them, since what stands
/// around changes slowly from place to place; a ray for every texel would take a hundred times as long.
std::vector<Image> occlusionPages(const TriangleMesh& mesh, const Atlas& atlas, double reach,
                                  const Progress& progress) {
    ProgressParts parts(progress);
    reportProgress(progress, 0);
    const SurfacePoints points = PointMaker(mesh, partsOf(mesh, reach)).make();
    const std::vector<float> values = opennessOf(points, Openness(mesh, reach), parts.next(0.7));
    const TexelOwners owners(mesh, atlas, parts.next(0.15));
    const int size = atlas.options.size;
    const auto bytes = 4 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
    std::vector<Image> pages(static_cast<std::size_t>(atlas.options.pages),
                             Image{size, size, std::vector<std::uint8_t>(bytes, 255)});
    forEachInParallel(owners.strips().size(), parts.rest(), [&](std::size_t i) {
        const OwnedStrip& strip = owners.strips()[i];
        Image& page = pages[static_cast<std::size_t>(strip.page)];
        for (const TexelSpan& span : strip.spans) {
            const PatchScan scan(atlas.corners[span.triangle]);
            for (int x = span.first; x < span.end; ++x) {
                const double open =
                    interpolated(points, values, span.triangle, scan.texel(x, span.row).nearest);
                std::fill_n(page.at(x, span.row), 3, static_cast<std::uint8_t>(std::lround(255 * open)));
            }
        }
    });
    reportProgress(progress, 1);
    return pages;
}

} // namespace esm
