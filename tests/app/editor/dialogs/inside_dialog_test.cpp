#include "app/editor/dialogs/inside_dialog.h"

#include "core/project/detail_change.h"
#include "tests/support/crossed_ball.h"
#include "tests/support/eventually.h"
#include "tests/support/solid_surfaces.h"

#include <gtest/gtest.h>
#include <QAbstractItemView>
#include <QDialogButtonBox>
#include <QTest>
#include <QWindow>

using namespace esm;

namespace {

Project ball(bool isOpen = false) {
    TriangleMesh mesh = test::ball(0.04, {0, 0, 0});
    if (isOpen) mesh.triangles.pop_back();
    return makeProject("ball", {std::move(mesh), {}});
}

struct ShownInside {
    explicit ShownInside(const Project& project) : dialog(project) { dialog.show(); }

    template<typename Widget> Widget* child(const char* name) const {
        return dialog.findChild<Widget*>(name);
    }
    QString text(const char* label) const { return child<QLabel>(label)->text(); }
    bool mayFill() const { return child<QPushButton>("insideAccept")->isEnabled(); }
    const RenderScene& scene() const { return dialog.findChild<OrganView*>()->scene(); }
    void choose(const QString& kind) const {
        auto* box = child<QComboBox>("insideKind");
        const int place = box->findText(kind);
        ASSERT_GE(place, 0) << kind.toStdString();
        box->setCurrentIndex(place);
    }
    void type(const QString& number, const char* name = "insideSpacing") const {
        auto* field = child<NumberField>(name);
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, number);
        field->takeTyped();
    }
    bool takesNumber(const char* name) const { return child<NumberField>(name)->isEnabled(); }

    InsideDialog dialog;
};

} // namespace

TEST(InsideDialog, FillsAHollowOrganAsIsUsualAndShowsIt) {
    const ShownInside shown(ball());
    ESM_EVENTUALLY(shown.mayFill());
    EXPECT_TRUE(shown.text("insideCounts").contains("nodes")) << shown.text("insideCounts").toStdString();
    EXPECT_TRUE(shown.text("insideFirmness").contains("kPa"));
    ASSERT_TRUE(shown.scene().network->lattice);
    const auto nodes = static_cast<double>(shown.scene().network->restPositions.size());
    EXPECT_NEAR(nodes / usualLatticeNodes, 1, 0.3);
    EXPECT_TRUE(shown.scene().cut);
    const Detail detail = shown.dialog.detail();
    EXPECT_EQ(detail.kind, Detail::Kind::Filled);
    EXPECT_EQ(detail.filling->kind, LatticeKind::BodyCentred);
    EXPECT_EQ(shown.scene().network->lattice->filling, *detail.filling);
}

TEST(InsideDialog, FollowsKindAndSpacing) {
    const ShownInside shown(ball());
    shown.choose("solid, cubic lattice");
    shown.type("12");
    ESM_EVENTUALLY(shown.mayFill());
    EXPECT_EQ(shown.dialog.detail().filling, (LatticeFilling{LatticeKind::Cubic, 0.012}));
    EXPECT_EQ(shown.scene().network->lattice->filling, (LatticeFilling{LatticeKind::Cubic, 0.012}));
    shown.choose("hollow");
    EXPECT_TRUE(shown.mayFill());
    EXPECT_FALSE(shown.child<NumberField>("insideSpacing")->isEnabled());
    EXPECT_EQ(shown.dialog.detail(), Detail());
    EXPECT_FALSE(shown.scene().network->lattice);
}

TEST(InsideDialog, GivesAnOpenOrganAWallAsThickAsItsWallIs) {
    Project open = ball(true);
    open.base.wallThickness = 0.004;
    const ShownInside shown(open);
    shown.choose("hollow, with a wall of prisms");
    ESM_EVENTUALLY(shown.mayFill());
    EXPECT_EQ(shown.dialog.detail().filling, (LatticeFilling{LatticeKind::Prisms, 0, 0.004, 2}));
    EXPECT_EQ(shown.scene().network->lattice->filling, *shown.dialog.detail().filling);
    EXPECT_TRUE(shown.text("insideRefusal").isEmpty()) << shown.text("insideRefusal").toStdString();
    EXPECT_TRUE(shown.text("insideCounts").contains("MB of memory"));
    EXPECT_TRUE(shown.text("insideCounts").contains("about 9 × that of the hollow organ"))
        << shown.text("insideCounts").toStdString();
}

TEST(InsideDialog, FollowsThicknessAndLayers) {
    const ShownInside shown(ball());
    EXPECT_FALSE(shown.takesNumber("insideThickness"));
    EXPECT_FALSE(shown.takesNumber("insideLayers"));
    shown.choose("hollow, with a wall of prisms");
    EXPECT_TRUE(shown.takesNumber("insideThickness"));
    EXPECT_FALSE(shown.takesNumber("insideSpacing"));
    shown.type("10", "insideThickness");
    ESM_EVENTUALLY(shown.mayFill());
    const LatticeFilling thick = *shown.dialog.detail().filling;
    EXPECT_EQ(thick.wallThickness, 0.01);
    EXPECT_GT(thick.layers, 2) << "as many as are usual for so thick a wall";
    shown.type("1", "insideLayers");
    ESM_EVENTUALLY(shown.mayFill());
    shown.type("8", "insideThickness");
    ESM_EVENTUALLY(shown.mayFill());
    EXPECT_EQ(shown.dialog.detail().filling, (LatticeFilling{LatticeKind::Prisms, 0, 0.008, 1}))
        << "what was typed stays";
    EXPECT_EQ(shown.scene().network->lattice->filling, *shown.dialog.detail().filling);
}

TEST(InsideDialog, SaysWhereAWallHasNoRoom) {
    const ShownInside shown(ball());
    shown.choose("hollow, with a wall of prisms");
    shown.type("38", "insideThickness");
    ESM_EVENTUALLY(shown.mayFill());
    EXPECT_TRUE(shown.text("insideRefusal").contains("vertices have a thinner wall than asked for"))
        << shown.text("insideRefusal").toStdString();
    shown.type("100", "insideThickness");
    ESM_EVENTUALLY(shown.text("insideRefusal").contains("A wall of 100 mm is too thick"));
    EXPECT_FALSE(shown.mayFill());
    EXPECT_TRUE(shown.text("insideCounts").isEmpty());
}

TEST(InsideDialog, OpensWithTheWallOfTheOrgan) {
    const Detail walled{Detail::Kind::Filled, 0, LatticeFilling{LatticeKind::Prisms, 0, 0.003, 1}};
    const ShownInside shown(withDetail(ball(), walled));
    ESM_EVENTUALLY(shown.mayFill());
    EXPECT_EQ(shown.dialog.detail().filling, walled.filling);
}

TEST(InsideDialog, OpensWithAWallWhereTheSurfaceIsOpen) {
    TriangleMesh mesh = test::ball(0.04, {0, 0, 0});
    mesh.triangles.pop_back();
    RepairReport report;
    report.boundaryEdges = 3;
    const ShownInside shown(makeProject("open ball", {std::move(mesh), report}));
    ESM_EVENTUALLY(shown.mayFill());
    EXPECT_EQ(shown.dialog.detail().filling, (LatticeFilling{LatticeKind::Prisms, 0, 0.003, 2}));
}

TEST(InsideDialog, OpensWithWhatFillsTheOrgan) {
    const Detail filled{Detail::Kind::Filled, 0, LatticeFilling{LatticeKind::Diamond, 0.011}};
    const ShownInside shown(withDetail(ball(), filled));
    ESM_EVENTUALLY(shown.mayFill());
    EXPECT_EQ(shown.dialog.detail().filling, filled.filling);
}

TEST(InsideDialog, SaysWhyAnOrganCannotBeFilled) {
    const ShownInside open(ball(true));
    ESM_EVENTUALLY(!open.text("insideRefusal").isEmpty());
    EXPECT_TRUE(open.text("insideRefusal").contains("open")) << open.text("insideRefusal").toStdString();
    EXPECT_FALSE(open.mayFill());
    const ShownInside closed(ball());
    ESM_EVENTUALLY(closed.mayFill());
    closed.type("0.05");
    ESM_EVENTUALLY(closed.text("insideRefusal").contains("million nodes"));
    EXPECT_FALSE(closed.mayFill());
    closed.type("10");
    ESM_EVENTUALLY(closed.mayFill());
    EXPECT_TRUE(closed.text("insideRefusal").isEmpty());
}

TEST(InsideDialog, SaysWhereTheLatticePassesOverACrossing) {
    TriangleMesh mesh = test::crossedBall();
    for (Eigen::Vector3d& vertex : mesh.vertices)
        vertex *= 0.04;
    const ShownInside shown(makeProject("ball", {std::move(mesh), {}}));
    ESM_EVENTUALLY(shown.mayFill());
    EXPECT_TRUE(shown.text("insideRefusal").contains("runs through itself in one place"))
        << shown.text("insideRefusal").toStdString();
    shown.type("1");
    ESM_EVENTUALLY(shown.text("insideRefusal").contains("choose a spacing of"));
    EXPECT_FALSE(shown.mayFill());
}

TEST(InsideDialog, EnterOnTheWayToFillThrowsNothingAway) {
    ShownInside shown(ball());
    ESM_EVENTUALLY(shown.mayFill());
    shown.type("4");
    ASSERT_FALSE(shown.mayFill()) << "the inside is being made";
    auto* cancel = shown.dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Cancel);
    cancel->setFocus();
    QTest::keyClick(cancel, Qt::Key_Return);
    EXPECT_TRUE(shown.dialog.isVisible());
    QTest::keyClick(cancel, Qt::Key_Space);
    EXPECT_FALSE(shown.dialog.isVisible());
}

TEST(InsideDialog, EscapeClosesItsOpenListFirst) {
    const ShownInside shown(ball());
    ESM_EVENTUALLY(shown.mayFill());
    auto* kind = shown.child<QComboBox>("insideKind");
    kind->showPopup();
    ESM_EVENTUALLY(kind->view()->isVisible());
    QTest::keyClick(shown.dialog.windowHandle(), Qt::Key_Escape); // X11 gives it the keys
    ESM_EVENTUALLY(!kind->view()->isVisible());
    EXPECT_TRUE(shown.dialog.isVisible());
    QTest::keyClick(shown.dialog.windowHandle(), Qt::Key_Escape);
    ESM_EVENTUALLY(!shown.dialog.isVisible());
}
