#include "tests/support/eventually.h"
#include "widgets/plot/accuracy_chart.h"

#include <gmock/gmock.h>

#include <QSignalSpy>
#include <QTest>
#include <QToolTip>
#include <qwt_scale_div.h>

#include <limits>

using namespace esm;

namespace {

class AccuracyChartTest : public testing::Test {
protected:
    AccuracyChartTest() {
        m_chart.resize(320, 240);
        m_chart.setMostError(0.01);
        m_chart.setPoints({{0.5, 1e-4, "slow"}, {40, 2e-2, "fast"}, {5, 1e-3, "between"}, {2, 0.5, "poor"}},
                          {0, 1, 2});
        m_chart.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&m_chart, patience));
    }

    QWidget* canvas() { return m_chart.canvas(); }

    AccuracyChart m_chart;
};

TEST_F(AccuracyChartTest, FasterLiesFurtherRightAndLessErrorLower) {
    EXPECT_LT(m_chart.placeOf(0).x(), m_chart.placeOf(2).x());
    EXPECT_LT(m_chart.placeOf(2).x(), m_chart.placeOf(1).x());
    EXPECT_GT(m_chart.placeOf(0).y(), m_chart.placeOf(2).y());
    EXPECT_GT(m_chart.placeOf(2).y(), m_chart.placeOf(3).y());
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_TRUE(canvas()->rect().contains(m_chart.placeOf(i))) << i;
}

TEST_F(AccuracyChartTest, AClickMarksThePointBeneathAndADoubleClickChoosesIt) {
    std::vector<std::size_t> marked, chosen;
    QObject::connect(&m_chart, &AccuracyChart::marked, [&](std::size_t point) { marked.push_back(point); });
    QObject::connect(&m_chart, &AccuracyChart::chosen, [&](std::size_t point) { chosen.push_back(point); });
    for (const std::size_t point : {0U, 1U, 2U, 3U})
        QTest::mouseClick(canvas(), Qt::LeftButton, {}, m_chart.placeOf(point) + QPoint(2, -2));
    EXPECT_THAT(marked, testing::ElementsAre(0, 1, 2, 3));
    EXPECT_THAT(chosen, testing::IsEmpty());
    QTest::mouseDClick(canvas(), Qt::LeftButton, {}, m_chart.placeOf(1));
    EXPECT_THAT(chosen, testing::ElementsAre(1));
    const QPoint empty(5, 5);
    ASSERT_FALSE(m_chart.pointAt(empty));
    QTest::mouseDClick(canvas(), Qt::LeftButton, {}, empty);
    EXPECT_EQ(chosen.size(), 1U);
}

TEST_F(AccuracyChartTest, SaysWhatLiesUnderTheMouse) {
    QTest::mouseMove(canvas(), m_chart.placeOf(2));
    EXPECT_TRUE(QTest::qWaitFor([] { return QToolTip::text() == "between"; }, patience));
    EXPECT_EQ(canvas()->cursor().shape(), Qt::PointingHandCursor);
}

TEST_F(AccuracyChartTest, KeysGoFromSpeedToSpeedAndChoose) {
    std::vector<std::size_t> chosen;
    QObject::connect(&m_chart, &AccuracyChart::chosen, [&](std::size_t point) { chosen.push_back(point); });
    m_chart.setChosen(2);
    QTest::keyClick(&m_chart, Qt::Key_Right);
    QTest::keyClick(&m_chart, Qt::Key_Return);
    QTest::keyClick(&m_chart, Qt::Key_Right); // there is no faster one
    QTest::keyClick(&m_chart, Qt::Key_Left);
    QTest::keyClick(&m_chart, Qt::Key_Left);
    QTest::keyClick(&m_chart, Qt::Key_Enter);
    EXPECT_THAT(chosen, testing::ElementsAre(1, 3));
}

TEST_F(AccuracyChartTest, LeavesOutWhatLogarithmsCannotShow) {
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 infinite = std::numeric_limits<double>::infinity();
    m_chart.setPoints({{0, 0.1, ""}, {1, 0, ""}, {nan, 0.1, ""}, {1, infinite, ""}, {3, 0.1, ""}}, {0, 4});
    EXPECT_EQ(m_chart.pointAt(m_chart.placeOf(4)), 4U);
    std::vector<std::size_t> chosen;
    QObject::connect(&m_chart, &AccuracyChart::chosen, [&](std::size_t point) { chosen.push_back(point); });
    for (int presses = 0; presses < 5; ++presses) {
        QTest::keyClick(&m_chart, Qt::Key_Right);
        QTest::keyClick(&m_chart, Qt::Key_Return);
    }
    EXPECT_THAT(chosen, testing::Each(4));
    m_chart.setPoints({}, {});
    EXPECT_FALSE(m_chart.pointAt({100, 100}));
    QTest::keyClick(&m_chart, Qt::Key_Right);
}

TEST_F(AccuracyChartTest, CaptionsAndNumbersHaveRoomInASmallChart) {
    m_chart.setPoints({{0.1, 1e-6, "exact"}, {1e5, 0.5, "fast"}}, {0, 1});
    for (const QSize size : {QSize(230, 150), QSize(600, 300)}) {
        m_chart.resize(size);
        ESM_EVENTUALLY(m_chart.size() == size);
        QTest::qWait(0);
        const QFontMetrics metrics(m_chart.axisFont(QwtPlot::yLeft));
        EXPECT_LE(metrics.horizontalAdvance(m_chart.axisTitle(QwtPlot::yLeft).text()), canvas()->height());
        const auto numbers = m_chart.axisScaleDiv(QwtPlot::xBottom).ticks(QwtScaleDiv::MajorTick);
        ASSERT_GE(numbers.size(), 2);
        for (int i = 1; i < numbers.size(); ++i) {
            const double apart = m_chart.transform(QwtPlot::xBottom, numbers[i]) -
                                 m_chart.transform(QwtPlot::xBottom, numbers[i - 1]);
            EXPECT_GT(apart, metrics.horizontalAdvance(QString::number(numbers[i], 'g', 6)));
        }
    }
}

} // namespace
