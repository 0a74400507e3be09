#include "app/editor/workers/preview.h"
#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"
#include "widgets/inputs/value_slider.h"
#include "widgets/inputs/vector_field.h"

#include <QAbstractButton>
#include <QListWidget>
#include <QSignalSpy>

using namespace esm;

namespace {

/// Keys sent to the control that has the focus, as a keyboard does.
class KeysTest : public EditorTest {
protected:
    void SetUp() override {
        open(makeSample("tube"));
        press(Qt::Key_R, Qt::ControlModifier);
    }
    void type(QWidget* control, Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        control->setFocus();
        QTest::keyClick(control, key, modifiers);
    }
    ValueSlider* inputSlider() const {
        const Region& region = project().regions.back();
        const auto name = "input-" + region.system->inputs[0].name;
        return window->findChild<QWidget*>(QString::fromStdString(name))->findChild<ValueSlider*>();
    }
    /// Two keys in one movement, and one after a rest.
    template<typename Control> void typeTwiceAndOnceMore(Control* control, Qt::Key key) {
        auto* steps = window->document().undoStack();
        const int before = steps->count();
        control->setPause(std::chrono::hours(1));
        type(control, key);
        type(control, key);
        EXPECT_EQ(steps->count(), before + 1);
        QSignalSpy finished(control, &Control::gestureFinished);
        control->setPause(std::chrono::milliseconds(0));
        ASSERT_TRUE(finished.wait());
        type(control, key);
        EXPECT_EQ(steps->count(), before + 2);
    }
    Eigen::Vector3d viewDirection() const {
        const Camera& camera = window->view().camera();
        return (camera.eye - camera.target).normalized();
    }
};

} // namespace

TEST_F(KeysTest, UndoReachesTheProjectFromANumberField) {
    auto* field = child<QWidget>("ellipsoidCentre")->findChild<QLineEdit*>();
    const double before = project().regions.back().ellipsoid->centre.x();
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, "77");
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_DOUBLE_EQ(project().regions.back().ellipsoid->centre.x(), 0.077);
    type(field, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_DOUBLE_EQ(project().regions.back().ellipsoid->centre.x(), before);
    type(field, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_DOUBLE_EQ(project().regions.back().ellipsoid->centre.x(), 0.077);
}

TEST_F(KeysTest, HomeGoesToTheFocusedSlider) {
    const double least = project().regions.back().system->inputs[0].minimum;
    type(inputSlider(), Qt::Key_Home);
    EXPECT_EQ(project().regions.back().inputs[0].second, least);
}

TEST_F(KeysTest, SpacePressesTheFocusedButton) {
    ESM_EVENTUALLY(window->preview().status().playing);
    auto* hold = child<QAbstractButton>("holdButton");
    type(hold, Qt::Key_Space);
    EXPECT_TRUE(project().regions.back().held.springConstant || project().regions.back().held.viscosity ||
                project().regions.back().held.mass);
    EXPECT_TRUE(window->preview().status().playing);
}

TEST_F(KeysTest, SlidersOfTwoRegionsAreTwoSteps) {
    press(Qt::Key_R, Qt::ControlModifier);
    auto* list = child<QListWidget>("regionList");
    auto* steps = window->document().undoStack();
    const int before = steps->count();
    type(inputSlider(), Qt::Key_End);
    list->setCurrentRow(1);
    QTest::keyClick(inputSlider(), Qt::Key_End);
    EXPECT_EQ(steps->count(), before + 2);
}

TEST_F(KeysTest, SliderKeysAfterAPauseAreAnotherStep) {
    typeTwiceAndOnceMore(inputSlider(), Qt::Key_Right);
}

TEST_F(KeysTest, ArrowsInANumberFieldAreOneStepUntilTheyRest) {
    auto* steps = window->document().undoStack();
    const double mass = project().base.mass;
    const int before = steps->count();
    typeTwiceAndOnceMore(massField(), Qt::Key_Up);
    steps->setIndex(before);
    EXPECT_EQ(project().base.mass, mass);
}

TEST_F(KeysTest, ArrowsInAVectorFieldAreOneStep) {
    auto* steps = window->document().undoStack();
    const int before = steps->count();
    NumberField* x = child<VectorField>("ellipsoidCentre")->field(0);
    x->setPause(std::chrono::hours(1));
    for (int i = 0; i < 3; ++i)
        type(x, Qt::Key_Up);
    EXPECT_EQ(steps->count(), before + 1);
}

TEST_F(KeysTest, TypedValuesAreAStepEach) {
    auto* steps = window->document().undoStack();
    const int before = steps->count();
    for (const char* mass : {"0.5", "0.75"}) {
        typeInto(massField(), mass);
        QTest::keyClick(massField(), Qt::Key_Return);
    }
    EXPECT_EQ(steps->count(), before + 2);
}

TEST_F(KeysTest, TakeViewsAndTools) {
    press(Qt::Key_4);
    EXPECT_TRUE(viewDirection().isApprox(Eigen::Vector3d::UnitX(), 1e-9));
    press(Qt::Key_5);
    EXPECT_TRUE(viewDirection().isApprox(Eigen::Vector3d::UnitY(), 1e-9));
    press(Qt::Key_E);
    EXPECT_EQ(toolInHand(), "region");
    press(Qt::Key_V);
    EXPECT_EQ(toolInHand(), "look");
}
