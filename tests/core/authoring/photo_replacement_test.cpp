#include "core/authoring/photo_replacement.h"

#include <gmock/gmock.h>

namespace esm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::shared_ptr<const Photo> photoOf(int width, int height, const char* name) {
    auto photo = std::make_shared<Photo>();
    photo->fileName = name;
    photo->image = {width, height,
                    std::vector<std::uint8_t>(4 * std::size_t(width) * std::size_t(height), 255)};
    return photo;
}

/// A photo of 200 × 100 pixels with something of everything that is counted in them.
TextureLayer preparedLayer() {
    TextureLayer layer;
    layer.name = "before";
    layer.photo = photoOf(200, 100, "before.png");
    layer.projector.width = 0.2;
    layer.projector.height = 0.1;
    layer.projector.intrinsics = Intrinsics{300, 310, 90, 55};
    layer.blendPixels = 8;
    layer.opacity = 0.5;
    layer.landmarks.push_back({{20, 30}, {1, 2, 3}});
    layer.strokes.push_back(std::make_shared<const BrushStroke>());
    PhotoPreparation preparation;
    preparation.field = PhotoField::circle({100, 50}, 40);
    preparation.strokes.push_back({{{10, 20}}, 5, 0, false, false});
    preparation.lens = Lens{LensKind::Pinhole, {250, 250, 100, 50}, {-0.1}};
    preparation.crop = PhotoCrop{50, 10, 100, 80};
    prepare(layer, preparation);
    return layer;
}

TEST(PhotoReplacement, ScalesWhatIsCountedInPixels) {
    const TextureLayer before = preparedLayer();
    const TextureLayer after = withPhoto(before, photoOf(400, 200, "after.png"));
    const PhotoPreparation& preparation = after.preparation;
    EXPECT_EQ(preparation.field->centre, Eigen::Vector2d(200, 100));
    EXPECT_EQ(preparation.field->radii, Eigen::Vector2d(80, 80));
    EXPECT_EQ(preparation.strokes[0].path[0], Eigen::Vector2d(20, 40));
    EXPECT_EQ(preparation.strokes[0].radius, 10);
    EXPECT_EQ(preparation.lens->camera, (Intrinsics{500, 500, 200, 100}));
    EXPECT_EQ(preparation.lens->coefficients, before.preparation.lens->coefficients);
    EXPECT_EQ(*preparation.crop, (PhotoCrop{100, 20, 200, 160}));
    EXPECT_EQ(*after.projector.intrinsics, (Intrinsics{600, 620, 180, 110}));
    EXPECT_EQ(after.landmarks[0].photo, Eigen::Vector2d(40, 60));
    EXPECT_EQ(after.blendPixels, 16);
    EXPECT_EQ(after.prepared->width, 400);
}

TEST(PhotoReplacement, KeepsPlacementAndWhatIsPaintedOnTheOrgan) {
    const TextureLayer before = preparedLayer();
    TextureLayer after = withPhoto(before, photoOf(100, 50, "after.png"));
    EXPECT_EQ(after.projector.width, before.projector.width);
    EXPECT_EQ(after.projector.height, before.projector.height);
    EXPECT_EQ(after.strokes, before.strokes);
    EXPECT_EQ(after.landmarks[0].organ, before.landmarks[0].organ);
    EXPECT_EQ(after.opacity, before.opacity);
    EXPECT_EQ(after.name, "after") << "it was the file's";
    TextureLayer named = before;
    named.name = "Polyp";
    EXPECT_EQ(withPhoto(named, photoOf(100, 50, "after.png")).name, "Polyp");
}

TEST(PhotoReplacement, OfAnotherShapeKeepsHeightAndMiddle) {
    const TextureLayer before = preparedLayer();
    const TextureLayer after = withPhoto(before, photoOf(150, 100, "after.png"));
    EXPECT_DOUBLE_EQ(after.projector.height, before.projector.height);
    EXPECT_DOUBLE_EQ(after.projector.width, 0.15) << "a pixel stays as large on the organ";
    EXPECT_EQ(after.landmarks[0].photo, Eigen::Vector2d(-5, 30));
    EXPECT_EQ(*after.preparation.crop, (PhotoCrop{25, 10, 100, 80}));
    EXPECT_THAT(replacementRemarks(before, after), ElementsAre(HasSubstr("another shape")));
}

TEST(PhotoReplacement, DropsACropOfWhichNothingIsLeft) {
    TextureLayer before = preparedLayer();
    before.preparation.crop = PhotoCrop{0, 0, 20, 20};
    const TextureLayer after = withPhoto(before, photoOf(100, 100, "after.png"));
    EXPECT_FALSE(after.preparation.crop);
    EXPECT_THAT(replacementRemarks(before, after),
                ElementsAre(HasSubstr("another shape"), HasSubstr("crop")));
}

TEST(PhotoReplacement, SaysThatColoursWereThoseOfThePhotoBefore) {
    TextureLayer before = preparedLayer();
    before.preparation.whiteBalance = ColourGains{1.1, 1, 0.9};
    const TextureLayer after = withPhoto(before, photoOf(200, 100, "after.png"));
    EXPECT_EQ(after.preparation.whiteBalance, before.preparation.whiteBalance);
    EXPECT_THAT(replacementRemarks(before, after), ElementsAre(HasSubstr("white balance")));
}

TEST(PhotoReplacement, OneShapeIsToldToWithinAPixel) {
    const auto image = [](int width, int height) { return Image{width, height, {}}; };
    EXPECT_TRUE(haveOneShape(image(1920, 1080), image(1280, 720)));
    EXPECT_TRUE(haveOneShape(image(1921, 1080), image(640, 360)));
    EXPECT_TRUE(haveOneShape(image(640, 360), image(1921, 1080)));
    EXPECT_FALSE(haveOneShape(image(720, 576), image(720, 540)));
    EXPECT_FALSE(haveOneShape(image(100, 200), image(200, 100)));
}

} // namespace
} // namespace esm
