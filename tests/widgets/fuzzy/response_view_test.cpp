#include "widgets/fuzzy/response_curve_view.h"
#include "widgets/fuzzy/response_map_view.h"

#include "core/exchange/fuzzy/fuzzy_file.h"
#include "tests/support/eventually.h"

#include <gtest/gtest.h>
#include <QApplication>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>

using namespace esm;

namespace {

const FuzzySystem& roboSim() {
    static const FuzzySystem system = fuzzyPreset("robo-sim");
    return system;
}

template<typename View> void open(View& view) {
    view.resize(view.sizeHint());
    view.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&view, patience));
}

/// What a view asks for.
struct SetInputs : std::vector<std::pair<std::optional<double>, std::optional<double>>> {
    explicit SetInputs(const ResponseView& view) {
        QObject::connect(&view, &ResponseView::inputsSet,
                         [this](auto across, auto up) { emplace_back(across, up); });
    }
};

class ResponseCurveViewTest : public testing::Test {
protected:
    ResponseCurveViewTest() {
        view.setAxes(roboSim().inputs[0], roboSim().outputs[0], {0, 100, "N/m"});
        view.setCurve({{{0, 10}, {2, 20}}, {{6, 60}, {10, 100}}});
        open(view);
    }
    int middle() const { return view.height() / 2; }

    ResponseCurveView view;
    SetInputs set{view};
    QSignalSpy finished{&view, &ResponseView::gestureFinished};
};

} // namespace

TEST_F(ResponseCurveViewTest, KnowsTheOutputAndItsGaps) {
    EXPECT_DOUBLE_EQ(view.outputAt(1).value(), 15);
    EXPECT_FALSE(view.outputAt(4));
    EXPECT_DOUBLE_EQ(view.outputAt(10).value(), 100);
}

TEST_F(ResponseCurveViewTest, AClickSetsTheInput) {
    QTest::mouseClick(&view, Qt::LeftButton, {}, {qRound(view.frame().x(7)), middle()});
    ASSERT_EQ(set.size(), 1u);
    EXPECT_NEAR(set[0].first.value(), 7, 0.05);
    EXPECT_FALSE(set[0].second);
    EXPECT_EQ(finished.count(), 1);
    QTest::mouseClick(&view, Qt::LeftButton, {}, {view.width() - 1, middle()});
    EXPECT_EQ(set[1].first, 10) << "beside the frame lies the nearer end";
}

TEST_F(ResponseCurveViewTest, TheArrowKeysStepTheInput) {
    QTest::keyClick(&view, Qt::Key_Right);
    EXPECT_TRUE(set.empty()) << "without a value there is nothing to step";
    view.setInputs(5, std::nullopt);
    QTest::keyClick(&view, Qt::Key_Right);
    ASSERT_EQ(set.size(), 1u);
    EXPECT_NEAR(set[0].first.value(), 5.1, 1e-12);
    EXPECT_EQ(finished.count(), 0);
    EXPECT_TRUE(finished.wait(5000));
}

TEST_F(ResponseCurveViewTest, ShowsWhatChanges) {
    const QImage empty = view.grab().toImage();
    view.setPresent(1, std::nullopt, 15);
    const QImage present = view.grab().toImage();
    EXPECT_NE(present, empty);
    view.setStale(true);
    EXPECT_NE(view.grab().toImage(), present);
}

TEST(ResponseMapView, SetsBothInputsWhereItIsClicked) {
    ResponseMapView view;
    view.setAxes({roboSim().inputs[0], roboSim().inputs[1], roboSim().outputs[0], {0, 100, "N/m"}});
    open(view);
    ResponseMap map{2, {10, 90, std::nullopt, 50}};
    view.setMap(map);
    EXPECT_EQ(view.outputAt(1, 1), 10);
    EXPECT_EQ(view.outputAt(9, 1), 90);
    EXPECT_EQ(view.outputAt(1, 9), std::nullopt);
    EXPECT_EQ(view.outputAt(9, 9), 50);
    const QImage picture = view.grab().toImage();
    const auto colourAt = [&](double across, double up) {
        return picture.pixelColor(view.frame().at(across, up).toPoint());
    };
    EXPECT_EQ(colourAt(1, 1), mapColour(0.1));
    EXPECT_EQ(colourAt(9, 9), mapColour(0.5));

    const SetInputs set(view);
    QTest::mouseClick(&view, Qt::LeftButton, {}, view.frame().at(7, 2).toPoint());
    ASSERT_EQ(set.size(), 1u);
    EXPECT_NEAR(set[0].first.value(), 7, 0.05);
    EXPECT_NEAR(set[0].second.value(), 2, 0.1);
    view.setInputs(7, 2);
    QTest::keyClick(&view, Qt::Key_Up);
    EXPECT_FALSE(set[1].first);
    EXPECT_NEAR(set[1].second.value(), 2.1, 1e-12);
    view.setInputs(7, std::nullopt);
    QTest::keyClick(&view, Qt::Key_Up);
    EXPECT_EQ(set.size(), 2u) << "what is left out has no step";
}

TEST(ResponseMapView, KnowsThePresentOutputExactlyAndOthersByCells) {
    ResponseMapView view;
    view.setAxes({roboSim().inputs[0], roboSim().inputs[1], roboSim().outputs[0], {0, 100, "N/m"}});
    open(view);
    view.setMap({2, {10, 90, std::nullopt, 50}});
    view.setPresent(7, 2, 88);
    const auto point = [&](double across, double up) {
        QMouseEvent move(QEvent::MouseMove, view.frame().at(across, up), Qt::NoButton, Qt::NoButton, {});
        QApplication::sendEvent(&view, &move);
    };
    point(7, 2);
    EXPECT_TRUE(view.said().endsWith(": 88.00 N/m")) << view.said().toStdString();
    point(9, 4);
    EXPECT_TRUE(view.said().endsWith(QString::fromUtf8(": ≈ 90.00 N/m"))) << view.said().toStdString();
    QTest::mousePress(&view, Qt::LeftButton, {}, view.frame().at(9, 4).toPoint());
    EXPECT_TRUE(view.said().endsWith(": 88.00 N/m")) << "until the new one is known";
}

TEST(MapColour, GrowsLighterAllTheWay) {
    for (int i = 0; i < 100; ++i)
        EXPECT_LT(qGray(mapColour(i / 100.0).rgb()), 1 + qGray(mapColour((i + 1) / 100.0).rgb()));
}

TEST(ScaleMarks, AreRoundAndFew) {
    EXPECT_EQ(scaleMarks({0, 100, {}}, 5), (std::vector<double>{0, 20, 40, 60, 80, 100}));
    EXPECT_EQ(scaleMarks({0.3, 2.2, {}}, 4), (std::vector<double>{0.5, 1, 1.5, 2}));
    EXPECT_EQ(scaleMarks({-7, 12, {}}, 3), (std::vector<double>{0, 10}));
}
