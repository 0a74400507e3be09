#include "core/solid/lattice_binding.h"

#include "core/support/errors.h"
#include "tests/support/solid_surfaces.h"
#include "tests/support/steady_progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

namespace esm {
namespace {

using Eigen::Vector3d;
using Points = std::vector<Vector3d>;
using Motion = std::function<Vector3d(const Vector3d&)>;

Points movedBy(const Motion& motion, const Points& points) {
    Points result;
    for (const Vector3d& point : points)
        result.push_back(motion(point));
    return result;
}

/// How far a drawn vertex is at most from where the motion takes it.
double farthestOff(const TriangleMesh& mesh, const FilledBody& filled, const Motion& motion) {
    const Binding binding = bindToLattice(mesh, filled);
    EXPECT_THAT(validate(binding, mesh.vertices.size(), filled.nodes.size()), testing::IsEmpty());
    const Points drawn = carried(mesh.vertices, binding, filled.nodes, movedBy(motion, filled.nodes));
    double most = 0;
    for (std::size_t i = 0; i < drawn.size(); ++i)
        most = std::max(most, (drawn[i] - motion(mesh.vertices[i])).norm());
    return most;
}

TEST(LatticeBinding, FollowsARigidMotionAndALinearOneExactly) {
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(2.1, Vector3d(1, -2, 0.5).normalized()));
    Eigen::Matrix3d stretch;
    stretch << 1.2, 0.1, 0, -0.05, 0.9, 0.1, 0, 0.2, 1.1;
    TriangleMesh parts = test::shell(0.1, 0.06);
    test::append(parts, test::ball(0.02, {0.15, 0, 0}));
    for (const TriangleMesh& mesh : {lumpySurface(30, 60), parts})
        for (const LatticeKind kind :
             {LatticeKind::Cubic, LatticeKind::BodyCentred, LatticeKind::Graded, LatticeKind::Diamond}) {
            const FilledBody filled = fillBody(mesh, {kind, 0.016});
            EXPECT_LT(farthestOff(
                          mesh, filled,
                          [&](const Vector3d& p) -> Vector3d { return turn * p + Vector3d(0.3, -0.2, 0.7); }),
                      1e-12);
            EXPECT_LT(farthestOff(mesh, filled, [&](const Vector3d& p) -> Vector3d { return stretch * p; }),
                      1e-12);
        }
}

TEST(LatticeBinding, FollowsABendBetterTheFinerTheLattice) {
    const TriangleMesh mesh = lumpySurface(30, 60);
    const Motion bend = [](const Vector3d& p) -> Vector3d {
        return {p.x(), p.y() + 3 * p.x() * p.x() + 0.5 * p.z() * p.x(), p.z()};
    };
    const double coarse = farthestOff(mesh, fillBody(mesh, {LatticeKind::BodyCentred, 0.02}), bend),
                 fine = farthestOff(mesh, fillBody(mesh, {LatticeKind::BodyCentred, 0.01}), bend);
    EXPECT_LT(coarse, 0.001);
    EXPECT_LT(fine, 0.5 * coarse);
}

TEST(LatticeBinding, HangsEachPartOnItsOwnBody) {
    TriangleMesh mesh = test::ball(0.1, {0, 0, 0});
    const std::size_t first = mesh.vertices.size();
    test::append(mesh, test::ball(0.05, {0.1501, 0, 0})); // 0.1 mm beside it
    const FilledBody filled = fillBody(mesh, {LatticeKind::BodyCentred, 0.02});
    const Binding binding = bindToLattice(mesh, filled);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        for (const std::uint32_t node : binding.vertices[i].nodes)
            EXPECT_EQ(node >= filled.bodyStarts[1], i >= first);
}

TEST(LatticeSurface, IsClosedAndFacesOutwards) {
    const TriangleMesh mesh = test::shell(0.1, 0.06);
    const FilledBody filled = fillBody(mesh, {LatticeKind::BodyCentred, 0.012});
    const TriangleMesh surface{filled.nodes, outerTriangles(filled.tetrahedra)};
    double volume = 0;
    for (const Tetrahedron& tetrahedron : filled.tetrahedra)
        volume += volumeOf(tetrahedron, filled.nodes);
    EXPECT_NEAR(enclosedVolume(surface), volume, 1e-12);
}

TEST(LatticeBinding, RefusesAnotherSurface) {
    const FilledBody filled = fillBody(test::ball(0.1, {0, 0, 0}), {LatticeKind::Cubic, 0.03});
    TriangleMesh other = test::ball(0.1, {0, 0, 0});
    test::append(other, test::ball(0.1, {1, 0, 0}));
    EXPECT_THROW(bindToLattice(other, filled), InvalidModel);
}

TEST(LatticeBinding, TellsItsProgress) {
    const TriangleMesh mesh = lumpySurface(60, 120);
    const FilledBody filled = fillBody(mesh, {LatticeKind::BodyCentred, 0.02});
    test::expectGoodProgress([&](const Progress& progress) { bindToLattice(mesh, filled, progress); });
}

} // namespace
} // namespace esm
