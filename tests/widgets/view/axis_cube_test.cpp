#include "widgets/view/axis_cube.h"

#include <gtest/gtest.h>

using namespace esm;

namespace {
const Eigen::AlignedBox3d unitBox{Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()};
const QRectF square(10, 20, 80, 80);
} // namespace

TEST(AxisCube, StandardViewsShowTheirFaceOnly) {
    for (const StandardView view : {StandardView::Front, StandardView::Back, StandardView::Left,
                                    StandardView::Right, StandardView::Top, StandardView::Bottom}) {
        const Camera camera = framedCamera(unitBox, view, 1);
        const auto faces = visibleFaces(camera, square);
        ASSERT_EQ(faces.size(), 1U);
        EXPECT_EQ(faces[0].view, view);
        // Its text stands upright: the first corner is the top left one.
        EXPECT_LT(faces[0].outline[0].x(), faces[0].outline[1].x());
        EXPECT_LT(faces[0].outline[0].y(), faces[0].outline[3].y());
        EXPECT_EQ(viewAt(square.center(), camera, square), view);
    }
}

TEST(AxisCube, TurnedViewsOfferTheNeighbours) {
    const Camera camera = orbited(framedCamera(unitBox, StandardView::Front, 1), 0.6, 0.5);
    const auto faces = visibleFaces(camera, square);
    ASSERT_EQ(faces.size(), 3U);
    for (const CubeFace& face : faces) {
        EXPECT_TRUE(square.adjusted(-8, -8, 8, 8).contains(face.outline.boundingRect()));
        const QPointF middle = (face.outline[0] + face.outline[2]) / 2;
        EXPECT_EQ(viewAt(middle, camera, square), face.view);
    }
    EXPECT_FALSE(viewAt(QPointF(0, 0), camera, square));
}
