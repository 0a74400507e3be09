#include "app/editor/window/edit_controller.h"
#include "app/editor/workers/preview.h"
#include "app/editor/workers/preview_loads.h"
#include "core/authoring/fluids.h"
#include "core/project/detail_change.h"
#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"
#include "tests/support/solid_surfaces.h"
#include "widgets/inputs/number_text.h"

#include <QComboBox>
#include <QInputDialog>
#include <QLabel>
#include <QPushButton>
#include <QUndoStack>

using namespace esm;

namespace {

class SimulatedNodesTest : public EditorTest {
protected:
    void SetUp() override { open(makeSample("tube")); }

    static void answer(QDialog& dialog, QMessageBox::ButtonRole role) {
        auto& box = *qobject_cast<QMessageBox*>(&dialog);
        for (QAbstractButton* button : box.buttons())
            if (box.buttonRole(button) == role) return button->click();
        FAIL();
    }
    void chooseAndAnswer(QMessageBox::ButtonRole role) {
        choose(60, [&] {
            script.expectNamed("splitsGoBox", [role](QDialog* dialog) { answer(*dialog, role); });
        });
        EXPECT_TRUE(script.isDone());
    }

    void choose(
        int nodes, const std::function<void()>& next = [] {}) {
        script.expect([](QWidget* dialog) { return qobject_cast<QInputDialog*>(dialog) != nullptr; },
                      [this, nodes](QDialog* dialog) {
                          meanwhile();
                          qobject_cast<QInputDialog*>(dialog)->setIntValue(nodes);
                          dialog->accept();
                      });
        next();
        window->windowActions().chooseDetail->trigger();
    }

    DialogScript script;
    std::function<void()> meanwhile = [] {}; ///< what happens on its own while the user chooses
};

} // namespace

TEST_F(SimulatedNodesTest, CarryTheWholeSurfaceAndCanBeTakenBack) {
    ESM_EVENTUALLY(window->preview().status().playing);
    choose(60);
    EXPECT_EQ(project().network->restPositions.size(), 60U);
    EXPECT_EQ(child<QLabel>("nodeCount")->text(), "60");
    EXPECT_EQ(child<QLabel>("vertexCount")->text(), "170");
    EXPECT_EQ(window->view().scene().mesh->vertices.size(), 170U);
    ESM_EVENTUALLY(window->view().scene().nodePositions.size() == 60);
    EXPECT_TRUE(validate(project()).empty());
    window->document().undoStack()->undo();
    EXPECT_EQ(project().network->restPositions.size(), 170U);
    EXPECT_EQ(project().network->springs.size(), 340U);
    ESM_EVENTUALLY(window->view().scene().nodePositions.size() == 170);
}

TEST_F(SimulatedNodesTest, AskBeforeSplitsAreRemoved) {
    choose(60); // no question where there are none
    Project split = makeSample("tube");
    const Spring& spring = split.network->springs[0];
    split.scene.splits = {{0.1, {{spring.first, spring.second}}}};
    open(split);
    chooseAndAnswer(QMessageBox::RejectRole);
    EXPECT_EQ(project().network->restPositions.size(), 170U);
    EXPECT_EQ(project().scene.splits.size(), 1U);
    EXPECT_EQ(window->document().undoStack()->count(), 0);
    chooseAndAnswer(QMessageBox::AcceptRole);
    EXPECT_TRUE(project().scene.splits.empty());
    window->document().undoStack()->undo();
    EXPECT_EQ(project().scene.splits.size(), 1U);
}

TEST_F(SimulatedNodesTest, LeaveWhatCameMeanwhile) {
    meanwhile = [this] { window->document().edit("late", [](Project& edited) { edited.name = "late"; }); };
    choose(60);
    EXPECT_EQ(project().network->restPositions.size(), 60U);
    EXPECT_EQ(project().name, "late");
    window->document().undoStack()->undo();
    EXPECT_EQ(project().network->restPositions.size(), 170U);
    EXPECT_EQ(project().name, "late");
}

TEST_F(SimulatedNodesTest, AreWhatAPullTakes) {
    choose(60);
    window->windowActions().tool("pull")->trigger();
    std::optional<Pull> pulled;
    const auto& vertices = project().mesh->vertices;
    for (std::size_t i = 80; i < 90 && !pulled; ++i) {
        QTest::mousePress(&window->view(), Qt::LeftButton, {}, placeOf(vertices[i]));
        moveMouse(placeOf(vertices[i]) + QPoint(20, 0));
        pulled = window->preview().loads().pull;
        QTest::mouseRelease(&window->view(), Qt::LeftButton, {}, placeOf(vertices[i]));
    }
    ASSERT_TRUE(pulled);
    EXPECT_LT(pulled->node, 60U);
}

TEST_F(SimulatedNodesTest, AreOfferedOnlyWhereThereIsASurface) {
    EXPECT_TRUE(window->windowActions().chooseDetail->isEnabled());
    window->document().replace(makeSample("uterus"), std::nullopt);
    EXPECT_FALSE(window->windowActions().chooseDetail->isEnabled());
    EXPECT_TRUE(window->windowActions().chooseDetail->toolTip().contains("no surface"));
}

TEST_F(SimulatedNodesTest, FillABodyAndCanBeTakenBack) {
    TriangleMesh mesh = test::ball(0.04, {0, 0, 0});
    open(makeProject("ball", {std::move(mesh), {}}));
    const std::size_t hollow = project().network->restPositions.size();
    script.expectNamed("insideDialog", [](QDialog* dialog) {
        auto* fill = dialog->findChild<QPushButton*>("insideAccept");
        ESM_EVENTUALLY(fill->isEnabled());
        fill->click();
    });
    window->windowActions().chooseInside->trigger();
    ASSERT_TRUE(script.isDone());
    ASSERT_TRUE(project().network->lattice);
    const std::size_t filled = project().network->restPositions.size();
    EXPECT_EQ(child<QLabel>("nodeCount")->text(), countText(filled));
    ESM_EVENTUALLY(window->view().scene().nodePositions.size() == filled);
    EXPECT_TRUE(validate(project()).empty());
    window->document().undoStack()->undo();
    EXPECT_EQ(project().network->restPositions.size(), hollow);
    EXPECT_FALSE(project().network->lattice);
}

TEST_F(SimulatedNodesTest, OfAWallOfPrismsAreThoseOfItsSurface) {
    open(makeProject("ball", {test::ball(0.04, {0, 0, 0}), {}}));
    const std::size_t hollow = project().network->restPositions.size();
    script.expectNamed("insideDialog", [](QDialog* dialog) {
        auto* kind = dialog->findChild<QComboBox*>("insideKind");
        kind->setCurrentIndex(kind->count() - 1);
        auto* make = dialog->findChild<QPushButton*>("insideAccept");
        ESM_EVENTUALLY(make->isEnabled());
        make->click();
    });
    window->windowActions().chooseInside->trigger();
    ASSERT_TRUE(script.isDone());
    EXPECT_EQ(project().network->restPositions.size(), 3 * hollow);
    EXPECT_EQ(child<QLabel>("modelInside")->text(), "wall, 3.0 mm");
    const QAction* chooseDetail = window->windowActions().chooseDetail;
    EXPECT_FALSE(chooseDetail->isEnabled());
    EXPECT_TRUE(chooseDetail->toolTip().contains("wall of prisms")) << chooseDetail->toolTip().toStdString();
    window->findChild<EditController*>()->simulateNodes(200);
    EXPECT_EQ(window->document().undoStack()->count(), 1) << "fewer nodes do not exist";
    window->document().undoStack()->undo();
    EXPECT_EQ(project().network->restPositions.size(), hollow);
    EXPECT_TRUE(chooseDetail->isEnabled());
}

TEST_F(SimulatedNodesTest, SayWhereAWallIsOftenThinnerThanAskedFor) {
    const Detail thick{Detail::Kind::Filled, 0, LatticeFilling{LatticeKind::Prisms, 0, 0.038, 2}};
    open(withDetail(makeProject("ball", {test::ball(0.04, {0, 0, 0}), {}}), thick));
    const auto* inside = child<QLabel>("modelInside");
    EXPECT_EQ(inside->text(), "wall, up to 38 mm");
    EXPECT_TRUE(inside->toolTip().contains("have a thinner wall than asked for"))
        << inside->toolTip().toStdString();
}

TEST_F(SimulatedNodesTest, AskBeforeALatticeTakesTheRoomOfAFluid) {
    Project ball = makeProject("ball", {test::ball(0.04, {0, 0, 0}), {}});
    fillPart(ball, 0, 1e5);
    open(ball);
    const auto fillBodyAndAnswer = [&](QMessageBox::ButtonRole role) {
        script.expectNamed("insideDialog", [](QDialog* dialog) {
            auto* fill = dialog->findChild<QPushButton*>("insideAccept");
            ESM_EVENTUALLY(fill->isEnabled());
            fill->click();
        });
        script.expectNamed("fluidsGoBox", [role](QDialog* dialog) { answer(*dialog, role); });
        window->windowActions().chooseInside->trigger();
        EXPECT_TRUE(script.isDone());
    };
    fillBodyAndAnswer(QMessageBox::RejectRole);
    EXPECT_EQ(window->document().undoStack()->count(), 0);
    fillBodyAndAnswer(QMessageBox::AcceptRole);
    EXPECT_TRUE(project().network->lattice);
    EXPECT_TRUE(project().scene.fillings.empty());
    window->document().undoStack()->undo();
    EXPECT_EQ(project().scene, ball.scene);
}

TEST_F(SimulatedNodesTest, MakeAnEvenSheetAndCanBeTakenBack) {
    open(makeProject("lump", {lumpySurface(20, 30), {}}));
    QAction* const evenSheet = window->windowActions().evenSheet;
    EXPECT_FALSE(evenSheet->isChecked());
    evenSheet->trigger();
    ASSERT_TRUE(project().network->sheet);
    EXPECT_TRUE(evenSheet->isChecked());
    window->document().undoStack()->undo();
    EXPECT_FALSE(project().network->sheet);
    EXPECT_FALSE(evenSheet->isChecked());
    window->document().undoStack()->redo();
    evenSheet->trigger();
    EXPECT_FALSE(project().network->sheet);
    open(makeSample("uterus"));
    EXPECT_FALSE(window->windowActions().evenSheet->isEnabled()) << "it has no surface";
}

TEST_F(SimulatedNodesTest, StayAsTheyAreWhereNothingElseIsChosen) {
    open(makeProject("ball", {test::ball(0.04, {0, 0, 0}), {}}));
    script.expectNamed("insideDialog", [](QDialog* dialog) {
        dialog->findChild<QComboBox*>("insideKind")->setCurrentIndex(0);
        dialog->findChild<QPushButton*>("insideAccept")->click();
    });
    window->windowActions().chooseInside->trigger();
    EXPECT_TRUE(script.isDone());
    EXPECT_EQ(window->document().undoStack()->count(), 0);
}

TEST_F(SimulatedNodesTest, OfferNoInsideWhereThereIsNoSurface) {
    EXPECT_TRUE(window->windowActions().chooseInside->isEnabled());
    window->document().replace(makeSample("uterus"), std::nullopt);
    EXPECT_FALSE(window->windowActions().chooseInside->isEnabled());
}
