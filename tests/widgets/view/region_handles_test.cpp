#include "widgets/view/region_handles.h"

#include "core/render/drawn_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace esm;
using Eigen::Vector3d;

namespace {

using Kind = RegionHandle::Kind;

DrawnEllipsoid lens() {
    DrawnEllipsoid drawn;
    drawn.shape.centre = {0.01, 0.02, 0};
    drawn.shape.radii = {0.05, 0.03, 0.02};
    drawn.rim = 0.004;
    return drawn;
}

Camera fromFront() {
    Camera camera;
    camera.eye = {0, 0, 0.6};
    return camera;
}

std::vector<RegionHandle> ofKind(const std::vector<RegionHandle>& handles, Kind kind) {
    std::vector<RegionHandle> found;
    std::copy_if(handles.begin(), handles.end(), std::back_inserter(found),
                 [&](const RegionHandle& handle) { return handle.kind == kind; });
    return found;
}

} // namespace

TEST(RegionHandles, StandAtAxesThatAreSeen) {
    const auto all = regionHandles(lens(), fromFront(), 0.01);
    EXPECT_EQ(ofKind(all, Kind::Size).size(), 4U) << "none towards the viewer";
    const auto turns = ofKind(all, Kind::Turn);
    ASSERT_EQ(turns.size(), 2U);
    EXPECT_TRUE(turns[0].place.isApprox(Vector3d(0.07, 0.02, 0)));
    EXPECT_TRUE(turns[1].place.isApprox(Vector3d(0.01, 0.06, 0)));
}

TEST(RegionHandles, HaveOneOnTheRimsOutlineAwayFromTheOthers) {
    for (const double width : {0.0, 0.004, 0.1}) {
        DrawnEllipsoid drawn = lens();
        drawn.rim = width;
        const auto all = regionHandles(drawn, fromFront(), 0.01);
        const auto rims = ofKind(all, Kind::Rim);
        ASSERT_EQ(rims.size(), 1U);
        EXPECT_NEAR(distanceOutside(drawn.shape, rims[0].place), width, 1e-9);
        EXPECT_GT(rims[0].place.x(), drawn.shape.centre.x());
        EXPECT_GT(rims[0].place.y(), drawn.shape.centre.y());
        for (const RegionHandle& other : all)
            if (other.kind != Kind::Rim) {
                EXPECT_GT((other.place - rims[0].place).norm(), 0.01);
            }
    }
}

TEST(RimSilhouette, IsWhereLinesOfSightTouchTheRim) {
    DrawnEllipsoid drawn = lens();
    drawn.shape.orientation = Eigen::AngleAxisd(0.6, Vector3d(1, 1, 0).normalized());
    const Vector3d eye(0.1, 0.2, 0.5);
    const auto curve = rimSilhouette(drawn.shape, drawn.rim, eye);
    ASSERT_GT(curve.size(), 20U);
    for (const Vector3d& point : curve) {
        EXPECT_NEAR(distanceOutside(drawn.shape, point), drawn.rim, 1e-9);
        for (const double along : {-0.01, 0.01})
            EXPECT_GT(distanceOutside(drawn.shape, point + along * (point - eye).normalized()), drawn.rim);
    }
    EXPECT_TRUE(rimSilhouette(drawn.shape, 10, eye).empty()) << "from inside";
}

TEST(RegionHandles, TurnBringsWhatWasGrabbedUnderTheMouse) {
    const Ellipsoid start = lens().shape;
    const Vector3d before = Vector3d(2, 1, 2) / 3, after = Vector3d(1, 2, 2) / 3, eye(0, 0, 0.6);
    const Vector3d grabbed = start.centre + 0.06 * before, aim = start.centre + 0.06 * after;
    const Grip grip{grabbed, {eye, grabbed - eye}};
    const Ellipsoid result = turned(start, grip, {eye, aim - eye});
    EXPECT_TRUE((result.orientation * before).isApprox(after, 1e-6));
    EXPECT_EQ(result.centre, start.centre);
    EXPECT_EQ(result.radii, start.radii);
    EXPECT_NEAR(turned(start, grip, grip.ray).orientation.angularDistance(start.orientation), 0, 1e-7);
    const Vector3d behind = start.centre + 0.06 * Vector3d(2, 1, -2) / 3;
    const Vector3d further = start.centre + 0.06 * Vector3d(1, 2, -2) / 3;
    const Ellipsoid back = turned(start, {behind, {eye, behind - eye}}, {eye, further - eye});
    EXPECT_TRUE((back.orientation * Vector3d(2, 1, -2)).isApprox(Vector3d(1, 2, -2), 1e-6));
}

TEST(RegionHandles, TurnInThePictureWhereTheMouseLeavesTheBall) {
    const Ellipsoid start = lens().shape;
    const Vector3d eye = start.centre + Vector3d(0, 0, 50), grabbed = start.centre + Vector3d(0.06, 0, 0);
    const Grip grip{grabbed, {eye, grabbed - eye}};
    const Ellipsoid result = turned(start, grip, {eye, start.centre + Vector3d(0, 0.5, 0) - eye});
    EXPECT_NEAR((result.orientation * Vector3d::UnitX()).y(), 1, 0.02);
    EXPECT_TRUE(turned(start, grip, {eye, start.centre - eye}).orientation.coeffs().allFinite());
}
