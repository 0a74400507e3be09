#include "app/editor/tools/instrument_options.h"
#include "app/editor/tools/tool_table.h"
#include "app/editor/window/application.h"
#include "app/editor/window/help.h"
#include "core/authoring/regions.h"
#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"

#include <gmock/gmock.h>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QMenuBar>

#include <algorithm>
#include <stdexcept>

using namespace esm;

namespace {

/// The letter after the "&", in lower case; null without one.
QChar mnemonicOf(const QString& text) {
    const int at = QString(text).replace("&&", "  ").indexOf('&');
    return at < 0 ? QChar() : text[at + 1].toLower();
}

void expectDifferent(const QStringList& texts) {
    QMap<QChar, QString> taken;
    for (const QString& text : texts) {
        const QChar key = mnemonicOf(text);
        if (key.isNull()) continue;
        EXPECT_FALSE(taken.contains(key)) << text.toStdString() << " and " << taken[key].toStdString();
        taken[key] = text;
    }
}

QStringList textsOf(const QWidget* menu) {
    QStringList texts;
    for (const QAction* action : menu->actions())
        texts << action->text();
    return texts;
}

class MainWindowTest : public EditorTest {
protected:
    void SetUp() override {
        Project project = makeSample("tube");
        // What the preview leaves out is said in the line that the tests look at.
        project.scene.forces.clear();
        project.scene.moves.clear();
        project.scene.instruments.clear();
        open(std::move(project));
    }
    QString message() const { return child<QLabel>("message")->text(); }
    Eigen::Vector3d nearestVertex() const {
        const auto& vertices = project().mesh->vertices;
        const Eigen::Vector3d eye = window->view().camera().eye;
        return *std::min_element(vertices.begin(), vertices.end(), [&](const auto& a, const auto& b) {
            return (a - eye).norm() < (b - eye).norm();
        });
    }
    void edit(const std::function<void(Project&)>& change) { window->document().edit("edit", change); }
};

} // namespace

TEST_F(MainWindowTest, GivesEachEntryOfAMenuItsOwnLetter) {
    expectDifferent(textsOf(window->menuBar()));
    for (const auto* menu : window->menuBar()->findChildren<QMenu*>())
        expectDifferent(textsOf(menu));
}

TEST_F(MainWindowTest, GivesEachActionItsOwnKey) {
    QStringList keys;
    for (const QAction* action : window->findChildren<QAction*>())
        for (const QKeySequence& key : action->shortcuts())
            keys << key.toString();
    EXPECT_GT(keys.size(), 20);
    EXPECT_EQ(keys.removeDuplicates(), 0) << keys.join(' ').toStdString();
}

TEST_F(MainWindowTest, HasAnIconForEachTool) {
    for (const ToolRow& tool : toolTable())
        EXPECT_TRUE(QFile::exists(QStringLiteral(":/icons/%1.svg").arg(tool.icon)))
            << tool.icon.toStdString();
}

TEST_F(MainWindowTest, KeepsTheMenusLettersFreeOfThePanels) {
    for (const auto* dock : window->findChildren<QDockWidget*>()) {
        QStringList texts = textsOf(window->menuBar());
        for (const auto* button : dock->findChildren<QAbstractButton*>())
            texts << button->text();
        for (const auto* label : dock->findChildren<QLabel*>())
            if (label->buddy()) texts << label->text();
        expectDifferent(texts);
    }
}

TEST_F(MainWindowTest, SaysWhyAToolCannotBeTaken) {
    const Actions& actions = window->windowActions();
    edit([](Project& p) { p.regions.clear(); });
    EXPECT_FALSE(actions.tool("region")->isEnabled());
    EXPECT_TRUE(actions.tool("region")->toolTip().contains("Ctrl+R"));
    window->view().setFocus();
    press(Qt::Key_E);
    EXPECT_EQ(toolInHand(), "pull");
    press(Qt::Key_J);
    EXPECT_EQ(toolInHand(), "pull");
    press(Qt::Key_R, Qt::ControlModifier);
    EXPECT_TRUE(actions.tool("region")->isEnabled());
    press(Qt::Key_E);
    EXPECT_EQ(toolInHand(), "region");
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(toolInHand(), "look");
    EXPECT_TRUE(actions.tool("look")->isChecked());
}

TEST_F(MainWindowTest, SaysWhyAKeyDoesNothing) {
    const auto saidAfter = [this](Qt::Key key) {
        window->view().setFocus();
        press(key);
        return child<QLabel>("message")->text().toStdString();
    };
    EXPECT_THAT(saidAfter(Qt::Key_J), testing::HasSubstr("workspace Texture"));
    window->windowActions().texture->trigger();
    EXPECT_THAT(saidAfter(Qt::Key_J), testing::HasSubstr("no photo"));
}

TEST_F(MainWindowTest, LetsGoWhereverTheFocusIs) {
    ESM_EVENTUALLY(window->preview().status().playing);
    QTest::mousePress(&window->view(), Qt::LeftButton, {}, placeOf(nearestVertex()));
    moveMouse(placeOf(nearestVertex()) + QPoint(0, 30));
    massField()->setFocus();
    ASSERT_TRUE(window->preview().loads().pull);
    press(Qt::Key_Escape);
    EXPECT_FALSE(window->preview().loads().pull);
}

TEST_F(MainWindowTest, EscapeTakesBackWhatIsTyped) {
    const QString before = massField()->text();
    typeInto(massField(), "0.5");
    press(Qt::Key_Escape);
    EXPECT_EQ(massField()->text(), before);
    EXPECT_FALSE(window->document().isModified());
}

TEST_F(MainWindowTest, GoesWhileSomethingIsTyped) {
    typeInto(massField(), "0.5");
    window.reset();
}

TEST_F(MainWindowTest, SaysWhyTheTissueDoesNotMoveUntilItDoes) {
    edit([](Project& p) { p.base.mass = -1; });
    ESM_EVENTUALLY(!message().isEmpty());
    const QString problem = message();
    EXPECT_TRUE(child<QLabel>("message")->property("warning").toBool());
    press(Qt::Key_0, Qt::ControlModifier);
    press(Qt::Key_Space);
    // What comes after has been taken too, so the key was.
    auto* preview = window->findChild<Preview*>();
    const int projects = preview->frame().project;
    preview->setProject(project());
    ESM_EVENTUALLY(preview->frame().project > projects);
    EXPECT_EQ(message(), problem);
    press(Qt::Key_Z, Qt::ControlModifier);
    ESM_EVENTUALLY(message() != problem);
    EXPECT_FALSE(child<QLabel>("message")->property("warning").toBool());
}

TEST_F(MainWindowTest, SaysWhatThePreviewLeavesOut) {
    Project still = makeSample("tube");
    still.scene.instruments.clear();
    still.scene.forces.clear();
    still.scene.moves.clear();
    window->document().replace(still, std::nullopt);
    EXPECT_EQ(message(), "");
    edit([](Project& p) { p.scene.forces.push_back({0, Eigen::Vector3d(0, 0.1, 0), 0, 1}); });
    EXPECT_NE(message(), "");
    EXPECT_TRUE(child<QLabel>("message")->toolTip().contains("forces"));
    EXPECT_FALSE(child<QLabel>("message")->toolTip().contains("instrument")) << "only what there is";
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(message(), "");
}

TEST_F(MainWindowTest, TheMenusStayWhereTheyAreWhateverTheName) {
    const auto placeOfMenus = [this] {
        QTest::qWait(0);
        return window->menuBar()->actionGeometry(window->menuBar()->actions().front());
    };
    const QRect before = placeOfMenus();
    window->document().replace(makeSample("tube"), "/somewhere/" + std::string(200, 'n') + ".esm");
    EXPECT_EQ(placeOfMenus(), before);
    const auto* name = child<QLabel>("documentName");
    EXPECT_LT(name->width(), 340);
    EXPECT_LE(name->geometry().right(), window->menuBar()->width());
    EXPECT_TRUE(name->toolTip().contains("/somewhere/"));
    edit([](Project& p) { p.base.mass *= 2; });
    EXPECT_EQ(placeOfMenus(), before);
    EXPECT_TRUE(name->text().startsWith(QChar(0x2022)));
    window->document().undoStack()->undo();
}

TEST_F(MainWindowTest, AsksNobodyToPlayTheGreetingOrgansTestRun) {
    window.reset();
    const Project greeting = makeSample("liver");
    ASSERT_FALSE(greeting.scene.instruments.empty());
    open(greeting);
    EXPECT_EQ(message(), "");
    edit([](Project& p) { p.scene.fixed.clear(); });
    edit([](Project& p) { p.scene.fixed.push_back({{0, 1}, std::nullopt}); });
    EXPECT_EQ(message(), "") << "to fix nodes is no test run";
    window->document().replace(greeting, std::nullopt);
    EXPECT_TRUE(message().contains("scene to play")) << "who opens it has asked for it";
}

TEST_F(MainWindowTest, AnActionSaysWhyItCannotBeUsedAndThenAgainWhatItDoes) {
    const QAction* free = window->windowActions().freeNodes;
    edit([](Project& p) { p.scene.fixed.clear(); });
    EXPECT_EQ(free->toolTip(), "No node is fixed");
    edit([](Project& p) { p.scene.fixed.push_back({{0, 1}, std::nullopt}); });
    EXPECT_EQ(free->toolTip(), "Let every fixed node go");
}

TEST_F(MainWindowTest, RemovesWhatIsSelectedFromTheMenu) {
    const Actions& actions = window->windowActions();
    edit([](Project& p) { p.regions.clear(); });
    EXPECT_FALSE(actions.removeRegion->isEnabled());
    EXPECT_FALSE(actions.removePhoto->isEnabled());
    press(Qt::Key_R, Qt::ControlModifier);
    ASSERT_EQ(project().regions.size(), 1U);
    actions.removeRegion->trigger();
    EXPECT_TRUE(project().regions.empty());
    edit([](Project& p) {
        TextureLayer layer;
        layer.photo = makeSamplePhoto("serosa");
        p.layers = {layer};
    });
    actions.removePhoto->trigger();
    EXPECT_TRUE(project().layers.empty());
}

TEST_F(MainWindowTest, ExplainsTheStepInPlainWords) {
    ESM_EVENTUALLY(!child<QLabel>("stepping")->text().isEmpty());
    const QString shown = child<QLabel>("stepping")->text();
    EXPECT_TRUE(shown.endsWith("steps")) << shown.toStdString();
    const QString method = integratorName(*window->preview().status().integrator);
    EXPECT_TRUE(shown.startsWith(traitsOf(*window->preview().status().integrator).title));
    EXPECT_TRUE(child<QLabel>("stepping")->toolTip().contains(method + ", "))
        << "with a word on what it does";
}

TEST_F(MainWindowTest, SaysHowAPhotoIsAddedWhereThereIsNone) {
    press(Qt::Key_2, Qt::ControlModifier);
    EXPECT_TRUE(window->view().hint().contains("Ctrl+P")) << window->view().hint().toStdString();
    EXPECT_EQ(toolInHand(), "look") << "there is nothing to place";
    press(Qt::Key_1, Qt::ControlModifier);
    EXPECT_FALSE(window->view().hint().contains("Ctrl+P"));
}

TEST_F(MainWindowTest, TheInstrumentsSizeIsShownWhileItIsInHandAndKept) {
    auto* options = window->findChild<InstrumentOptions*>();
    ASSERT_NE(options, nullptr);
    EXPECT_FALSE(options->isVisible());
    window->view().setFocus();
    press(Qt::Key_I);
    ASSERT_TRUE(options->isVisible());
    auto* radius = options->findChild<NumberField*>();
    const double diagonal = boundingBox(project().network->restPositions).diagonal().norm();
    EXPECT_NEAR(radius->value().value_or(0), 0.05 * diagonal, 0.001);
    typeInto(radius, "7.5");
    press(Qt::Key_Return);
    EXPECT_DOUBLE_EQ(radiusOf(window->findChild<InstrumentTool*>()->shape()), 0.0075);
    window->document().replace(makeSample("liver"), std::nullopt);
    EXPECT_DOUBLE_EQ(radius->value().value_or(0), 0.0075) << "for the next organ too";
    EXPECT_FALSE(window->document().isModified());
    press(Qt::Key_P);
}

TEST_F(MainWindowTest, TheInstrumentLeavesTheHandWithItsOrgan) {
    window->view().setFocus();
    press(Qt::Key_I);
    QMouseEvent move(QEvent::MouseMove, placeOf(nearestVertex()), Qt::NoButton, Qt::NoButton, {});
    QApplication::sendEvent(&window->view(), &move);
    ASSERT_TRUE(window->view().scene().heldInstrument);
    ASSERT_TRUE(window->preview().loads().instrument);
    window->document().replace(makeSample("liver"), std::nullopt);
    EXPECT_FALSE(window->view().scene().heldInstrument);
    EXPECT_FALSE(window->preview().loads().instrument);
    press(Qt::Key_P);
}

TEST_F(MainWindowTest, SaysThatAPhotoNeedsASurface) {
    press(Qt::Key_2, Qt::ControlModifier);
    Project bare = makeSample("tube");
    auto mesh = std::make_shared<TriangleMesh>(*bare.mesh);
    mesh->triangles.clear();
    bare.mesh = mesh;
    window->document().replace(bare, std::nullopt);
    EXPECT_TRUE(window->view().hint().contains("no surface")) << window->view().hint().toStdString();
    press(Qt::Key_1, Qt::ControlModifier);
}

TEST_F(MainWindowTest, ThePhotosBoxStandsInItsWorkspaceAlone) {
    edit([](Project& p) {
        TextureLayer layer;
        layer.photo = makeSamplePhoto("serosa");
        p.layers = {layer};
    });
    EXPECT_TRUE(window->view().scene().projectors.empty());
    press(Qt::Key_2, Qt::ControlModifier);
    EXPECT_EQ(window->view().scene().projectors.size(), 1U);
    press(Qt::Key_H, Qt::ShiftModifier);
    EXPECT_TRUE(window->view().scene().projectors.empty()) << "switched off";
    EXPECT_TRUE(window->view().hint().contains("Shift+H")) << window->view().hint().toStdString();
    press(Qt::Key_H, Qt::ShiftModifier);
    EXPECT_EQ(window->view().scene().projectors.size(), 1U);
    press(Qt::Key_V);
    EXPECT_TRUE(window->view().scene().projectors.empty()) << "of the tool Photo alone";
    press(Qt::Key_J);
    EXPECT_EQ(window->view().scene().projectors.size(), 1U);
    press(Qt::Key_1, Qt::ControlModifier);
    EXPECT_TRUE(window->view().scene().projectors.empty());
}

TEST_F(MainWindowTest, TellsEveryKey) {
    const QString text = keysText(window->windowActions(), SheetColumns::Two);
    EXPECT_EQ(keysText(window->windowActions(), SheetColumns::One).count("<tr>"), text.count("<tr>"));
    for (const QAction* action : window->findChildren<QAction*>()) {
        if (window->windowActions().standardViews.end() !=
            std::find(window->windowActions().standardViews.begin(),
                      window->windowActions().standardViews.end(), action))
            continue;
        for (const QKeySequence& key : action->shortcuts())
            EXPECT_TRUE(text.contains(key.toString(QKeySequence::NativeText).toHtmlEscaped()))
                << action->text().toStdString();
    }
    for (const ToolRow& tool : toolTable())
        for (const QString& part : tool.use.split(" · "))
            EXPECT_TRUE(text.contains(part.toHtmlEscaped(), Qt::CaseInsensitive)) << part.toStdString();
    EXPECT_EQ(text.count("Alt"), 1) << "what all tools share is told once";
    for (const QAction* side : window->windowActions().standardViews)
        EXPECT_TRUE(text.contains(QKeySequence::listToString(side->shortcuts()).replace("; ", ", ")))
            << side->text().toStdString();
}

TEST_F(MainWindowTest, LivesOnWhenAnActionFails) {
    QAction failing(window.get());
    QObject::connect(&failing, &QAction::triggered, [] { throw std::runtime_error("no more paper"); });
    failing.setShortcut(QKeySequence(QStringLiteral("Ctrl+F12")));
    window->addAction(&failing);
    QString said;
    dialogs.expectNamed("problemBox", [&](QDialog* box) {
        said = qobject_cast<QMessageBox*>(box)->informativeText();
        box->accept();
    });
    QTimer::singleShot(0, &failing, [&] { failing.trigger(); });
    ESM_EVENTUALLY(dialogs.isDone() && !said.isEmpty());
    EXPECT_EQ(said, "no more paper");
}
