#include "widgets/view/picture_maker.h"

#include "tests/support/eventually.h"

#include <QSemaphore>

#include <new>
#include <utility>
#include <vector>

using namespace esm;

namespace {

/// Pictures of nothing, drawn one at a time as the test lets them.
class PictureMakerTest : public testing::Test {
protected:
    PictureMakerTest() {
        QObject::connect(
            &maker, &PictureMaker::made, &maker,
            [this] {
                const MadePicture picture = maker.picture();
                shown.emplace_back(picture.number, picture.isSmooth);
                made.release();
            },
            Qt::DirectConnection);
    }
    ~PictureMakerTest() override { mayGoOn.release(100); }

    DrawnPicture draw(const PictureContent& content, int samples) {
        begun.release();
        mayGoOn.tryAcquire(1, patience);
        if (fails) throw std::bad_alloc();
        drawnSamples.push_back(samples);
        drawnWidths.push_back(content.size.width);
        return {QImage(1, 1, QImage::Format_RGB32), time};
    }
    /// Waits until a drawing begins.
    void begin() { ASSERT_TRUE(begun.tryAcquire(1, patience)); }
    /// Lets the drawing that began come to its end.
    void finish() {
        mayGoOn.release();
        ASSERT_TRUE(made.tryAcquire(1, patience));
    }
    void drawOne() {
        begin();
        finish();
    }

    QSemaphore begun, mayGoOn, made;
    std::chrono::steady_clock::duration time{0}; ///< that each drawing says it took
    bool fails = false;
    std::vector<int> drawnSamples, drawnWidths;
    std::vector<std::pair<int, bool>> shown; ///< number of the content, and whether it was smooth
    PictureMaker maker{[this](const PictureContent& content, int samples) { return draw(content, samples); }};
};

using Shown = std::vector<std::pair<int, bool>>;

} // namespace

TEST_F(PictureMakerTest, TheNewestContentWins) {
    EXPECT_EQ(maker.ask({}), 1);
    begin();
    for (int number = 2; number <= 4; ++number)
        EXPECT_EQ(maker.ask({}), number) << "nobody waits for a picture";
    EXPECT_EQ(maker.picture().number, 0);
    finish();
    drawOne();
    EXPECT_EQ(shown, (Shown{{1, true}, {4, true}}));
    EXPECT_FALSE(maker.picture().image.isNull());
}

TEST_F(PictureMakerTest, ADraftComesFirstWhereSmoothEdgesTakeLong) {
    time = std::chrono::hours(1);
    maker.ask({});
    drawOne();
    maker.ask({});
    drawOne();
    drawOne();
    EXPECT_EQ(shown, (Shown{{1, true}, {2, false}, {2, true}}));
    ASSERT_EQ(drawnSamples.size(), 3U);
    EXPECT_GT(drawnSamples[0], 0);
    EXPECT_EQ(drawnSamples[1], 0);
    EXPECT_GT(drawnSamples[2], 0);
}

TEST_F(PictureMakerTest, SmoothEdgesGiveWayToNewerContent) {
    time = std::chrono::hours(1);
    maker.ask({});
    drawOne();
    maker.ask({});
    begin();
    maker.ask({});
    finish();
    drawOne();
    drawOne();
    EXPECT_EQ(shown, (Shown{{1, true}, {2, false}, {3, false}, {3, true}}));
}

TEST_F(PictureMakerTest, APhotoInMotionIsDrawnCoarselyWhereWholePicturesAreLate) {
    time = std::chrono::hours(1);
    PictureContent content;
    content.size = {100, 80, 1};
    maker.ask(content);
    drawOne();
    content.scene.projectedPhoto.emplace();
    for (int i = 0; i < 2; ++i) {
        maker.ask(content);
        drawOne();
        drawOne();
    }
    EXPECT_EQ(drawnWidths, (std::vector<int>{100, 100, 100, 50, 100})) << "the smooth one at rest is whole";
    maker.ask(content);
    drawOne();
    EXPECT_EQ(drawnWidths.back(), 50);
    EXPECT_EQ(maker.picture().image.size(), QSize(100, 80)) << "enlarged before it is shown";
    drawOne();
    content.scene.projectedPhoto.reset();
    maker.ask(content);
    drawOne();
    drawOne();
    EXPECT_EQ(drawnWidths[7], 100) << "without a photo";
}

TEST_F(PictureMakerTest, SaysWhyThereIsNoPictureAndGoesOn) {
    fails = true;
    maker.ask({});
    drawOne();
    EXPECT_EQ(maker.picture().problem, "there is not enough memory for it");
    EXPECT_TRUE(maker.picture().image.isNull());
    fails = false;
    maker.ask({});
    drawOne();
    EXPECT_EQ(maker.picture().problem, "");
    EXPECT_FALSE(maker.picture().image.isNull());
}
