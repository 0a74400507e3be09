#include "core/geometry/surface_spot.h"

#include <gtest/gtest.h>

using namespace esm;
using Eigen::Vector3d;

namespace {

/// Two square sheets, 2 m wide, facing away from each other at z = 0 and z = −0.1, and a steep flap beside.
TriangleMesh wall() {
    TriangleMesh mesh;
    mesh.vertices = {{-1, -1, 0},  {1, -1, 0},    {1, 1, 0}, {-1, 1, 0}, {-1, -1, -0.1}, {1, -1, -0.1},
                     {1, 1, -0.1}, {-1, 1, -0.1}, {5, 0, 0}, {5, 1, 0},  {5, 0, 1}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 6, 5}, {4, 7, 6}, {8, 9, 10}};
    return mesh;
}

} // namespace

TEST(SurfaceSpot, FacesAsTheSurfaceAroundItDoesAndNotAsTheOppositeWall) {
    const SurfaceSpot spot{{0.2, 0.1, 0}, Vector3d(0.3, 0, 1).normalized()};
    EXPECT_TRUE(outwardAround(wall(), spot, 2).isApprox(Vector3d::UnitZ(), 1e-12));
    const SurfaceSpot behind{{0.2, 0.1, -0.1}, -Vector3d::UnitZ()};
    EXPECT_TRUE(outwardAround(wall(), behind, 2).isApprox(-Vector3d::UnitZ(), 1e-12));
}

TEST(SurfaceSpot, FacesItsOwnWayWhereNothingIsNear) {
    const SurfaceSpot spot{{0, 0, 9}, Vector3d::UnitX()};
    EXPECT_EQ(outwardAround(wall(), spot, 0.1), Vector3d::UnitX());
}

TEST(SurfaceSpot, HoldsAnEllipsoidThatLiesOnTheSurface) {
    const SurfaceSpot spot{{5, 0.2, 0.2}, Vector3d::UnitX()};
    const Ellipsoid laid = laidOn(wall(), spot, {0.5, 0.4, 0.1});
    EXPECT_EQ(laid.centre, spot.point);
    EXPECT_EQ(laid.radii, Vector3d(0.5, 0.4, 0.1));
    EXPECT_TRUE((laid.orientation * Vector3d::UnitZ()).isApprox(Vector3d::UnitX(), 1e-12));
    EXPECT_TRUE(validate(laid).empty());
}
