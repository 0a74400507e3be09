#include "core/texture/photo/photo_field.h"

#include "core/texture/photo/photo.h"
#include "tests/core/texture/photo/drawn_photo.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

using namespace esm;

TEST(PhotoField, IsFoundWhereItIs) {
    for (const auto& [cx, cy, radius] : {std::array<double, 3>{320.3, 236.8, 200.4}, {300, 260, 290.5}}) {
        const auto field = findField(roundPhoto(cx, cy, radius));
        ASSERT_TRUE(field);
        EXPECT_NEAR(field->centre.x(), cx, 1);
        EXPECT_NEAR(field->centre.y(), cy, 1);
        EXPECT_TRUE(field->isCircle());
        EXPECT_NEAR(field->radii.x(), radius, 1);
    }
}

TEST(PhotoField, IsNotFoundWhereThereIsNone) {
    EXPECT_FALSE(findField({}));
    EXPECT_FALSE(findField(drawnPhoto(200, 100, [](int, int) -> Channels { return {}; })));
    EXPECT_FALSE(findField(drawnPhoto(200, 100, [](int x, int y) -> Channels {
        return {scattered(x, y, 255), 90, 80, 255};
    })));
    // Dark tissue in a corner ends slowly.
    EXPECT_FALSE(findField(drawnPhoto(200, 160, [](int x, int y) -> Channels {
        const int level = std::min(200, 2 * std::max(0, x + y - 40));
        return {level, level / 2, level / 3, 255};
    })));
}

TEST(PhotoField, IsFoundInALaparoscopicPhoto) {
    ESM_SKIP_WITHOUT(sharedData("images/lap-liver-gallbladder.jpg"));
    const auto field = findField(loadPhoto(sharedData("images/lap-liver-gallbladder.jpg"))->image);
    ASSERT_TRUE(field);
    // By eye: the field spans the columns 175 to 1581, and of its chords at the rows 0 and 1074 the half
    // lengths are 431 and 487, which puts its centre between the rows 555 and 568.
    EXPECT_NEAR(field->centre.x(), 878, 6);
    EXPECT_NEAR(field->centre.y(), 561, 7);
    EXPECT_NEAR(field->radii.x(), 703, 6);
}

TEST(PhotoField, IsFoundWithAGlowAroundIt) {
    Image photo = roundPhoto(320, 240, 200);
    for (int y = 0; y < photo.height; ++y)
        for (int x = 0; x < photo.width; ++x) {
            const double outside = std::hypot(x + 0.5 - 320, y + 0.5 - 240) - 203;
            if (outside < 0) continue;
            const int glow = std::max(0, 20 - static_cast<int>(outside / (x > 320 ? 4 : 2)));
            std::fill_n(photo.at(x, y), 3, static_cast<std::uint8_t>(glow));
        }
    const auto field = findField(photo);
    ASSERT_TRUE(field);
    EXPECT_NEAR(field->radii.x(), 200, 1);
}

TEST(PhotoField, IsFoundInASinusPhoto) {
    ESM_SKIP_WITHOUT(sharedData("images/sinus-sfm/00004584.jpg"));
    const auto field = findField(loadPhoto(sharedData("images/sinus-sfm/00004584.jpg"))->image);
    ASSERT_TRUE(field);
    // By eye: the field spans the columns 467 to 1522, at the row 540; above and below, the frame of the
    // straightened photo bends into it, so that the circle of this width would show black at the rows 60 and
    // 1045.
    EXPECT_EQ(field->shape, FieldShape::Polygon);
    EXPECT_NEAR(distanceInside(*field, {467, 540}), 0, 6);
    EXPECT_NEAR(distanceInside(*field, {1522, 540}), 0, 6);
    EXPECT_LT(distanceInside(*field, {994, 60}), 0);
    EXPECT_LT(distanceInside(*field, {900, 1045}), 0);
    EXPECT_GT(distanceInside(*field, {994, 540}), 400);
}

TEST(PhotoField, IsMaskedWithAnEdgeOfOnePixel) {
    Image photo = drawnPhoto(100, 100, [](int, int) -> Channels { return {9, 9, 9, 255}; });
    maskField(photo, PhotoField::circle({50, 50}, 40, 10));
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x) {
            const double distance = std::hypot(x + 0.5 - 50, y + 0.5 - 50);
            const int alpha = photo.at(x, y)[3];
            EXPECT_TRUE(distance > 35.49 || alpha == 255);
            EXPECT_TRUE(distance < 36.51 || alpha == 0);
        }
}

TEST(PhotoField, OfAnyShapeIsFoundAroundABrightRectangle) {
    const auto field = findField(drawnPhoto(200, 160, [](int x, int y) -> Channels {
        const int level = x > 40 && x < 160 && y > 30 && y < 130 ? 150 : 0;
        return {level, level, level, 255};
    }));
    ASSERT_TRUE(field);
    EXPECT_EQ(field->corners.size(), 4U);
    for (const Eigen::Vector2d& corner : field->corners)
        EXPECT_NEAR(std::min(std::abs(corner.x() - 41), std::abs(corner.x() - 160)) +
                        std::min(std::abs(corner.y() - 31), std::abs(corner.y() - 130)),
                    0, 1.5);
}

TEST(PhotoField, OfAnyShapeIsMaskedByItsOutline) {
    const Image white = drawnPhoto(120, 90, [](int, int) -> Channels { return {9, 9, 9, 255}; });
    const PhotoField ellipse{FieldShape::Ellipse, {60, 45}, {50, 20}, 30, {}, 0};
    const PhotoField polygon{FieldShape::Polygon, {}, {}, 0, {{20, 5}, {110, 30}, {60, 85}}, 0};
    for (const PhotoField& field : {ellipse, polygon}) {
        Image masked = white;
        maskField(masked, field);
        for (int y = 0; y < 90; ++y)
            for (int x = 0; x < 120; ++x) {
                const double inside = distanceInside(field, {x + 0.5, y + 0.5});
                EXPECT_TRUE(inside < 0.9 || masked.at(x, y)[3] == 255) << x << ' ' << y;
                EXPECT_TRUE(inside > -0.9 || masked.at(x, y)[3] == 0) << x << ' ' << y;
            }
    }
}

TEST(PhotoField, IsFoundInEveryPictureOfAnEndoscope) {
    ESM_SKIP_WITHOUT(sharedData("images/hk-oesophagus.png"));
    // By eye: places just inside and just outside of the field's rim, at its corners.
    const auto expectRim = [](const char* name, const std::vector<Eigen::Vector2d>& in,
                              const std::vector<Eigen::Vector2d>& out) {
        const auto field = findField(loadPhoto(sharedData(std::string("images/") + name))->image);
        ASSERT_TRUE(field) << name;
        for (const Eigen::Vector2d& place : in)
            EXPECT_GT(distanceInside(*field, place), 0) << name << ' ' << place.transpose();
        for (const Eigen::Vector2d& place : out)
            EXPECT_LT(distanceInside(*field, place), 0) << name << ' ' << place.transpose();
    };
    expectRim("hk-oesophagus.png", {{60, 20}, {225, 20}, {60, 260}}, {{20, 10}, {265, 10}, {15, 270}});
    expectRim("hk-colon-polyp.png", {{60, 30}, {230, 30}, {225, 250}}, {{25, 10}, {265, 10}, {265, 265}});
    expectRim("hk-colon-lumen.png", {{70, 20}, {230, 15}}, {{15, 15}, {270, 10}, {270, 270}});
    expectRim("hk-colon-bowelprep.png", {{70, 30}, {220, 20}}, {{10, 10}, {270, 10}});
    expectRim("hk-stomach-retroflex.png", {{70, 30}, {70, 250}}, {{15, 15}, {15, 265}});
    EXPECT_FALSE(findField(loadPhoto(sharedData("images/tex-sofa-liver-square.png"))->image));
    EXPECT_FALSE(findField(loadPhoto(sharedData("images/tex-sofa-head-baked.png"))->image));
}
