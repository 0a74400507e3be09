#include "widgets/plot/curve_chart.h"

#include "tests/support/eventually.h"

#include <QTest>
#include <QToolTip>
#include <qwt_scale_draw.h>

using namespace esm;

namespace {

class CurveChartTest : public testing::Test {
protected:
    CurveChartTest() {
        m_chart.resize(400, 260);
        m_chart.setAxes({"depth", "mm"}, {"force", "N"});
        m_chart.setEmptyText("nothing");
        m_chart.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&m_chart, patience));
    }

    void drawTwo() {
        m_chart.setCurves(
            {{"now", {{0, 0}, {1, 0.1}, {2, 0.3}}}, {"before", {{0, 0}, {1.5, 0.4}, {3, 0.9}}}});
    }
    /// Pixels of the canvas that are coloured like this.
    int countOf(const QColor& colour) {
        const QImage picture = m_chart.canvas()->grab().toImage();
        int count = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x)
                if (picture.pixelColor(x, y) == colour) ++count;
        return count;
    }

    CurveChart m_chart;
};

TEST_F(CurveChartTest, NumbersFollowTheTheme) {
    QPalette theme = m_chart.palette();
    theme.setColor(QPalette::PlaceholderText, QColor(1, 2, 3));
    m_chart.setPalette(theme);
    for (const int axis : {int(QwtPlot::xBottom), int(QwtPlot::yLeft)})
        EXPECT_EQ(m_chart.axisScaleDraw(axis)->label(1).color(), QColor(1, 2, 3));
}

TEST_F(CurveChartTest, EveryCurveHasRoomAndRisesToTheUpperRight) {
    drawTwo();
    for (const std::size_t curve : {0U, 1U})
        for (int point = 1; point < 3; ++point) {
            EXPECT_TRUE(m_chart.canvas()->rect().contains(m_chart.placeOf(curve, point)));
            EXPECT_GT(m_chart.placeOf(curve, point).x(), m_chart.placeOf(curve, point - 1).x());
            EXPECT_LT(m_chart.placeOf(curve, point).y(), m_chart.placeOf(curve, point - 1).y());
        }
    EXPECT_EQ(m_chart.placeOf(0, 0), m_chart.placeOf(1, 0)) << "both begin with nothing";
}

TEST_F(CurveChartTest, TheCurveOfBeforeIsPaler) {
    QPalette themed = m_chart.palette();
    themed.setColor(QPalette::PlaceholderText, QColor(120, 130, 140));
    m_chart.setPalette(themed);
    drawTwo();
    const QPalette colours = m_chart.palette();
    EXPECT_GT(countOf(colours.color(QPalette::Link)), 100);
    const int paler = countOf(colours.color(QPalette::PlaceholderText));
    m_chart.setCurves({{"now", {{0, 0}, {1, 0.1}, {2, 0.3}}}});
    EXPECT_GT(countOf(colours.color(QPalette::Link)), 100);
    EXPECT_GT(paler, countOf(colours.color(QPalette::PlaceholderText)));
}

TEST_F(CurveChartTest, SaysTheNumbersWhereTheMouseOrAKeyIs) {
    EXPECT_EQ(m_chart.spokenValue(), "nothing measured yet");
    m_chart.setCurves({{"now", {{0, 0}, {1, 0.1}, {2, 0.3}}}});
    EXPECT_EQ(m_chart.spokenValue(), "2.00 mm: 0.300 N");
    QTest::mouseMove(m_chart.canvas(), m_chart.placeOf(0, 1) + QPoint(2, 2));
    ESM_EVENTUALLY(m_chart.spokenValue() == "1.00 mm: 0.100 N");
    drawTwo();
    EXPECT_EQ(m_chart.spokenValue(), "now, 2.00 mm: 0.300 N; before, 3.00 mm: 0.900 N");
    m_chart.setFocus();
    QTest::keyClick(&m_chart, Qt::Key_Left);
    QTest::keyClick(&m_chart, Qt::Key_Left);
    EXPECT_EQ(m_chart.spokenValue(), "now, 1.00 mm: 0.100 N");
    for (int presses = 0; presses < 4; ++presses)
        QTest::keyClick(&m_chart, Qt::Key_Right);
    EXPECT_EQ(m_chart.spokenValue(), "now, 2.00 mm: 0.300 N") << "and stays at the end";
}

TEST_F(CurveChartTest, MarksATimeByALineAcross) {
    const std::vector<QPointF> falling{{0, 1}, {1, 0.4}, {2, 0.2}};
    const auto coloured = [&](std::optional<ChartMark> mark) {
        m_chart.setCurves({{"now", {falling.begin(), falling.end()}, std::move(mark)}});
        return countOf(m_chart.palette().color(QPalette::Link));
    };
    const int without = coloured(std::nullopt);
    EXPECT_GT(coloured(ChartMark{0.7, "time constant 0.70 s"}), without + 40);
    EXPECT_GT(coloured(ChartMark{1.99, "at the border"}), without + 40);
}

TEST_F(CurveChartTest, ACurveWithoutForceOrAPointIsNoTrouble) {
    m_chart.setCurves({{"now", {{0, 0}, {1, 0}}}, {"before", {}}});
    QTest::keyClick(&m_chart, Qt::Key_Right);
    EXPECT_TRUE(m_chart.canvas()->rect().contains(m_chart.placeOf(0, 1)));
    m_chart.setCurves({});
    QTest::keyClick(&m_chart, Qt::Key_Right);
    EXPECT_EQ(m_chart.spokenValue(), "nothing measured yet");
}

} // namespace
