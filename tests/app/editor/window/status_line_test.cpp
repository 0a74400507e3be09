#include "app/editor/window/status_line.h"

#include "tests/support/eventually.h"

#include <gtest/gtest.h>
#include <QVariant>

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
    void SetUp() override { bar.resize(1440, 24); }
    QString message() const { return bar.findChild<QLabel*>("message")->text(); }

    QStatusBar bar;
    qint64 now = 0; ///< ms
    StatusLine* line = new StatusLine(bar, [this] { return now; });
};

} // namespace

TEST_F(StatusLineTest, SaysWhetherTheTissueMovesAtItsRealSpeed) {
    const auto speed = [this] { return bar.findChild<QLabel*>("realTime"); };
    line->showStatus(playingAt(29, 0.01));
    EXPECT_EQ(speed()->text(), "real speed, up to 29×");
    EXPECT_FALSE(speed()->property("warning").toBool());
    line->showStatus(playingAt(0.1, 0.01));
    EXPECT_EQ(speed()->text(), "0.10 of real speed");
    EXPECT_TRUE(speed()->property("warning").toBool());
    EXPECT_TRUE(speed()->toolTip().contains("10 seconds")) << speed()->toolTip().toStdString();
    line->showStatus(PreviewStatus());
    EXPECT_EQ(speed()->text(), "paused");
    EXPECT_FALSE(speed()->property("warning").toBool());
}

TEST_F(StatusLineTest, NamesMethodAndStepInWords) {
    line->showStatus(playingAt(29, 0.01));
    EXPECT_EQ(bar.findChild<QLabel*>("stepping")->text(), "viscous split, 10 ms steps");
    line->showStatus(PreviewStatus());
    EXPECT_EQ(bar.findChild<QLabel*>("stepping")->text(), "");
    bar.resize(800, 24);
    line->showStatus(playingAt(29, 0.01));
    EXPECT_EQ(bar.findChild<QLabel*>("stepping")->text(), "10 ms steps") << "the method is in the tool tip";
    EXPECT_LE(bar.minimumSizeHint().width(), 800);
}

TEST_F(StatusLineTest, SaysWhyTheChosenStepIsNotUsed) {
    PreviewStatus status = playingAt(3, 1e-3);
    status.replaced = Replaced::BeyondSafe;
    line->showStatus(status);
    EXPECT_TRUE(message().contains("not safe")) << message().toStdString();
    status.replaced = Replaced::RanWild;
    line->showStatus(status);
    EXPECT_TRUE(message().contains("ran wild")) << message().toStdString();
}

TEST_F(StatusLineTest, SaysThatTheChosenStepIsTooLongToBeWatched) {
    line->showNote("a note", "explained");
    PreviewStatus status = playingAt(30, 0.04);
    status.isShortened = true;
    line->showStatus(status);
    EXPECT_TRUE(message().contains("the chosen step is longer")) << message().toStdString();
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
    EXPECT_EQ(message(), "The tissue flew apart");
    line->showStatus(playingAt(3, 4e-3));
    EXPECT_EQ(message(), "");
}

TEST_F(StatusLineTest, TellsOfWorkBesideTheWindowUntilItIsDone) {
    line->showNote("a note", "explained");
    line->showWork("Redrawing the photos… 40 %");
    EXPECT_EQ(message(), "Redrawing the photos… 40 %");
    line->showMessage("Saved organ.esm.");
    line->showWork("Redrawing the photos… 50 %");
    EXPECT_EQ(message(), "Saved organ.esm.") << "what was done is read first";
    line->showMessage({});
    EXPECT_EQ(message(), "Redrawing the photos… 50 %");
    line->showWork({});
    EXPECT_EQ(message(), "a note");
}

TEST_F(StatusLineTest, WhatIsDoneByItselfLetsAMessageBeRead) {
    line->showAside("Photos redrawn in 1 s");
    EXPECT_EQ(message(), "Photos redrawn in 1 s");
    line->showAside("Photos redrawn in 2 s");
    EXPECT_EQ(message(), "Photos redrawn in 2 s");
    line->showMessage("Saved organ.esm.");
    line->showAside("Photos redrawn in 3 s");
    EXPECT_EQ(message(), "Saved organ.esm.");
    line->showMessage({});
    line->showAside("Photos redrawn in 4 s");
    EXPECT_EQ(message(), "Photos redrawn in 4 s");
}

TEST_F(StatusLineTest, AMessageHasRoomInANarrowWindowAndTheRestComesBack) {
    bar.show();
    bar.resize(784, 24);
    line->showStatus(playingAt(29, 0.01));
    const auto* shown = bar.findChild<QLabel*>("message");
    const auto* rate = bar.findChild<QLabel*>("frameRate");
    EXPECT_TRUE(rate->isVisible());
    line->showMessage("Imported liver-of-the-third-patient.obj: 2496 nodes, 7 slits closed");
    ESM_EVENTUALLY(shown->width() >= shown->sizeHint().width());
    EXPECT_FALSE(rate->isVisible());
    EXPECT_EQ(shown->toolTip(), shown->text());
    line->showMessage({});
    EXPECT_TRUE(rate->isVisible());
}
