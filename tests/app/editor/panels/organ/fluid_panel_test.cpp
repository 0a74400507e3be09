#include "app/editor/workers/preview.h"
#include "core/authoring/fluids.h"
#include "core/model/scene_cavities.h"
#include "core/project/detail_change.h"
#include "core/samples/samples.h"
#include "core/support/pressure_units.h"
#include "tests/app/editor_driver.h"
#include "tests/support/tissue_models.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QUndoStack>

using namespace esm;

namespace {

/// Balls side by side, the last of which may lack a triangle.
Project ballsOf(const std::vector<double>& radii, bool isLastOpen = false) {
    RepairedMesh surface;
    for (std::size_t i = 0; i < radii.size(); ++i) {
        const TriangleMesh ball = tissue::sphereMesh(1, radii[i]);
        const auto first = static_cast<std::uint32_t>(surface.mesh.vertices.size());
        for (const Eigen::Vector3d& vertex : ball.vertices)
            surface.mesh.vertices.push_back(vertex + Eigen::Vector3d(0.1 * static_cast<double>(i), 0, 0));
        for (const Triangle& triangle : ball.triangles)
            surface.mesh.triangles.push_back({first + triangle[0], first + triangle[1], first + triangle[2]});
    }
    if (isLastOpen) surface.mesh.triangles.pop_back();
    return makeProject("balls", std::move(surface));
}

class FluidPanelTest : public EditorTest {
protected:
    void show(Project project) {
        open(std::move(project));
        // The parts are found beside the window.
        ESM_EVENTUALLY(!filled()->toolTip().contains("looked at"));
    }
    QComboBox* part() const { return child<QComboBox>("fluidPart"); }
    QCheckBox* filled() const { return child<QCheckBox>("fluidFilled"); }
    NumberField* stiffness() const { return child<NumberField>("fluidStiffness"); }
    NumberField* pressure() const { return child<NumberField>("fluidPressure"); }
    QPushButton* replace() const { return child<QPushButton>("fluidReplacePath"); }
    QString textOf(const char* name) const { return child<QLabel>(name)->text(); }
    QUndoStack& undo() const { return *window->document().undoStack(); }
};

} // namespace

TEST_F(FluidPanelTest, ListsClosedPartsTheLargestFirst) {
    show(ballsOf({0.01, 0.03, 0.02}, true));
    ASSERT_EQ(part()->count(), 2);
    EXPECT_TRUE(part()->itemText(0).startsWith("Part 2 · ")) << part()->itemText(0).toStdString();
    EXPECT_TRUE(part()->itemText(0).endsWith(" mL"));
    EXPECT_TRUE(part()->itemText(1).startsWith("Part 1 · "));
    EXPECT_EQ(part()->currentIndex(), 0);
    EXPECT_EQ(textOf("fluidAside"), "1 open part holds no fluid");
    EXPECT_TRUE(child<QLabel>("fluidAside")->toolTip().startsWith("Part 3 is open"));
}

TEST_F(FluidPanelTest, UndoShowsThePartThatItIsAbout) {
    show(ballsOf({0.01, 0.03, 0.02}));
    part()->setCurrentIndex(2);
    filled()->click();
    const QString smallest = part()->currentText();
    EXPECT_TRUE(smallest.startsWith("Part 1 · "));
    EXPECT_TRUE(part()->toolTip().contains("this one is part 0"));
    part()->setCurrentIndex(0);
    undo().undo();
    EXPECT_EQ(part()->currentIndex(), 2);
    EXPECT_FALSE(filled()->isChecked());
    part()->setCurrentIndex(0);
    undo().redo();
    EXPECT_EQ(part()->currentText(), smallest);
}

TEST_F(FluidPanelTest, ListsNoMoreOfManySmallPartsThanCanBeChosenFrom) {
    Project many = ballsOf(std::vector<double>(40, 0.01));
    fillPart(many, 39, 1000);
    show(std::move(many));
    EXPECT_EQ(part()->count(), 31);
    EXPECT_TRUE(part()->itemText(30).startsWith("Part 40 · "));
    EXPECT_TRUE(part()->itemText(30).endsWith(" · filled"));
    EXPECT_EQ(textOf("fluidAside"), "9 small ones are not listed");
}

TEST_F(FluidPanelTest, ListsNoSpecks) {
    show(ballsOf({0.03, 1e-4, 0.01}));
    EXPECT_EQ(part()->count(), 2);
    EXPECT_EQ(textOf("fluidAside"), "1 small one is not listed");
}

TEST_F(FluidPanelTest, FillsThePartThatIsShownAndUndoTakesItBack) {
    show(ballsOf({0.01, 0.03}));
    EXPECT_FALSE(filled()->isChecked());
    EXPECT_FALSE(stiffness()->isEnabled());
    EXPECT_FALSE(stiffness()->toolTip().isEmpty());
    filled()->click();
    ASSERT_EQ(project().scene.fillings.size(), 1U);
    EXPECT_EQ(project().scene.fillings[0].part, 1U);
    EXPECT_GE(project().scene.fillings[0].stiffness, 1000);
    EXPECT_TRUE(stiffness()->isEnabled());
    EXPECT_TRUE(part()->currentText().endsWith(" · filled"));
    EXPECT_EQ(undo().undoText(), "Fill part with fluid");
    part()->setCurrentIndex(1);
    EXPECT_FALSE(filled()->isChecked());
    filled()->click();
    EXPECT_EQ(project().scene.fillings.size(), 2U);
    undo().undo();
    EXPECT_FALSE(filled()->isChecked());
    undo().undo();
    EXPECT_TRUE(project().scene.fillings.empty());
    part()->setCurrentIndex(0);
    EXPECT_FALSE(filled()->isChecked());
}

TEST_F(FluidPanelTest, JoinsTheStepsOfAnArrowKeyButNotThoseOfAnotherPart) {
    Project balls = ballsOf({0.03, 0.02});
    fillPart(balls, 0, 1e5);
    fillPart(balls, 1, 1e5);
    show(std::move(balls));
    stiffness()->setPause(std::chrono::hours(1));
    stiffness()->setFocus();
    for (int press = 0; press < 3; ++press)
        QTest::keyClick(stiffness(), Qt::Key_Up);
    EXPECT_GT(fluidOf(project().scene, 0)->stiffness, 1.1e5);
    EXPECT_EQ(undo().count(), 1);
    part()->setCurrentIndex(1);
    QTest::keyClick(stiffness(), Qt::Key_Up);
    EXPECT_EQ(undo().count(), 2);
    undo().undo();
    undo().undo();
    EXPECT_EQ(fluidOf(project().scene, 0)->stiffness, 1e5);
}

TEST_F(FluidPanelTest, PressesFromWithinInTheUnitThatIsTyped) {
    show(ballsOf({0.03}));
    typeInto(pressure(), "2 kPa");
    press(Qt::Key_Return);
    ASSERT_NE(pressureOf(project().scene, 0), nullptr);
    EXPECT_NEAR(pressureOf(project().scene, 0)->path.at(0).pressure, 2000, 1e-9);
    EXPECT_EQ(textOf("fluidInKilopascal"), "2.000 kPa =");
    typeInto(pressure(), "10");
    press(Qt::Key_Return);
    EXPECT_NEAR(pressureOf(project().scene, 0)->path.at(0).pressure, 10 * pascalPerMillimetreOfMercury, 1e-9);
    typeInto(pressure(), "0");
    press(Qt::Key_Return);
    EXPECT_TRUE(project().scene.pressures.empty());
}

TEST_F(FluidPanelTest, LosesNoPathThatAFileBrought) {
    Project ball = ballsOf({0.03});
    ball.scene.pressures = {{0, {{0, 0}, {0.5, 1000}, {1, 400}}}};
    show(std::move(ball));
    EXPECT_EQ(pressure()->text(), "from file, 3 rows");
    EXPECT_FALSE(pressure()->isEnabled());
    EXPECT_TRUE(replace()->isVisible());
    replace()->click();
    EXPECT_EQ(project().scene.pressures, (std::vector<PartPressure>{{0, {{0, 400}}}}));
    EXPECT_TRUE(pressure()->isEnabled());
    EXPECT_FALSE(replace()->isVisible());
    undo().undo();
    EXPECT_EQ(project().scene.pressures[0].path.size(), 3U);
    EXPECT_FALSE(pressure()->isEnabled());
}

TEST_F(FluidPanelTest, SaysWhyASolidOrAnOpenOrganHoldsNone) {
    show(ballsOf({0.03}, true));
    for (const QWidget* field : std::initializer_list<QWidget*>{part(), filled(), stiffness(), pressure()}) {
        EXPECT_FALSE(field->isEnabled());
        EXPECT_TRUE(field->toolTip().startsWith("Part 1 is open")) << field->toolTip().toStdString();
    }
    const Detail solid{Detail::Kind::Filled, 0, LatticeFilling{LatticeKind::BodyCentred, 0.02}};
    window->document().replace(withDetail(makeSample("liver"), solid), std::nullopt);
    for (const QWidget* field : std::initializer_list<QWidget*>{part(), filled(), stiffness(), pressure()}) {
        EXPECT_FALSE(field->isEnabled());
        EXPECT_TRUE(field->toolTip().startsWith("A lattice fills")) << field->toolTip().toStdString();
    }
    window->document().replace(makeSample("liver"), std::nullopt);
    ESM_EVENTUALLY(filled()->isEnabled());
}

TEST_F(FluidPanelTest, TellsVolumeAndPressureWhileTheOrganMoves) {
    Project ball = ballsOf({0.03});
    fillPart(ball, 0, 1e5);
    pressPart(ball, 0, 10 * pascalPerMillimetreOfMercury);
    show(std::move(ball));
    window->preview().setPlaying(true);
    ESM_EVENTUALLY(textOf("fluidVolumeNow").contains(" mL · "));
    ESM_EVENTUALLY(textOf("fluidPressureNow").contains(" mmHg"));
    const int height = settledHeight(filled()->parentWidget());
    window->preview().setPlaying(false);
    ESM_EVENTUALLY(textOf("fluidVolumeNow") == QString(QChar(0x2013)));
    EXPECT_EQ(textOf("fluidPressureNow"), QString(QChar(0x2013)));
    EXPECT_EQ(settledHeight(filled()->parentWidget()), height);
}
