#include "app/editor/window/slow_motion.h"

#include "core/project/detail_change.h"
#include "core/samples/samples.h"

#include <gtest/gtest.h>
#include <QToolButton>
#include <QVariant>

using namespace esm;

namespace {

PreviewStatus movingAt(double realTimeFactor) {
    PreviewStatus status;
    status.playing = true;
    status.realTimeFactor = realTimeFactor;
    return status;
}

class SlowMotionTest : public testing::Test {
protected:
    void SetUp() override {
        view.resize(800, 500);
        view.show();
    }
    bool isSaid() const { return notice()->isVisible(); }
    QWidget* notice() const { return view.findChild<QWidget*>("viewNotice"); }
    QPushButton* help() const { return view.findChild<QPushButton*>("viewNoticeHelp"); }
    QString text() const { return view.findChild<QLabel*>("viewNoticeText")->text(); }
    void showForLong(double realTimeFactor) {
        slow.showStatus(movingAt(realTimeFactor));
        now += 2100;
        slow.showStatus(movingAt(realTimeFactor));
    }

    QWidget view;
    qint64 now = 0; ///< ms
    Document document{makeSample("liver")};
    SlowMotion slow{view, document, [this] { return now; }};
};

} // namespace

TEST_F(SlowMotionTest, IsSaidWhereOneLooksAndOffersFewerNodes) {
    slow.showStatus(movingAt(0.1));
    EXPECT_FALSE(isSaid()) << "a moment is no harm";
    showForLong(0.1);
    EXPECT_TRUE(isSaid());
    EXPECT_TRUE(text().contains("0.1 of its real speed")) << text().toStdString();
    EXPECT_TRUE(text().contains("10 times")) << text().toStdString();
    std::size_t asked = 0;
    QObject::connect(&slow, &SlowMotion::fewerNodesAsked, [&](std::size_t nodes) { asked = nodes; });
    help()->click();
    EXPECT_EQ(asked, nodesAtRealSpeed(document.project().network->restPositions.size(), 0.1));
}

TEST_F(SlowMotionTest, GoesWithTheSlowness) {
    showForLong(0.5);
    ASSERT_TRUE(isSaid());
    slow.showStatus(PreviewStatus());
    EXPECT_TRUE(isSaid()) << "what is paused is slow still";
    showForLong(1.2);
    EXPECT_FALSE(isSaid());
}

TEST_F(SlowMotionTest, StaysAsItIsWhileSpeedWavers) {
    showForLong(0.2);
    const QString said = text(), offered = help()->text();
    for (const double speed : {0.15, 1.1, 0.3, 0.9, 0.2}) {
        slow.showStatus(movingAt(speed));
        now += 1500;
        EXPECT_TRUE(isSaid()) << speed;
        EXPECT_EQ(text(), said) << speed;
        EXPECT_EQ(help()->text(), offered) << speed;
    }
    showForLong(0.05);
    EXPECT_NE(text(), said) << "that is another speed";
}

TEST_F(SlowMotionTest, TakenAwayItStaysAwayUntilThereIsAnotherOrgan) {
    showForLong(0.5);
    view.findChild<QToolButton*>("quietButton")->click();
    EXPECT_FALSE(isSaid());
    showForLong(0.4);
    EXPECT_FALSE(isSaid());
    document.replace(makeSample("tube"), std::nullopt);
    showForLong(0.4);
    EXPECT_TRUE(isSaid());
}

TEST_F(SlowMotionTest, WhatCannotHaveFewerNodesIsOfferedNone) {
    document.replace(makeSample("tube"), std::nullopt); // 170 nodes
    showForLong(0.4);
    EXPECT_TRUE(isSaid());
    EXPECT_FALSE(help()->isVisible());
}

TEST_F(SlowMotionTest, AWallOfPrismsIsOfferedNone) {
    document.replace(withDetail(makeSample("liver"),
                                {Detail::Kind::Filled, 0, LatticeFilling{LatticeKind::Prisms, 0, 0.003, 2}}),
                     std::nullopt);
    showForLong(0.1);
    EXPECT_TRUE(isSaid());
    EXPECT_FALSE(help()->isVisible());
}

TEST(NodesAtRealSpeed, AreFewerTheSlowerItIsAndNeverTooFew) {
    EXPECT_EQ(nodesAtRealSpeed(50000, 0.1), 4000U);
    EXPECT_LT(nodesAtRealSpeed(50000, 0.79), 50000U);
    EXPECT_GT(nodesAtRealSpeed(50000, 0.5), nodesAtRealSpeed(50000, 0.25));
    EXPECT_EQ(nodesAtRealSpeed(1000, 0.001), 200U);
}
