#include "widgets/view/projector_handles.h"

#include "core/support/angles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace esm;
using Eigen::Vector3d;

namespace {

using GripKind = ProjectorHandle::Kind;

const Vector3d lookedAtPoint(0.02, -0.01, 0.1);

/// Looks at the point along −z, 0.2 m before it.
PhotoFace facing(ProjectorKind kind) {
    PhotoFace face;
    face.projector.kind = kind;
    face.projector.pose.translation() = lookedAtPoint + Vector3d(0, 0, 0.2);
    face.projector.width = 0.08;
    face.projector.height = 0.05;
    face.size = {160, 100};
    face.depth = kind == ProjectorKind::Parallel ? 0 : 0.1;
    return face;
}

Camera viewedFrom(const Vector3d& eye) {
    Camera camera;
    camera.eye = eye;
    camera.target = lookedAtPoint;
    return camera;
}

const Vector3d viewerAhead(0.02, -0.01, 1.5), viewerBeside(1.5, 0.2, 0.15);

Ray rayThrough(const Vector3d& eye, const Vector3d& point) {
    return {eye, (point - eye).normalized()};
}

bool hasHandle(const std::vector<ProjectorHandle>& handles, GripKind kind) {
    return std::any_of(handles.begin(), handles.end(),
                       [&](const ProjectorHandle& handle) { return handle.kind == kind; });
}

Vector3d aheadOf(const Projector& projector) {
    return -projector.pose.linear().col(2);
}

/// Of the line of sight from what the projector looked at, m.
double missBy(const Projector& projector) {
    return (lookedAtPoint - projector.pose.translation()).cross(aheadOf(projector)).norm();
}

} // namespace

TEST(ProjectorHandles, StandWhereADragCanTellWhatIsMeant) {
    for (const auto kind : {ProjectorKind::Parallel, ProjectorKind::Perspective}) {
        const PhotoFace face = facing(kind);
        const auto ahead = projectorHandles(face, viewedFrom(viewerAhead), 0.01);
        EXPECT_EQ(ahead.size(), photoHandles + 2);
        EXPECT_TRUE(hasHandle(ahead, GripKind::Roll) && hasHandle(ahead, GripKind::Turn));
        EXPECT_FALSE(hasHandle(ahead, GripKind::Push)) << "it would point at the viewer";
        const auto beside =
            projectorHandles(face, viewedFrom({1.5, -0.01, face.projector.pose.translation().z()}), 0.01);
        EXPECT_TRUE(hasHandle(beside, GripKind::Push) && hasHandle(beside, GripKind::Turn));
        EXPECT_FALSE(hasHandle(beside, GripKind::Roll)) << "the photo is seen from its edge";
        for (const ProjectorHandle& handle : beside)
            if (handle.kind != GripKind::Size) {
                EXPECT_GT((handle.at - handle.root).norm(), 0.009);
            }
    }
}

TEST(ProjectorHandles, ATurnGoesAroundTheTargetOrTheProjectorsPlace) {
    for (const auto kind : {ProjectorKind::Parallel, ProjectorKind::Perspective})
        for (const Vector3d& eye : {viewerAhead, viewerBeside})
            for (const bool aboutItself : {false, true}) {
                const PhotoFace face = facing(kind);
                const ProjectorTurn turn{face, lookedAtPoint, aboutItself, false};
                const Vector3d grip = turnedPlace(turn), aside = Vector3d(0.003, 0.03, -0.002);
                const Projector now = turned(turn, rayThrough(eye, grip), rayThrough(eye, grip + aside));
                EXPECT_GT(turnBetween(face.projector, now), 1);
                const Vector3d way = now.pose.translation() - lookedAtPoint;
                if (aboutItself) {
                    EXPECT_TRUE(now.pose.translation().isApprox(face.projector.pose.translation()));
                    EXPECT_GT(missBy(now), 0.001);
                } else {
                    EXPECT_NEAR(way.norm(), 0.2, 1e-9);
                    EXPECT_LT(missBy(now), 1e-9) << "it looks at the same place";
                }
                EXPECT_TRUE((now.pose.linear() * now.pose.linear().transpose()).isIdentity(1e-9));
            }
}

TEST(ProjectorHandles, AnAimedTargetFollowsTheMouse) {
    const PhotoFace face = facing(ProjectorKind::Perspective);
    const ProjectorTurn turn{face, lookedAtPoint, true, false};
    const Vector3d grip = turnedPlace(turn);
    EXPECT_TRUE(grip.isApprox(lookedAtPoint));
    const Projector now =
        turned(turn, rayThrough(viewerAhead, grip), rayThrough(viewerAhead, grip + Vector3d(0.03, 0, 0)));
    EXPECT_GT(aheadOf(now).x(), 0.1);
    EXPECT_NEAR(aheadOf(now).y(), 0, 1e-6);
}

TEST(ProjectorHandles, AShiftedTurnGoesInStepsAboutOneAxis) {
    const PhotoFace face = facing(ProjectorKind::Parallel);
    const ProjectorTurn turn{face, lookedAtPoint, false, true};
    const Vector3d grip = turnedPlace(turn);
    const Projector now =
        turned(turn, rayThrough(viewerAhead, grip), rayThrough(viewerAhead, grip + Vector3d(0.06, 0.01, 0)));
    const double degrees = turnBetween(face.projector, now);
    EXPECT_NEAR(degrees, 15 * std::round(degrees / 15), 1e-9);
    EXPECT_GT(degrees, 14);
    EXPECT_NEAR(aheadOf(now).y(), 0, 1e-12);
}

TEST(ProjectorHandles, ARollGoesWithTheMouseAboutTheLineOfSight) {
    for (const auto kind : {ProjectorKind::Parallel, ProjectorKind::Perspective}) {
        const PhotoFace face = facing(kind);
        const Vector3d middle = lookedAtPoint + Vector3d(0, 0, 0.2 - face.depth);
        const auto at = [&](double degrees) {
            const double angle = toRadians(degrees);
            return rayThrough(viewerAhead, middle + 0.05 * Vector3d(std::cos(angle), std::sin(angle), 0));
        };
        const Projector now = rolled(face, at(90), at(127), false);
        EXPECT_NEAR(turnBetween(face.projector, now), 37, 1e-6);
        EXPECT_TRUE(aheadOf(now).isApprox(aheadOf(face.projector)));
        EXPECT_LT(missBy(now), 1e-9);
        EXPECT_LT(now.pose.linear().col(1).x(), 0)
            << "its upper viewerBeside goes to the left, as the mouse does";
        EXPECT_NEAR(turnBetween(face.projector, rolled(face, at(90), at(127), true)), 30, 1e-6);
    }
}

TEST(ProjectorHandles, APushGoesAlongTheLineOfSightAndNotThroughTheTarget) {
    for (const auto kind : {ProjectorKind::Parallel, ProjectorKind::Perspective}) {
        const PhotoFace face = facing(kind);
        const Vector3d place = face.projector.pose.translation();
        const Projector nearer = pushed(face, lookedAtPoint, rayThrough(viewerBeside, place),
                                        rayThrough(viewerBeside, place - Vector3d(0, 0, 0.07)));
        EXPECT_NEAR((nearer.pose.translation() - place).z(), -0.07, 1e-9);
        EXPECT_LT(missBy(nearer), 1e-9);
        const Projector far = pushed(face, lookedAtPoint, rayThrough(viewerBeside, place),
                                     rayThrough(viewerBeside, place - Vector3d(0, 0, 0.5)));
        const bool hasEye = kind == ProjectorKind::Perspective;
        EXPECT_EQ(far.pose.translation().z() > lookedAtPoint.z(), hasEye);
        EXPECT_NEAR((pushedBy(face, lookedAtPoint, -0.5).pose.translation() - place).z(), 0.1, 1e-9);
    }
}
