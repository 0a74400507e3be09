#include "core/render/camera.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace esm;
using Eigen::Vector3d;

namespace {

const Eigen::AlignedBox3d organBox{Vector3d(-0.1, 0.2, -0.02), Vector3d(0.15, 0.3, 0.06)};
constexpr std::array<StandardView, 6> views{StandardView::Front, StandardView::Back, StandardView::Left,
                                            StandardView::Right, StandardView::Top,  StandardView::Bottom};

double distance(const Camera& camera) {
    return (camera.eye - camera.target).norm();
}

/// Clip coordinates divided by w, by the matrices alone.
Vector3d clipped(const Camera& camera, double aspect, const Vector3d& point) {
    const Eigen::Vector4d clip =
        projectionMatrix(camera, aspect, organBox) * viewMatrix(camera) * point.homogeneous();
    return clip.head<3>() / clip.w();
}

} // namespace

TEST(Camera, NamesOfStandardViews) {
    EXPECT_EQ(standardViewFromName("left"), StandardView::Left);
    EXPECT_EQ(standardViewFromName("bottom"), StandardView::Bottom);
    EXPECT_FALSE(standardViewFromName("Front").has_value());
    EXPECT_FALSE(standardViewFromName("").has_value());
}

TEST(Camera, StandardViewsLookFromTheirSide) {
    const Vector3d centre = organBox.center();
    const auto direction = [&](StandardView view) {
        return Vector3d((framedCamera(organBox, view, 1).eye - centre).normalized());
    };
    EXPECT_TRUE(direction(StandardView::Front).isApprox(Vector3d::UnitZ()));
    EXPECT_TRUE(direction(StandardView::Back).isApprox(-Vector3d::UnitZ()));
    EXPECT_TRUE(direction(StandardView::Right).isApprox(Vector3d::UnitX()));
    EXPECT_TRUE(direction(StandardView::Left).isApprox(-Vector3d::UnitX()));
    EXPECT_TRUE(direction(StandardView::Top).isApprox(Vector3d::UnitY()));
    EXPECT_TRUE(direction(StandardView::Bottom).isApprox(-Vector3d::UnitY()));
}

TEST(Camera, FramedBoxIsWhollyVisibleAndNotLost) {
    for (const StandardView view : views)
        for (const double aspect : {0.3, 1.0, 16.0 / 9, 4.0}) {
            const Camera camera = framedCamera(organBox, view, aspect);
            double widest = 0;
            for (int i = 0; i < 8; ++i) {
                const Vector3d corner = organBox.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
                const Vector3d clip = clipped(camera, aspect, corner);
                EXPECT_LE(clip.cwiseAbs().maxCoeff(), 1) << "aspect " << aspect;
                widest = std::max(widest, clip.head<2>().cwiseAbs().maxCoeff());
            }
            EXPECT_GT(widest, 0.8) << "the organ should fill the picture";
        }
}

TEST(Camera, BoxesWithoutSizeAreFramed) {
    const Vector3d point(3, -2, 1);
    for (const auto& box : {Eigen::AlignedBox3d(point, point), Eigen::AlignedBox3d()})
        for (const StandardView view : views) {
            const Camera camera = framedCamera(box, view, 1.5);
            EXPECT_TRUE(camera.eye.allFinite());
            EXPECT_GT(distance(camera), 1e-3);
            EXPECT_LT(distance(camera), 1);
            EXPECT_TRUE(projectionMatrix(camera, 1.5, box).allFinite());
        }
    EXPECT_TRUE(framedCamera({point, point}, StandardView::Top, 1).target.isApprox(point));
}

TEST(Camera, OrbitKeepsDistanceAndTarget) {
    Camera camera = framedCamera(organBox, StandardView::Front, 1.3);
    const Camera start = camera;
    for (int i = 0; i < 200; ++i)
        camera = orbited(camera, 0.37, i % 3 ? 0.11 : -0.31);
    EXPECT_NEAR(distance(camera), distance(start), 1e-12);
    EXPECT_TRUE(camera.target.isApprox(start.target));
    EXPECT_NEAR(cameraAxes(camera).col(0).y(), 0, 1e-9) << "the horizon stays level";
}

TEST(Camera, OrbitGoesTheWayItSays) {
    const Camera front = framedCamera(organBox, StandardView::Front, 1);
    const Camera quarterRight = orbited(front, std::acos(0.0), 0);
    EXPECT_TRUE(quarterRight.eye.isApprox(front.target + distance(front) * Vector3d::UnitX(), 1e-9));
    const Camera above = orbited(front, 0, 0.5);
    EXPECT_GT(above.eye.y(), front.eye.y());
    const Camera beyond = orbited(front, 0, 10);
    EXPECT_TRUE(beyond.eye.isApprox(front.target + distance(front) * Vector3d::UnitY(), 1e-9));
    EXPECT_TRUE(
        orbited(beyond, 0, -10).eye.isApprox(front.target - distance(front) * Vector3d::UnitY(), 1e-9));
}

TEST(Camera, PanShiftsByFractionsOfThePicture) {
    const Camera camera = framedCamera(organBox, StandardView::Left, 1.3);
    const auto where = picturePoint(panned(camera, 0.25, 0.1), camera.target, 1);
    ASSERT_TRUE(where);
    EXPECT_NEAR(where->x(), 0.25, 1e-12);
    EXPECT_NEAR(where->y(), 0.6, 1e-12);
}

TEST(Camera, ZoomStaysWithinItsLimits) {
    Camera camera = framedCamera(organBox, StandardView::Front, 1);
    EXPECT_NEAR(distance(zoomed(camera, 0.5)), 0.5 * distance(camera), 1e-12);
    Camera close = camera, far = camera;
    for (int i = 0; i < 300; ++i) {
        close = zoomed(close, 0.5);
        far = zoomed(far, 2);
    }
    EXPECT_NEAR(distance(close), 1e-5, 1e-12);
    EXPECT_NEAR(distance(far), 1e3, 1e-6);
    EXPECT_TRUE(projectionMatrix(close, 1, organBox).allFinite());
    EXPECT_TRUE(projectionMatrix(far, 1, organBox).allFinite());
}

TEST(Camera, ZoomAboutAPointKeepsItThere) {
    const double aspect = 1.6;
    const Camera camera = framedCamera(organBox, StandardView::Right, aspect);
    const Eigen::Vector2d at(0.8, 0.3);
    // The point of the target's plane under the mouse.
    const Ray ray = pickRay(camera, at.x(), at.y(), aspect);
    const Vector3d forward = (camera.target - camera.eye).normalized();
    const Vector3d point = ray.origin + ray.direction * distance(camera) / ray.direction.dot(forward);
    const auto seen = picturePoint(zoomedAbout(camera, 0.6, at, aspect), point, aspect);
    ASSERT_TRUE(seen);
    EXPECT_TRUE(seen->isApprox(at, 1e-9));
}

TEST(Camera, PickRayOfTheCentreMeetsTheTarget) {
    for (const StandardView view : views) {
        const Camera camera = orbited(framedCamera(organBox, view, 2), 0.3, -0.2);
        const Ray ray = pickRay(camera, 0.5, 0.5, 2);
        EXPECT_LT(ray.direction.cross(camera.target - ray.origin).norm(), 1e-12);
        EXPECT_GT(ray.direction.dot(camera.target - ray.origin), 0);
    }
}

TEST(Camera, PickRayAgreesWithTheMatrices) {
    const double aspect = 1.7;
    Camera camera = orbited(framedCamera(organBox, StandardView::Back, aspect), 0.7, 0.4);
    camera.stretch = 0.9;
    camera.centre = {0.45, 0.62};
    for (const Eigen::Vector2d& at : {Eigen::Vector2d(0.1, 0.2), {0.9, 0.4}, {0.33, 0.95}}) {
        const Ray ray = pickRay(camera, at.x(), at.y(), aspect);
        const Vector3d point = ray.origin + 0.4 * ray.direction;
        const Vector3d clip = clipped(camera, aspect, point);
        EXPECT_NEAR(0.5 + clip.x() / 2, at.x(), 1e-12);
        EXPECT_NEAR(0.5 - clip.y() / 2, at.y(), 1e-12);
        const auto back = picturePoint(camera, point, aspect);
        ASSERT_TRUE(back);
        EXPECT_TRUE(back->isApprox(at, 1e-12));
    }
    EXPECT_FALSE(picturePoint(camera, camera.eye + (camera.eye - camera.target), aspect));
}

TEST(Camera, SeesWhatAPerspectiveProjectorShows) {
    Projector projector;
    projector.kind = ProjectorKind::Perspective;
    projector.pose =
        Eigen::Translation3d(0.1, 0.2, 0.9) * Eigen::AngleAxisd(0.4, Vector3d(1, 2, 3).normalized());
    const PhotoSize photo{640, 360};
    const Vector3d point = projector.pose * Vector3d(0.03, -0.02, -0.5);
    for (const bool isMeasured : {false, true}) {
        if (isMeasured) projector.intrinsics = Intrinsics{500, 540, 300, 200};
        const auto seen = picturePoint(cameraOf(projector, photo), point, photo.aspect());
        const auto projected = project(projector, photo, point);
        EXPECT_NEAR(seen->x() * photo.width, projected->x(), 1e-9);
        EXPECT_NEAR(seen->y() * photo.height, projected->y(), 1e-9);
    }
}

TEST(Camera, AxesAreARotationHoweverUpIsGiven) {
    for (const Vector3d& up : {Vector3d(0, 1, 0), Vector3d(0, 0, 0), Vector3d(0, 0, 5)})
        for (const Vector3d& eye :
             {Vector3d(0, 0, 1), Vector3d(0, 1, 0), Vector3d(0, -1, 0), Vector3d(0, 0, 0)}) {
            Camera camera;
            camera.eye = eye;
            camera.up = up;
            const Eigen::Matrix3d axes = cameraAxes(camera);
            EXPECT_TRUE((axes.transpose() * axes).isIdentity(1e-12));
            EXPECT_NEAR(axes.determinant(), 1, 1e-12);
        }
}

namespace {

Camera flat(StandardView view, double aspect) {
    return reframed(orthographic(orbited(framedCamera(organBox, view, aspect), 0.4, -0.2)), organBox, aspect);
}

} // namespace

TEST(OrthographicCamera, FramedBoxIsWhollyVisibleAndNotLost) {
    for (const StandardView view : views)
        for (const double aspect : {0.3, 1.0, 4.0}) {
            double widest = 0;
            for (int i = 0; i < 8; ++i) {
                const Vector3d corner = organBox.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
                const Vector3d clip = clipped(flat(view, aspect), aspect, corner);
                EXPECT_LE(clip.cwiseAbs().maxCoeff(), 1) << "aspect " << aspect;
                widest = std::max(widest, clip.head<2>().cwiseAbs().maxCoeff());
            }
            EXPECT_GT(widest, 0.8) << "the organ should fill the picture";
        }
}

TEST(OrthographicCamera, KeepsParallelLinesParallelAndSizesAtAllDepths) {
    const Camera camera = flat(StandardView::Front, 1.5);
    const Vector3d way(0.02, 0.05, -0.03), backwards = cameraAxes(camera).col(2);
    const auto seenWay = [&](const Vector3d& from) {
        return Eigen::Vector2d(*picturePoint(camera, from + way, 1.5) - *picturePoint(camera, from, 1.5));
    };
    const Eigen::Vector2d first = seenWay({0, 0.2, 0});
    EXPECT_GT(first.norm(), 0.01);
    for (const Vector3d& from : {Vector3d(0.1, 0.3, 0.05), Vector3d(-0.1, 0.2, -0.02), Vector3d(5, -8, 3)})
        EXPECT_TRUE(seenWay(from).isApprox(first, 1e-9));
    EXPECT_TRUE(seenWay(100 * backwards).isApprox(first, 1e-9)) << "behind the eye as well";
}

TEST(OrthographicCamera, RaysAgreeWithTheMatrices) {
    const double aspect = 1.7;
    Camera camera = flat(StandardView::Back, aspect);
    camera.stretch = 0.9;
    camera.centre = {0.45, 0.62};
    for (const Eigen::Vector2d& at : {Eigen::Vector2d(0.1, 0.2), {0.9, 0.4}, {0.33, 0.95}})
        for (const double depth : {0.05, 0.4}) {
            const Ray ray = pickRay(camera, at.x(), at.y(), aspect);
            const Vector3d clip = clipped(camera, aspect, ray.origin + depth * ray.direction);
            EXPECT_NEAR(0.5 + clip.x() / 2, at.x(), 1e-12);
            EXPECT_NEAR(0.5 - clip.y() / 2, at.y(), 1e-12);
            EXPECT_TRUE(
                picturePoint(camera, ray.origin + depth * ray.direction, aspect)->isApprox(at, 1e-12));
        }
}

TEST(OrthographicCamera, SwitchingKeepsWhatLiesAtTheTargetsDepth) {
    const Camera before = panned(orbited(framedCamera(organBox, StandardView::Top, 1), 0.3, -0.5), 0.1, 0.2);
    const Vector3d beside =
        before.target + 0.03 * cameraAxes(before).col(0) - 0.02 * cameraAxes(before).col(1);
    const Camera without = orthographic(before), again = perspective(without);
    EXPECT_TRUE(picturePoint(without, beside, 1)->isApprox(*picturePoint(before, beside, 1), 1e-9));
    EXPECT_TRUE(again.eye.isApprox(before.eye, 1e-9));
    EXPECT_FALSE(again.orthographicHeight);
}

TEST(OrthographicCamera, StandsBeforeTheBoxHoweverItTurns) {
    Camera camera = panned(flat(StandardView::Front, 1), 3, -2);
    for (int i = 0; i < 50; ++i) {
        camera = standingBefore(orbited(camera, 0.37, i % 3 ? 0.11 : -0.31), organBox);
        for (int corner = 0; corner < 8; ++corner)
            EXPECT_GT((camera.eye - organBox.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)))
                          .dot(cameraAxes(camera).col(2)),
                      0);
    }
}

TEST(Camera, ScalingAboutAPointKeepsItInThePictureAndLeadsBack) {
    const Vector3d point(0.12, 0.22, 0.05);
    for (const Camera& camera :
         {framedCamera(organBox, StandardView::Right, 1.6), flat(StandardView::Left, 1.6)}) {
        const Camera closer = scaledAbout(camera, 0.3, point);
        EXPECT_TRUE(picturePoint(closer, point, 1.6)->isApprox(*picturePoint(camera, point, 1.6), 1e-9));
        EXPECT_NEAR(pictureHeightAt(closer, point), 0.3 * pictureHeightAt(camera, point), 1e-12);
        const Camera back = scaledAbout(closer, 1 / 0.3, point);
        EXPECT_TRUE(back.eye.isApprox(camera.eye, 1e-9));
        EXPECT_TRUE(back.target.isApprox(camera.target, 1e-9));
    }
}

TEST(Camera, LooksAroundWhereItStands) {
    const Camera camera = framedCamera(organBox, StandardView::Front, 1);
    const Camera right = lookingAround(camera, std::acos(0.0), 0);
    EXPECT_EQ(right.eye, camera.eye);
    EXPECT_TRUE(cameraAxes(right).col(2).isApprox(-Vector3d::UnitX(), 1e-9)) << "towards +x";
    EXPECT_GT(lookingAround(camera, 0, 0.3).target.y(), camera.target.y() + 0.01);
    EXPECT_NEAR(distance(lookingAround(camera, 1, 10)), distance(camera), 1e-12);
}

TEST(Camera, NearPlaneFollowsTheEyeAmongWhatIsShown) {
    Camera camera = framedCamera(organBox, StandardView::Front, 1);
    camera.eye = organBox.center();
    camera.target = camera.eye - Vector3d::UnitZ();
    const double size = organBox.diagonal().norm();
    EXPECT_GT(clipped(camera, 1, camera.eye - 0.002 * size * Vector3d::UnitZ()).z(), -1) << "is not cut";
}
