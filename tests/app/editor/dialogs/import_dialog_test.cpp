#include "app/editor/dialogs/import_dialog.h"

#include "app/editor/dialogs/extent_text.h"
#include "tests/support/cut_ball.h"
#include "tests/support/eventually.h"
#include "tests/support/test_meshes.h"
#include "widgets/inputs/number_text.h"

#include <gtest/gtest.h>
#include <QAbstractButton>
#include <QComboBox>
#include <QLabel>
#include <QPlainTextEdit>
#include <QScreen>
#include <QTest>
#include <QWheelEvent>

#include <thread>

using namespace esm;

namespace {

/// A box of three unequal sides, a smaller one, and a triangle; mm, say.
PolygonSoup threeParts() {
    PolygonSoup soup = test::soupOf(test::ball({.rings = 60, .segments = 60, .radius = 100}));
    for (Eigen::Vector3d& vertex : soup.vertices)
        vertex.array() *= Eigen::Array3d(1, 0.5, 0.5);
    test::append(soup, test::cubeSoup(10, {300, 0, 0}));
    test::append(soup, {{{400, 0, 0}, {401, 0, 0}, {400, 1, 0}}, {{0, 1, 2}}});
    return soup;
}

/// A ball of 120 mm that is cut open, in millimetres.
PolygonSoup openBall() {
    PolygonSoup soup = test::soupOf(test::cutBall().mesh);
    for (Eigen::Vector3d& vertex : soup.vertices)
        vertex *= 1000;
    return soup;
}

struct Shown {
    explicit Shown(const PolygonSoup& soup)
        : dialog("organ.obj", std::make_shared<const PolygonSoup>(soup),
                 std::make_shared<const ImportedSurface>(importedSurface(soup, {}))) {
        // The preview comes a moment later.
        while (!preview().mesh)
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }

    template<typename Widget> Widget* child(const char* name) const {
        return dialog.findChild<Widget*>(name);
    }
    QString text(const char* label) const { return child<QLabel>(label)->text(); }
    QString reported() const { return child<QPlainTextEdit>("importReport")->toPlainText(); }
    const RenderScene& preview() const { return dialog.findChild<OrganView*>()->scene(); }
    NumberField* nodes() const {
        for (auto* field : dialog.findChildren<NumberField*>())
            if (field->accessibleName() == "Nodes") return field;
        return nullptr;
    }
    /// As the window that keys go to.
    void activate() {
        dialog.show();
        dialog.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&dialog, patience));
    }
    std::size_t markedEdges() const { return preview().network ? preview().network->springs.size() : 0; }

    ImportDialog dialog;
};

} // namespace

TEST(ImportDialog, ShowsTheSizeOfWhatIsKept) {
    Shown shown(threeParts());
    EXPECT_EQ(shown.text("importSize"), "501 × 100 × 100 mm");
    EXPECT_TRUE(shown.reported().contains("3 parts"));
    shown.child<QComboBox>("importKeep")->setCurrentIndex(1);
    ESM_EVENTUALLY(shown.text("importSize") == "200 × 100 × 100 mm");
    EXPECT_FALSE(shown.reported().contains("3 parts"));
    EXPECT_EQ(shown.preview().mesh->vertices.size(), 59U * 60 + 2); // the other parts are not shown
    for (const auto* choice : shown.dialog.findChildren<QComboBox*>())
        EXPECT_FALSE(choice->accessibleName().isEmpty());
    for (const auto* field : shown.dialog.findChildren<NumberField*>())
        EXPECT_FALSE(field->accessibleName().isEmpty());
}

TEST(ImportDialog, TheWheelScrollsPastItsChoices) {
    Shown shown(threeParts());
    shown.activate();
    shown.dialog.setFocus();
    for (auto* choice : shown.dialog.findChildren<QComboBox*>()) {
        const int before = choice->currentIndex();
        QWheelEvent turned({5, 5}, choice->mapToGlobal(QPoint(5, 5)), {}, {0, -120}, Qt::NoButton,
                           Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(choice, &turned);
        EXPECT_EQ(choice->currentIndex(), before) << choice->accessibleName().toStdString();
    }
}

TEST(ImportDialog, DoubtsASizeNoOrganHasWithoutAJump) {
    Shown shown(openBall());
    EXPECT_EQ(shown.text("importDoubt"), "");
    const int height = shown.dialog.sizeHint().height();
    shown.child<QAbstractButton>("unit2")->click();
    EXPECT_TRUE(shown.text("importDoubt").contains("120 mm in millimetres"));
    EXPECT_EQ(shown.dialog.sizeHint().height(), height);
    EXPECT_TRUE(doubtfulExtent(1e-9, LengthUnit::Metre).contains("no unit"));
}

TEST(ImportDialog, SaysWhatAnOpenBorderMeans) {
    EXPECT_FALSE(Shown(test::cubeSoup(100)).reported().contains("3 mm"));
    EXPECT_TRUE(Shown(openBall()).reported().contains("3 mm"));
}

TEST(ImportDialog, SaysWhetherTextureCoordinatesAreOfUse) {
    PolygonSoup soup;
    soup.vertices = {{0, 0, 0}, {100, 0, 0}, {0, 100, 0}};
    soup.polygons = {{0, 1, 2}};
    EXPECT_FALSE(Shown(soup).reported().contains("texture coordinates"));
    soup.textureCoordinates = {{{0, 0}, {1, 0}, {0, 1}}};
    EXPECT_TRUE(Shown(soup).reported().contains("can lay photos by them"));
    soup.textureCoordinates = {{{0, 0}, {2, 0}, {0, 1}}};
    EXPECT_TRUE(
        Shown(soup).reported().contains("no photo can be laid: 1 triangle whose texture coordinates leave"));
}

TEST(ImportDialog, ListsThePartsWithTheirSizes) {
    Shown shown(threeParts());
    const auto* keep = shown.child<QComboBox>("importKeep");
    EXPECT_EQ(keep->itemText(0), "all 3 parts");
    EXPECT_TRUE(keep->itemText(1).contains("triangles"));
    EXPECT_TRUE(shown.reported().contains("200 × 100 × 100 mm"));
    EXPECT_TRUE(shown.reported().contains("2: 12 triangles, 10 × 10 × 10 mm"))
        << shown.reported().toStdString();
    EXPECT_TRUE(shown.reported().contains("3: 1 triangle,"));
}

TEST(ImportDialog, TurnsThePreviewAsTheAxisSays) {
    Shown shown(threeParts());
    const auto sizes = [&] { return Eigen::Vector3d(boundingBox(shown.preview().mesh->vertices).sizes()); };
    EXPECT_NEAR(sizes().x(), 0.501, 1e-9); // m
    Shown tall(test::soupOf(test::ball()));
    const std::vector<Eigen::Vector3d> before = tall.preview().mesh->vertices;
    for (auto* choice : tall.dialog.findChildren<QComboBox*>())
        if (choice->itemText(1) == "z axis") choice->setCurrentIndex(1);
    EXPECT_EQ(tall.dialog.choice().up, UpAxis::Z);
    ESM_EVENTUALLY(tall.preview().mesh->vertices != before);
    for (std::size_t i = 0; i < before.size(); ++i)
        EXPECT_EQ(tall.preview().mesh->vertices[i],
                  Eigen::Vector3d(before[i].x(), before[i].z(), -before[i].y()));
}

TEST(ImportDialog, MarksOpenBordersAndClosesThemWhenAsked) {
    Shown shown(openBall());
    EXPECT_TRUE(shown.text("openBorders").contains("1 open border: 162 edges, its sides 0.60 mm apart"))
        << shown.text("openBorders").toStdString();
    EXPECT_EQ(shown.markedEdges(), 162U);
    EXPECT_EQ(shown.dialog.choice().slitWidth, 0);
    EXPECT_FALSE(shown.child<NumberField>("slitWidth")->isEnabled());
    shown.child<QCheckBox>("closesSlits")->click();
    EXPECT_NEAR(shown.dialog.choice().slitWidth, 6.6e-4, 1e-5); // m
    ESM_EVENTUALLY(shown.text("closedSlits") == "162 edges closed");
    EXPECT_EQ(shown.markedEdges(), 0U);
    EXPECT_TRUE(shown.reported().contains("162 border edges of slits closed"));
    EXPECT_TRUE(shown.reported().contains("162 border edges in the file, 162 closed with slits: none left"));
    EXPECT_EQ(shown.text("leftOpen"), "Left open: nothing");
    shown.child<QCheckBox>("closesSlits")->click();
    ESM_EVENTUALLY(shown.markedEdges() == 162);
    EXPECT_EQ(shown.text("closedSlits"), "");
}

TEST(ImportDialog, FillsHolesWhenAsked) {
    PolygonSoup soup = test::soupOf(test::ball({.rings = 20, .segments = 30, .radius = 100}));
    soup.polygons.erase(soup.polygons.begin() + 100, soup.polygons.begin() + 102);
    Shown shown(soup);
    EXPECT_EQ(shown.markedEdges(), 4U);
    shown.child<QCheckBox>("fillsHoles")->click();
    EXPECT_EQ(shown.dialog.choice().holeEdges, 30U);
    ESM_EVENTUALLY(shown.text("filledHoles") == "1 hole filled, 4 edges");
    EXPECT_EQ(shown.text("leftOpen"), "Left open: nothing");
    EXPECT_EQ(shown.markedEdges(), 0U);
}

TEST(ImportDialog, OffersNoRepairOfAClosedSurface) {
    Shown shown(test::cubeSoup(100));
    EXPECT_EQ(shown.text("openBorders"), "No open border");
    for (const char* name : {"closesSlits", "fillsHoles"}) {
        EXPECT_FALSE(shown.child<QCheckBox>(name)->isEnabled());
        EXPECT_TRUE(shown.child<QCheckBox>(name)->toolTip().contains("no open border"));
    }
}

TEST(ImportDialog, LimitsTheWidthByTheOrgansSize) {
    Shown shown(openBall());
    const auto most = [&] { return shown.child<NumberField>("slitWidth")->format().maximum; };
    EXPECT_NEAR(most(), 0.012, 1e-9); // m
    shown.child<QAbstractButton>("unit1")->click();
    EXPECT_NEAR(most(), 0.12, 1e-9);
}

TEST(ImportDialog, TakesTheWidthThatItShowsAsTheLimitAndNoneAboveIt) {
    PolygonSoup soup = openBall();
    for (Eigen::Vector3d& vertex : soup.vertices)
        vertex *= 1.6814; // 201.768 mm: a tenth of it is shown as 20.17 mm, and would be rounded to 20.18
    Shown shown(soup);
    auto* width = shown.child<NumberField>("slitWidth");
    QStringList limits;
    for (const auto* label : shown.dialog.findChildren<QLabel*>())
        if (label->text().startsWith("at most ")) limits << label->text();
    EXPECT_EQ(limits, QStringList("at most 20.17 mm"));
    shown.child<QCheckBox>("closesSlits")->click();
    for (const auto& [text, isTaken] : {std::pair("20.17", true), {"20.18", false}}) {
        width->selectAll();
        QTest::keyClicks(width, text);
        width->takeTyped();
        EXPECT_EQ(width->refusal().isEmpty(), isTaken) << text;
    }
    EXPECT_TRUE(width->refusal().contains("20.17 mm"));
}

TEST(ImportDialog, TellsOfBorderEdgesAroundNoHole) {
    PolygonSoup soup = test::cubeSoup(100);
    const auto first = static_cast<std::uint32_t>(soup.vertices.size());
    soup.vertices.insert(soup.vertices.end(), {{0, 0, 0}, {100, 0, 0}, {50, -60, -60}});
    soup.polygons.push_back({first, first + 1, first + 2}); // on an edge of the cube
    Shown shown(soup);
    EXPECT_EQ(shown.text("openBorders"), "In the file: 2 edges of open borders around no hole");
    EXPECT_EQ(shown.markedEdges(), 2U);
    shown.child<QCheckBox>("fillsHoles")->click();
    ESM_EVENTUALLY(shown.text("leftOpen") == "Left open: 2 edges, around no hole");
    EXPECT_EQ(shown.text("filledHoles"), "0 holes filled, 0 edges");
    EXPECT_TRUE(shown.reported().contains("2 border edges around no hole"));
}

TEST(ImportDialog, ImportsNothingWhileANumberIsRefused) {
    for (const auto& [box, field] : {std::pair("closesSlits", "slitWidth"), {"fillsHoles", "holeEdges"}})
        for (const char* text : {"1e99", "abc", "99999999"}) {
            Shown shown(openBall());
            shown.dialog.show();
            shown.child<QCheckBox>(box)->click();
            auto* number = shown.child<NumberField>(field);
            number->setFocus();
            number->selectAll();
            QTest::keyClicks(number, text);
            shown.dialog.accept();
            EXPECT_TRUE(shown.dialog.isVisible()) << text;
            EXPECT_EQ(number->text(), text);
            EXPECT_FALSE(number->refusal().isEmpty());
            EXPECT_EQ(shown.dialog.focusWidget(), number);
            shown.child<QCheckBox>(box)->click(); // what is not asked for does not matter
            shown.dialog.accept();
            EXPECT_FALSE(shown.dialog.isVisible());
        }
}

TEST(ImportDialog, KeepsARefusedNumberOfNodesWhenAnAnswerComes) {
    Shown shown(threeParts());
    shown.activate();
    shown.child<QComboBox>("importDetail")->setCurrentIndex(1);
    NumberField* nodes = shown.nodes();
    nodes->setFocus();
    nodes->selectAll();
    QTest::keyClicks(nodes, "99999999");
    QTest::keyClick(nodes, Qt::Key_Tab);
    shown.child<QComboBox>("importKeep")->setCurrentIndex(1);
    ESM_EVENTUALLY(shown.text("importSize") == "200 × 100 × 100 mm");
    EXPECT_EQ(nodes->text(), "99999999");
    shown.dialog.accept();
    EXPECT_TRUE(shown.dialog.isVisible());
}

TEST(ImportDialog, ClosesOnEscapeWhateverHasTheFocus) {
    for (const char* name : {"", "preview", "importReport", "importKeep", "slitWidth", "unit1"}) {
        Shown shown(openBall());
        shown.activate();
        shown.child<QCheckBox>("closesSlits")->click();
        QWidget* focus = shown.child<QWidget>(name);
        if (QString(name) == "preview") focus = shown.dialog.findChild<OrganView*>();
        if (!*name)
            focus = &shown.dialog;
        else
            focus->setFocus();
        QTest::keyClick(focus, Qt::Key_Escape);
        EXPECT_FALSE(shown.dialog.isVisible()) << name;
    }
}

TEST(ImportDialog, TakesBackWhatIsTypedBeforeEscapeCloses) {
    Shown shown(openBall());
    shown.activate();
    shown.child<QCheckBox>("closesSlits")->click();
    auto* width = shown.child<NumberField>("slitWidth");
    width->setFocus();
    const QString before = width->text();
    QTest::keyClicks(width, "5");
    QTest::keyClick(width, Qt::Key_Escape);
    EXPECT_TRUE(shown.dialog.isVisible());
    EXPECT_EQ(width->text(), before);
    QTest::keyClick(width, Qt::Key_Escape);
    EXPECT_FALSE(shown.dialog.isVisible());
}

TEST(ImportDialog, GivesAllThreeLengthsOneUnit) {
    EXPECT_EQ(lengthsText({0.967, 1.6704, 0.329}), "0.967 × 1.67 × 0.329 m");
    EXPECT_EQ(lengthsText({0.967, 0.0021, 0.329}), "967 × 2.1 × 329 mm");
}

TEST(ImportDialog, SaysThatThePreviewIsBeingMade) {
    const PolygonSoup soup = openBall();
    ImportDialog dialog("organ.obj", std::make_shared<const PolygonSoup>(soup),
                        std::make_shared<const ImportedSurface>(importedSurface(soup, {})));
    const auto* view = dialog.findChild<OrganView*>();
    EXPECT_TRUE(view->hint().contains("being made"));
    dialog.show();
    ESM_EVENTUALLY(view->hint().contains("amber"));
    EXPECT_NE(view->scene().mesh, nullptr);
}

TEST(ImportDialog, MayBeClosedWhileItWorks) {
    Shown shown(openBall());
    shown.child<QCheckBox>("closesSlits")->click();
    shown.dialog.reject();
    shown.dialog.stopWork();
    QCoreApplication::processEvents();
    EXPECT_EQ(shown.markedEdges(), 162U);
}

TEST(ImportDialog, AsksHowMuchIsSimulated) {
    Shown shown(threeParts());
    const auto vertices = static_cast<double>(shown.preview().mesh->vertices.size());
    auto* detail = shown.child<QComboBox>("importDetail");
    NumberField* nodes = shown.nodes();
    ASSERT_NE(nodes, nullptr);
    EXPECT_TRUE(shown.text("importSuggestion").contains(countText(2000) + " nodes"))
        << shown.text("importSuggestion").toStdString();
    EXPECT_EQ(shown.dialog.choice().body.detail.kind, Detail::Kind::EveryVertex);
    EXPECT_EQ(nodes->value(), vertices);
    EXPECT_FALSE(nodes->isEnabled());
    detail->setCurrentIndex(1);
    EXPECT_TRUE(nodes->isEnabled());
    EXPECT_EQ(shown.dialog.choice().body.detail.kind, Detail::Kind::Nodes);
    EXPECT_EQ(shown.dialog.choice().body.detail.nodes, 2000U);
    detail->setCurrentIndex(2);
    EXPECT_EQ(shown.dialog.choice().body.detail.kind, Detail::Kind::Rigid);
    EXPECT_EQ(nodes->value(), 8);
    EXPECT_FALSE(nodes->isEnabled());
    EXPECT_TRUE(Shown(test::cubeSoup(100)).text("importSuggestion").contains("every vertex"));
}

TEST(ImportDialog, WhatWasToldBeforeTheAnswerIsForNobodyAfterIt) {
    Shown shown(threeParts());
    auto* importer = shown.dialog.findChild<SurfaceImporter*>();
    std::thread([importer] { emit importer->answered(); }).join();
    shown.dialog.done(QDialog::Rejected);
    shown.dialog.stopWork();
    QCoreApplication::sendPostedEvents(&shown.dialog);
    EXPECT_TRUE(shown.preview().mesh);
}
