#include "app/editor/window/status_line.h"

#include <gtest/gtest.h>

using namespace esm;

namespace {

PreviewStatus playingAt(double realTimeFactor, double timeStep) {
    PreviewStatus status;
    status.playing = true;
    status.integrator = Integrator::Split;
    status.timeStep = timeStep;
    status.realTimeFactor = realTimeFactor;
    return status;
}

class StatusLineTest : public testing::Test {
protected:
    QString message() const { return bar.findChild<QLabel*>("message")->text(); }
    void showForLong(const PreviewStatus& status) {
        line->showStatus(status);
        now += 2200;
        line->showStatus(status);
    }

    QStatusBar bar;
    qint64 now = 0; ///< ms
    StatusLine* line = new StatusLine(bar, [this] { return now; });
};

} // namespace

TEST_F(StatusLineTest, SaysThatTheTissueIsTooStiffWhileItIs) {
    line->showStatus(playingAt(0.02, 1e-6));
    EXPECT_EQ(message(), "") << "a moment is no harm";
    showForLong(playingAt(0.02, 1e-6));
    EXPECT_TRUE(message().contains("too stiff")) << message().toStdString();
    EXPECT_TRUE(message().contains("0.02")) << message().toStdString();
    line->showStatus(playingAt(3, 1e-3));
    EXPECT_EQ(message(), "");
}

TEST_F(StatusLineTest, BlamesNoStiffnessForManyNodes) {
    showForLong(playingAt(0.02, 0.01));
    EXPECT_TRUE(message().contains("too many nodes")) << message().toStdString();
    EXPECT_FALSE(message().contains("stiff"));
    showForLong(playingAt(0.02, 0.005));
    EXPECT_TRUE(message().contains("too many nodes")) << "where the longest step would not help either";
}

TEST_F(StatusLineTest, SaysThatTheChosenStepIsTooLongToBeWatched) {
    line->showNote("a note", "explained");
    PreviewStatus status = playingAt(30, 0.04);
    status.isShortened = true;
    line->showStatus(status);
    EXPECT_TRUE(message().contains("too long to be watched")) << message().toStdString();
    EXPECT_TRUE(message().contains("40 ms")) << message().toStdString();
    status.isShortened = false;
    line->showStatus(status);
    EXPECT_EQ(message(), "a note");
}

TEST_F(StatusLineTest, SaysThatTheMotionWentBackAndOnInShorterSteps) {
    PreviewStatus status = playingAt(3, 2e-3);
    status.halvings = 1;
    line->showStatus(status);
    EXPECT_TRUE(message().contains("2.0 ms")) << message().toStdString();
    EXPECT_TRUE(message().contains("went back")) << message().toStdString();
    status.failure = "the tissue flew apart";
    line->showStatus(status);
    EXPECT_EQ(message(), "the tissue flew apart");
    line->showStatus(playingAt(3, 4e-3));
    EXPECT_EQ(message(), "");
}
