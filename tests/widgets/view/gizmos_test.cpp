#include "widgets/view/gizmos.h"

#include "widgets/view/dragging.h"

#include <gtest/gtest.h>

using namespace esm;
using Eigen::Vector3d;

namespace {

Ellipsoid tilted() {
    Ellipsoid ellipsoid;
    ellipsoid.centre = {0.1, 0.2, 0.3};
    ellipsoid.radii = {0.03, 0.05, 0.02};
    ellipsoid.orientation = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized());
    return ellipsoid;
}

Projector slanted() {
    Projector projector;
    projector.pose.translation() = Vector3d(0.02, -0.01, 0.4);
    projector.pose.rotate(Eigen::AngleAxisd(0.5, Vector3d::UnitY()));
    projector.width = 0.08;
    projector.height = 0.05;
    return projector;
}

Ray towards(const Vector3d& eye, const Vector3d& point) {
    return {eye, point - eye};
}

const Vector3d eye(0.05, 0.1, 1.2);

} // namespace

TEST(Gizmos, RayMeetsTheEllipsoidOnItsSurface) {
    const Ellipsoid ellipsoid = tilted();
    const Ray ray = towards(eye, ellipsoid.centre + Vector3d(0.01, 0.005, 0));
    const auto distance = distanceTo(ellipsoid, ray);
    ASSERT_TRUE(distance);
    const Vector3d point = ray.origin + *distance * ray.direction.normalized();
    const Vector3d unit =
        (ellipsoid.orientation.inverse() * (point - ellipsoid.centre)).cwiseQuotient(ellipsoid.radii);
    EXPECT_NEAR(unit.norm(), 1, 1e-9);
    EXPECT_LT(*distance, (ellipsoid.centre - eye).norm());
    EXPECT_FALSE(distanceTo(ellipsoid, towards(eye, ellipsoid.centre + Vector3d(0.2, 0, 0))));
    EXPECT_FALSE(distanceTo(ellipsoid, {eye, eye - ellipsoid.centre})) << "it lies behind";
}

TEST(Gizmos, DrawnHandleFollowsTheRayAndOnlyItsAxisChanges) {
    const Ellipsoid ellipsoid = tilted();
    for (std::size_t handle = 0; handle < 6; ++handle) {
        const Vector3d wanted = ellipsoid.centre + 1.7 * (handles(ellipsoid)[handle] - ellipsoid.centre);
        const Ellipsoid result = scaled(ellipsoid, handle, towards(eye, wanted));
        EXPECT_TRUE(handles(result)[handle].isApprox(wanted, 1e-9));
        EXPECT_TRUE(result.centre.isApprox(ellipsoid.centre));
        Vector3d others = result.radii;
        others[static_cast<Eigen::Index>(handle / 2)] =
            ellipsoid.radii[static_cast<Eigen::Index>(handle / 2)];
        EXPECT_EQ(others, ellipsoid.radii);
    }
}

TEST(Gizmos, AnAxisCannotBeDrawnShut) {
    const Ellipsoid ellipsoid = tilted();
    for (std::size_t handle = 0; handle < 6; ++handle) {
        const Vector3d beyond = ellipsoid.centre - 3 * (handles(ellipsoid)[handle] - ellipsoid.centre);
        EXPECT_GT(scaled(ellipsoid, handle, towards(eye, beyond)).radii.minCoeff(), 0);
    }
    // Along the axis no length can be read.
    const Vector3d end = handles(ellipsoid)[0];
    const Ellipsoid same = scaled(ellipsoid, 0, {end + (end - ellipsoid.centre), ellipsoid.centre - end});
    EXPECT_TRUE(same.radii.isApprox(ellipsoid.radii));
}

TEST(Gizmos, ProjectorCornerKeepsTheProportions) {
    const Projector projector = slanted();
    const Vector3d corner(projector.width / 2, projector.height / 2, 0);
    for (const Stays stays : {Stays::Middle, Stays::OtherSide}) {
        const auto drawnTo = [&](const Vector3d& place) {
            return scaled(PhotoFace{projector}, 2, towards(eye, projector.pose * place),
                          {Proportions::Kept, stays});
        };
        const Projector twice = drawnTo(stays == Stays::Middle ? 2 * corner : 3 * corner);
        EXPECT_NEAR(twice.width, 2 * projector.width, 1e-9);
        EXPECT_NEAR(twice.height, 2 * projector.height, 1e-9);
        const Projector beside = drawnTo({0.08, 0.02, 0});
        EXPECT_NEAR(beside.width / beside.height, projector.width / projector.height, 1e-9);
        EXPECT_GT(beside.width, projector.width);
        EXPECT_GT(drawnTo({0, 0, 0}).height, 0);
        EXPECT_GT(drawnTo({-0.5, -0.5, 0}).height, 0) << "it cannot be drawn shut";
    }
}

TEST(Gizmos, WhatLiesOppositeToADrawnHandleStays) {
    const Projector projector = slanted();
    const auto before = handles(PhotoFace{projector});
    for (std::size_t handle = 0; handle < photoHandles; ++handle) {
        const std::size_t opposite = handle < 4 ? (handle + 2) % 4 : 4 + (handle - 2) % 4;
        const Vector3d wanted = before[handle] + 0.4 * (before[handle] - before[opposite]);
        const Projector result = scaled(PhotoFace{projector}, handle, towards(eye, wanted), {});
        const auto after = handles(PhotoFace{result});
        EXPECT_TRUE(after[opposite].isApprox(before[opposite], 1e-9)) << handle;
        EXPECT_TRUE(after[handle].isApprox(wanted, 1e-9)) << handle;
        const Projector about =
            scaled(PhotoFace{projector}, handle, towards(eye, wanted), {Proportions::Kept, Stays::Middle});
        EXPECT_TRUE(about.pose.isApprox(projector.pose));
    }
}

TEST(Gizmos, ProjectorCornerScalesWidthAndHeightApart) {
    const Projector projector = slanted();
    const Vector3d corner = projector.pose * Vector3d(0.06, -0.01, 0);
    const Projector result =
        scaled(PhotoFace{projector}, 2, towards(eye, corner), {Proportions::Free, Stays::Middle});
    EXPECT_NEAR(result.width, 0.12, 1e-9);
    EXPECT_NEAR(result.height, 0.02, 1e-9);
    EXPECT_TRUE(result.pose.isApprox(projector.pose));
}

TEST(Gizmos, TheMiddleOfAnEdgeScalesWidthOrHeightAlone) {
    const Projector projector = slanted();
    const Vector3d place = projector.pose * Vector3d(0.06, 0.04, 0);
    for (const std::size_t handle : {4U, 5U, 6U, 7U}) {
        const bool isAcross = handle % 2 == 1;
        const Projector result =
            scaled(PhotoFace{projector}, handle, towards(eye, place), {Proportions::Kept, Stays::Middle});
        EXPECT_NEAR(result.width, isAcross ? 0.12 : projector.width, 1e-9);
        EXPECT_NEAR(result.height, isAcross ? projector.height : 0.08, 1e-9);
    }
}

TEST(Gizmos, HandlesOfAPerspectivePhotoChangeItsFieldOfView) {
    Projector projector = slanted();
    projector.kind = ProjectorKind::Perspective;
    projector.fieldOfView = 40;
    const PhotoFace photo{projector, {300, 200}, 0.2};
    const auto places = handles(photo);
    const Vector3d sight = projector.pose * Vector3d(0, 0, -0.2);
    for (std::size_t handle = 0; handle < photoHandles; ++handle) {
        EXPECT_TRUE(distanceTo(photo, towards(eye, sight + 0.99 * (places[handle] - sight))));
        EXPECT_FALSE(distanceTo(photo, towards(eye, sight + 1.01 * (places[handle] - sight))));
        const Vector3d wanted = sight + 1.5 * (places[handle] - sight);
        const Projector result = scaled(photo, handle, towards(eye, wanted), {Proportions::Free});
        EXPECT_TRUE(handles(PhotoFace{result, photo.size, photo.depth})[handle].isApprox(wanted, 1e-9));
        EXPECT_TRUE(result.pose.isApprox(projector.pose));
    }
    const Projector shut = scaled(photo, 2, towards(eye, sight), {});
    EXPECT_GE(shut.fieldOfView, 0.1);
}

TEST(Gizmos, ADragGoesAsFarAsTheMouseInItsPlane) {
    const Projector projector = slanted();
    const Vector3d from = projector.pose * Vector3d(0.01, 0.01, 0),
                   to = projector.pose * Vector3d(-0.05, 0.03, 0);
    const DragPlane plane{from, projector.pose.linear().col(2)};
    EXPECT_TRUE(shift(plane, towards(eye, to)).isApprox(to - from, 1e-9));
    EXPECT_TRUE(shift(plane, {eye, projector.pose.linear().col(0)}).isZero())
        << "a ray that misses the plane";
}

TEST(Gizmos, TheSelectedShapeIsTakenFirst) {
    RenderScene scene;
    DrawnEllipsoid front, back;
    front.shape.centre = {0, 0, 0.5};
    front.shape.radii.setConstant(0.1);
    back.shape.radii.setConstant(0.1);
    scene.ellipsoids = {back, front};
    const Ray ray{{0, 0, 2}, {0, 0, -1}};
    EXPECT_EQ(ellipsoidUnder(scene, ray), 1);
    scene.ellipsoids[0].selected = true;
    EXPECT_EQ(ellipsoidUnder(scene, ray), 0);
    EXPECT_EQ(ellipsoidUnder(scene, {{0, 0, 2}, {0, 0, 1}}), -1);
}
