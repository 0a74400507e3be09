#include "core/texture/layers/lit_triangles.h"

#include "core/geometry/adjacency.h"
#include "tests/support/test_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

using namespace esm;

namespace {

constexpr PhotoSize photo{200, 160};
constexpr double tolerance = 1e-5; // m

/// Whether the straight way between two points meets a triangle, from either side, by Cramer's rule.
bool meets(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
           const std::array<Eigen::Vector3d, 3>& triangle) {
    Eigen::Matrix3d system;
    system << from - to, triangle[1] - triangle[0], triangle[2] - triangle[0];
    const double whole = system.determinant();
    if (whole == 0) return false;
    const auto share = [&](Eigen::Index column) {
        Eigen::Matrix3d replaced = system;
        replaced.col(column) = from - triangle[0];
        return replaced.determinant() / whole;
    };
    const double along = share(0), u = share(1), v = share(2);
    return along >= 0 && along <= 1 && u >= 0 && v >= 0 && u + v <= 1;
}

/// The witness: every triangle but its own is asked whether it lies between a point and the projector.
bool isHidden(const TriangleMesh& mesh, const Projector& projector, std::size_t triangle,
              const Eigen::Vector3d& point) {
    Eigen::Vector3d light = projector.pose.translation();
    if (projector.kind == ProjectorKind::Parallel) {
        const Eigen::Vector3d back = projector.pose.linear().col(2);
        light = point + back * back.dot(light - point);
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        if (i != triangle && meets(point + 1e-9 * (light - point), light,
                                   {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]}))
            return true;
    }
    return false;
}

struct Counts {
    std::size_t lit = 0, hidden = 0, unknown = 0, wrong = 0; ///< of triangles that the photo shows
};

/// Compared at points all over each triangle, its border left out: there its neighbours begin.
Counts compare(const TriangleMesh& mesh, const Projector& projector) {
    const std::vector<Triangle> across = trianglesAcross(mesh.triangles);
    const std::vector<Lighting> lighting = certainLighting({mesh, across, tolerance}, projector, photo);
    Counts counts;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        bool isShown = false, isWrong = false;
        for (const auto& [u, v] : {std::pair{0.333, 0.333}, std::pair{0.01, 0.01}, std::pair{0.98, 0.01},
                                   std::pair{0.01, 0.98}, std::pair{0.49, 0.5}, std::pair{0.49, 0.01}}) {
            const Eigen::Vector3d point =
                (1 - u - v) * mesh.vertices[t[0]] + u * mesh.vertices[t[1]] + v * mesh.vertices[t[2]];
            const auto place = project(projector, photo, point);
            if (!place || place->z() < 0 || place->x() < 0 || place->x() > photo.width || place->y() < 0 ||
                place->y() > photo.height)
                continue;
            isShown = true;
            if (lighting[i] == Lighting::Unknown) continue;
            isWrong = isWrong || isHidden(mesh, projector, i, point) != (lighting[i] == Lighting::Hidden);
        }
        counts.lit += isShown && lighting[i] == Lighting::Lit ? 1 : 0;
        counts.hidden += isShown && lighting[i] == Lighting::Hidden ? 1 : 0;
        counts.unknown += isShown && lighting[i] == Lighting::Unknown ? 1 : 0;
        counts.wrong += isWrong ? 1 : 0;
    }
    return counts;
}

Projector projectorAt(ProjectorKind kind, const Eigen::Vector3d& place, const Eigen::AngleAxisd& turn) {
    Projector projector;
    projector.kind = kind;
    projector.pose = Eigen::Translation3d(place) * turn;
    projector.width = projector.height = 0.25;
    projector.fieldOfView = 60;
    return projector;
}

} // namespace

TEST(Lighting, IsWhatRaysFindFromAllAround) {
    const TriangleMesh mesh = lumpySurface(18, 22);
    for (const ProjectorKind kind : {ProjectorKind::Parallel, ProjectorKind::Perspective}) {
        Counts sum;
        for (int i = 0; i < 6; ++i) {
            const Eigen::AngleAxisd turn(i, Eigen::Vector3d(1, 2, 0.5).normalized());
            const Counts counts = compare(mesh, projectorAt(kind, turn * Eigen::Vector3d(0, 0, 0.3), turn));
            EXPECT_EQ(counts.wrong, 0U) << i;
            sum.lit += counts.lit, sum.hidden += counts.hidden, sum.unknown += counts.unknown;
        }
        EXPECT_GT(std::min(sum.lit, sum.hidden), mesh.triangles.size());
        EXPECT_GT(sum.lit + sum.hidden, 2 * sum.unknown) << "few are left to rays";
    }
}

TEST(Lighting, IsWhatRaysFindFromWithin) {
    const TriangleMesh mesh = lumpySurface(18, 22);
    for (int i = 0; i < 6; ++i) {
        const Eigen::AngleAxisd turn(i, Eigen::Vector3d(1, 2, 0.5).normalized());
        const Counts counts = compare(mesh, projectorAt(ProjectorKind::Perspective, {0, 0, 0.01}, turn));
        EXPECT_EQ(counts.wrong, 0U) << i;
        EXPECT_GT(counts.lit, 2 * counts.unknown) << "what reaches behind the eye hides nothing before it";
    }
}

TEST(Lighting, SeesWhatHidesFromBesideTheEye) {
    // The first triangle reaches behind the eye and hides the left half of the square before it.
    TriangleMesh mesh = flatSquare(0.1, 8);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {{-0.001, -1, 0.05}, {-0.001, 1, 0.05}, {-0.3, 0, 0.3}});
    mesh.triangles.insert(mesh.triangles.begin(), {first, first + 1, first + 2});
    const Counts counts =
        compare(mesh, projectorAt(ProjectorKind::Perspective, {0, 0, 0.1}, Eigen::AngleAxisd::Identity()));
    EXPECT_EQ(counts.wrong, 0U);
    EXPECT_GE(counts.lit, 40U);
    EXPECT_GE(counts.unknown, 40U);
}

TEST(Lighting, DoesNotTakeWhatHasAHoleForACover) {
    TriangleMesh whole = flatSquare(0.1, 6);
    const TriangleMesh below = flatSquare(0.02, 1);
    const auto first = static_cast<std::uint32_t>(whole.vertices.size());
    for (const Eigen::Vector3d& vertex : below.vertices)
        whole.vertices.emplace_back(vertex - Eigen::Vector3d(0.005, 0.003, 0.02));
    for (const Triangle& t : below.triangles)
        whole.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    const Projector above = projectorAt(ProjectorKind::Parallel, {0, 0, 0.1}, Eigen::AngleAxisd::Identity());
    EXPECT_EQ(compare(whole, above).hidden, 2U);
    // A hole anywhere near leaves it open, and what rays find tells.
    std::size_t open = 0;
    for (std::size_t hole = 0; hole + 2 < whole.triangles.size(); ++hole) {
        TriangleMesh pierced = whole;
        pierced.triangles.erase(pierced.triangles.begin() + static_cast<std::ptrdiff_t>(hole));
        const Counts counts = compare(pierced, above);
        EXPECT_EQ(counts.wrong, 0U) << hole;
        open += 2 - counts.hidden;
    }
    EXPECT_GT(open, 4U);
}
