#include "app/editor/window/theme.h"
#include "core/authoring/regions.h"
#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"
#include "tests/support/test_meshes.h"
#include "widgets/inputs/vector_field.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QMouseEvent>
#include <QScrollArea>
#include <QSlider>
#include <QStyleOptionFrame>
#include <QToolBar>
#include <QToolButton>

using namespace esm;

namespace {

class PanelsTest : public EditorTest {
protected:
    void SetUp() override {
        applyTheme(*qApp, Theme::Dark);
        open(makeSample("tube"));
    }

    void type(QLineEdit* field, const QString& text) {
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
    }
    std::string degreesOf(const char* row) const {
        return child<QWidget>(row)->findChild<QLabel*>("degrees")->text().toStdString();
    }
    QLineEdit* fieldOf(const char* row) const {
        return child<QWidget>(row)->findChild<QLineEdit*>("numberField");
    }
};

} // namespace

TEST_F(PanelsTest, SizeAndCentreShowTheirUnit) {
    TriangleMesh mesh = test::torus(24, 12, 0.015, 0.006);
    for (Eigen::Vector3d& vertex : mesh.vertices)
        vertex += Eigen::Vector3d(-0.0437, -0.0372, -0.0467);
    open(makeProject("small", {mesh, {}}));
    for (const char* name : {"modelSize", "modelCentre"}) {
        const auto* label = child<QLabel>(name);
        EXPECT_TRUE(label->text().endsWith(" mm"));
        EXPECT_LE(label->fontMetrics().horizontalAdvance(label->text()), label->contentsRect().width())
            << name;
    }
}

TEST_F(PanelsTest, AHeldValueCannotMakeTheProjectUnsaveable) {
    addPublishedRegion();
    type(fieldOf("output-spring_const"), "-5");
    EXPECT_FALSE(project().regions.back().held.springConstant);
    EXPECT_TRUE(validate(project()).empty());
    type(fieldOf("output-spring_const"), "0");
    EXPECT_EQ(project().regions.back().held.springConstant, 0.0);
    EXPECT_TRUE(validate(project()).empty());
}

TEST_F(PanelsTest, InputsKeepToTheirVariablesRange) {
    addPublishedRegion();
    const auto& variable = project().regions.back().system->inputs[0];
    const double before = project().regions.back().inputs[0].second;
    const std::string row = "input-" + variable.name;
    type(fieldOf(row.c_str()), QString::number(variable.maximum + 1));
    EXPECT_EQ(project().regions.back().inputs[0].second, before);
}

TEST_F(PanelsTest, APressOnASlidersTrackAndADragAreOneEdit) {
    addPublishedRegion();
    const auto& variable = project().regions.back().system->inputs[0];
    const auto value = [this] { return project().regions.back().inputs[0].second; };
    auto* slider = child<QWidget>(("input-" + variable.name).c_str())->findChild<QSlider*>();
    const double before = value();
    const int edits = window->document().undoStack()->index(), y = slider->height() / 2;
    QTest::mousePress(slider, Qt::LeftButton, {}, {slider->width() - 20, y});
    EXPECT_GT(value(), variable.minimum + 0.8 * (variable.maximum - variable.minimum));
    QMouseEvent move(QEvent::MouseMove, QPoint(20, y), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(slider, &move);
    QTest::mouseRelease(slider, Qt::LeftButton, {}, {20, y});
    EXPECT_LT(value(), variable.minimum + 0.2 * (variable.maximum - variable.minimum));
    EXPECT_EQ(window->document().undoStack()->index(), edits + 1);
    window->document().undoStack()->undo();
    EXPECT_EQ(value(), before);
}

TEST_F(PanelsTest, ShowsTheMassThatTheRegionsMake) {
    addPublishedRegion();
    ESM_EVENTUALLY(!child<QLabel>("totalMass")->text().isEmpty());
    const QString before = child<QLabel>("totalMass")->text();
    window->document().edit("mass", [](Project& p) { p.regions.back().held.mass = 3 * p.base.mass; });
    ESM_EVENTUALLY(child<QLabel>("totalMass")->text() != before);
    window->document().undoStack()->undo();
    ESM_EVENTUALLY(child<QLabel>("totalMass")->text() == before);
}

TEST_F(PanelsTest, TellsTheBaseMassOnce) {
    int fields = 0;
    for (const auto* field : window->findChildren<NumberField*>())
        fields += field->accessibleName().compare("base mass", Qt::CaseInsensitive) == 0;
    EXPECT_EQ(fields, 1);
}

TEST_F(PanelsTest, TissueMayBeStifferWhenStretched) {
    auto* changesStiffness = child<QCheckBox>("changesStiffness");
    const auto fields = child<QWidget>("stiffening")->findChildren<NumberField*>();
    ASSERT_EQ(fields.size(), 2);
    NumberField *strain = fields[0], *factor = fields[1];
    EXPECT_FALSE(changesStiffness->isChecked());
    EXPECT_FALSE(strain->isVisible());
    changesStiffness->click();
    ASSERT_TRUE(project().base.stiffening);
    EXPECT_TRUE(validate(project()).empty());
    EXPECT_TRUE(strain->isVisible());
    const int edits = window->document().undoStack()->index();
    type(strain, "35");
    type(factor, "8");
    EXPECT_DOUBLE_EQ(project().base.stiffening->strain, 0.35);
    EXPECT_EQ(project().base.stiffening->factor, 8);
    EXPECT_EQ(window->document().undoStack()->index(), edits + 2);
    type(strain, "0");
    type(factor, "-1");
    EXPECT_DOUBLE_EQ(project().base.stiffening->strain, 0.35);
    EXPECT_EQ(project().base.stiffening->factor, 8);
    changesStiffness->click();
    EXPECT_FALSE(project().base.stiffening);
    EXPECT_FALSE(strain->isVisible());
    changesStiffness->click();
    EXPECT_EQ(project().base.stiffening->factor, 8) << "what was typed is not lost";
    for (int i = 0; i < 4; ++i)
        window->document().undoStack()->undo();
    EXPECT_EQ(project().base.stiffening->factor, 5);
    EXPECT_EQ(factor->value(), 5);
    window->document().undoStack()->undo();
    EXPECT_FALSE(project().base.stiffening);
    EXPECT_FALSE(changesStiffness->isChecked());
}

TEST_F(PanelsTest, TheWallMayResistBending) {
    auto* resists = child<QCheckBox>("resistsBending");
    EXPECT_FALSE(resists->isChecked());
    resists->click();
    EXPECT_TRUE(project().base.resistsBending);
    type(child<NumberField>("wallThickness"), "5");
    EXPECT_DOUBLE_EQ(project().base.wallThickness, 0.005);
    for (int i = 0; i < 2; ++i)
        window->document().undoStack()->undo();
    EXPECT_FALSE(project().base.resistsBending);
    EXPECT_FALSE(resists->isChecked());
    open(makeSample("uterus"));
    EXPECT_FALSE(child<QCheckBox>("resistsBending")->isVisible()) << "it has no surface";
}

TEST_F(PanelsTest, TheLawOfAllSpringsStandsWithTheWholeOrgan) {
    auto* changesStiffness = child<QCheckBox>("changesStiffness");
    EXPECT_TRUE(changesStiffness->isVisible());
    addPublishedRegion();
    EXPECT_FALSE(changesStiffness->isVisible());
    window->document().edit("whole", [](Project& p) { p.regions.back().ellipsoid.reset(); });
    EXPECT_TRUE(changesStiffness->isVisible()) << "a region of the whole organ is the whole organ";
}

TEST_F(PanelsTest, DisabledControlsSayWhy) {
    for (const auto& [name, why] :
         {std::pair("opacitySlider", "No layer is selected"), {"projectorWidth", "No photo is selected"}}) {
        EXPECT_FALSE(child<QWidget>(name)->isEnabled());
        EXPECT_EQ(child<QWidget>(name)->toolTip(), why) << name;
    }
    QAction* undo = nullptr;
    for (QAction* action : window->actions() + window->findChildren<QAction*>())
        if (action->shortcut() == QKeySequence(QKeySequence::Undo)) undo = action;
    ASSERT_NE(undo, nullptr);
    EXPECT_EQ(undo->toolTip(), "Nothing to undo");
    window->document().edit("Set base mass", [](Project& p) { p.base.mass *= 2; });
    EXPECT_EQ(undo->toolTip(), "Undo Set base mass (Ctrl+Z)");
}

TEST_F(PanelsTest, ALayerBlendsAsChosen) {
    window->document().edit("layer", [](Project& p) {
        TextureLayer layer;
        layer.photo = makeSamplePhoto("serosa");
        p.layers = {layer};
    });
    auto* choice = child<QComboBox>("blending");
    ASSERT_TRUE(choice->isEnabled());
    for (const int index : {2, 1}) {
        choice->setCurrentIndex(index);
        emit choice->activated(index);
        EXPECT_EQ(project().layers[0].blending, blendings.at(std::size_t(index)));
    }
    window->document().undoStack()->undo();
    EXPECT_EQ(choice->currentIndex(), 2) << "each choice is a step";
}

TEST_F(PanelsTest, ACalibratedCameraThrowsWhereThePerspectiveDid) {
    window->document().edit("layer", [](Project& p) {
        TextureLayer layer;
        layer.photo = makeSamplePhoto("serosa");
        layer.projector.kind = ProjectorKind::Perspective;
        layer.projector.fieldOfView = 50;
        p.layers = {layer};
    });
    auto* kind = child<QComboBox>("projectorKind");
    const auto choose = [&](int index) {
        kind->setCurrentIndex(index);
        emit kind->activated(index);
    };
    const auto projector = [&] { return project().layers[0].projector; };
    const Image& photo = project().layers[0].photo->image;
    const PhotoSize size{photo.width, photo.height};
    const Intrinsics before = intrinsicsOf(projector(), size);
    choose(2);
    ASSERT_TRUE(projector().intrinsics);
    EXPECT_EQ(*projector().intrinsics, before);
    auto* principalPoint = child<QLineEdit>("projectorIntrinsic2");
    ASSERT_FALSE(principalPoint->parentWidget()->isHidden());
    type(principalPoint, "100");
    EXPECT_EQ(projector().intrinsics->cx, 100);
    EXPECT_EQ(projector().intrinsics->fx, before.fx);
    choose(1);
    EXPECT_FALSE(projector().intrinsics);
    EXPECT_NEAR(projector().fieldOfView, 50, 1e-9);
    window->document().undoStack()->undo();
    EXPECT_EQ(projector().intrinsics->cx, 100);
}

TEST_F(PanelsTest, FitTheirColumns) {
    const auto expectFit = [this](const char* state) {
        for (auto* dock : window->findChildren<QDockWidget*>()) {
            if (!dock->isVisible()) continue;
            dock->raise(); // one behind another has no width yet
            QTest::qWait(0);
            const auto* column = dock->findChild<QScrollArea*>("column");
            EXPECT_LE(column->widget()->minimumSizeHint().width(), column->viewport()->width()) << state;
        }
    };
    expectFit("the whole organ");
    child<QCheckBox>("changesStiffness")->click();
    expectFit("stiffer when stretched");
    addPublishedRegion();
    expectFit("a region with a fuzzy system");
    window->document().edit("none", [](Project& p) { p.regions.back().system = nullptr; });
    expectFit("a region without");
    press(Qt::Key_2, Qt::ControlModifier);
    expectFit("photos");
    press(Qt::Key_3, Qt::ControlModifier);
    expectFit("speed and accuracy");
}

// A screen of 1600 × 1000 pixels with a display scale of 2.
TEST_F(PanelsTest, ColumnsOfANarrowWindowShareOnePlaceAndNothingIsCut) {
    window->resize(800, 460);
    ESM_EVENTUALLY(window->width() == 800);
    QTest::qWait(0);
    const auto columns = [this] {
        std::vector<QScrollArea*> seen;
        for (auto* column : window->findChildren<QScrollArea*>("column"))
            if (!column->visibleRegion().isEmpty()) seen.push_back(column);
        return seen;
    };
    for (const int workspace : {Qt::Key_1, Qt::Key_2, Qt::Key_3}) {
        press(workspace, Qt::ControlModifier);
        QTest::qWait(0);
        ASSERT_EQ(columns().size(), 1U) << "any other is a tab";
        const QScrollArea& column = *columns().front();
        EXPECT_LE(column.widget()->minimumSizeHint().width(), column.viewport()->width());
        EXPECT_LE(column.mapTo(window.get(), column.rect().bottomRight()).x(), 800);
        EXPECT_GE(window->view().width(), 240);
        EXPECT_EQ(window->height(), 460);
    }
    press(Qt::Key_1, Qt::ControlModifier);
    window->resize(1440, 900);
    ESM_EVENTUALLY(columns().size() == 2);
    EXPECT_LT(columns()[0]->mapTo(window.get(), QPoint()).x(), window->view().x() + 100);
}

TEST_F(PanelsTest, PlacesAreShownWithAllTheirDigits) {
    addPublishedRegion();
    QTest::qWait(0);
    for (int axis = 0; axis < 3; ++axis) {
        NumberField* field = child<VectorField>("ellipsoidCentre")->field(axis);
        QStyleOptionFrame option;
        option.initFrom(field);
        const QRect room = field->style()->subElementRect(QStyle::SE_LineEditContents, &option, field);
        EXPECT_GE(room.width(), field->fontMetrics().horizontalAdvance(QString(QChar(0x2212)) + "999.99"));
    }
}

TEST_F(PanelsTest, TheToolsStayWhereTheyAreInAnotherTheme) {
    auto* strip = child<QToolBar>("toolStrip");
    const auto place = [strip] { return strip->widgetForAction(strip->actions().front())->geometry(); };
    const QRect before = place();
    for (QAction* action : window->actions())
        if (action->toolTip() == "Light colours") action->trigger();
    QTest::qWait(0); // a layout that changed would be made anew
    EXPECT_EQ(place(), before);
    applyTheme(*qApp, Theme::Dark);
}

TEST_F(PanelsTest, AValueBetweenTheWordsIsSaidSo) {
    addPublishedRegion();
    window->document().edit("gap", [](Project& p) {
        auto system = std::make_shared<FuzzySystem>(*p.regions.back().system);
        const double middle = (system->inputs[0].minimum + system->inputs[0].maximum) / 2;
        for (FuzzyTerm& term : system->inputs[0].terms)
            term.set = {middle + 1, middle + 1, middle + 2, middle + 2};
        system->inputs[0].terms.front().set = {middle - 2, middle - 2, middle - 1, middle - 1};
        p.regions.back().system = system;
    });
    EXPECT_EQ(degreesOf("input-consistency"), "between the words");
    type(fieldOf("input-consistency"), "0");
    EXPECT_EQ(degreesOf("input-consistency"), "below all words");
    type(fieldOf("input-consistency"), "12");
    EXPECT_EQ(degreesOf("input-consistency"), "above all words");
}

TEST_F(PanelsTest, SaysInputsAndOutputsInWordsWithTheirDegrees) {
    addPublishedRegion();
    type(fieldOf("input-consistency"), "5.5");
    EXPECT_EQ(degreesOf("input-consistency"), "flexible 0.92, medium 0.08");
    EXPECT_EQ(degreesOf("output-viscosity"), "small 1.00");
}

TEST_F(PanelsTest, AnOutputCanBeHeldAndLetGoOfAndAllIsTakenBack) {
    addPublishedRegion();
    type(fieldOf("input-consistency"), "5.5");
    const auto held = [this] { return project().regions.back().held.viscosity; };
    const double inferred = *evaluate(project().regions.back(), usualWallThickness).values.viscosity;
    auto* hold = child<QWidget>("output-viscosity")->findChild<QToolButton*>("holdButton");
    hold->setFocus(Qt::TabFocusReason);
    QTest::keyClick(hold, Qt::Key_Space);
    EXPECT_EQ(held(), inferred);
    EXPECT_EQ(degreesOf("output-viscosity"), "small 1.00 · held; the system says 2.878 N·s/m");
    type(fieldOf("input-consistency"), "7");
    EXPECT_EQ(held(), inferred);
    EXPECT_EQ(evaluate(project().regions.back(), usualWallThickness).values.viscosity, inferred);
    EXPECT_NE(degreesOf("output-viscosity").find("the system says 9.1"), std::string::npos);
    type(fieldOf("output-viscosity"), "6");
    EXPECT_EQ(held(), 6.0);
    EXPECT_EQ(degreesOf("output-viscosity").find("medium 1.00"), 0U);
    hold->click();
    EXPECT_EQ(held(), std::nullopt);
    EXPECT_EQ(degreesOf("output-viscosity").find("held"), std::string::npos);
    QUndoStack* edits = window->document().undoStack();
    edits->undo();
    EXPECT_EQ(held(), 6.0);
    EXPECT_TRUE(hold->isChecked());
    edits->undo();
    EXPECT_EQ(held(), inferred);
    edits->undo();
    edits->undo();
    EXPECT_EQ(held(), std::nullopt);
    EXPECT_FALSE(hold->isChecked());
}

TEST_F(PanelsTest, HoldingWhatHasNoValueAsksForTheNumber) {
    addPublishedRegion();
    window->document().edit("left out", [](Project& p) { p.regions.back().inputs.clear(); });
    auto* hold = child<QWidget>("output-viscosity")->findChild<QToolButton*>("holdButton");
    hold->click();
    EXPECT_FALSE(hold->isChecked());
    EXPECT_EQ(window->focusWidget(), fieldOf("output-viscosity"));
    type(fieldOf("output-viscosity"), "6");
    EXPECT_TRUE(hold->isChecked());
}

TEST_F(PanelsTest, OutputsThatSetNoTissueAreShownAsWell) {
    addPublishedRegion();
    window->document().edit("another name", [](Project& p) {
        auto system = std::make_shared<FuzzySystem>(*p.regions.back().system);
        system->outputs[1].name = "stickiness";
        p.regions.back().system = system;
        setInput(p.regions.back(), "consistency", 5.5);
    });
    EXPECT_EQ(degreesOf("output-stickiness"), "small 1.00 · sets no tissue");
    EXPECT_FALSE(fieldOf("output-stickiness")->isEnabled());
    EXPECT_FALSE(child<QWidget>("output-stickiness")->toolTip().isEmpty());
    EXPECT_EQ(child<QWidget>("output-stickiness")->findChild<QToolButton*>("holdButton"), nullptr);
}
