#include "app/editor/workers/preview.h"
#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"
#include "widgets/inputs/vector_field.h"
#include "widgets/view/region_handles.h"

#include <QLabel>
#include <QListWidget>

#include <cmath>

using namespace esm;

namespace {

/// The liver with the region "soft" selected and the tool Region in hand.
class RegionsTest : public EditorTest {
protected:
    void SetUp() override {
        Project liver = makeSample("liver");
        liver.regions.erase(liver.regions.begin() + 1, liver.regions.end());
        open(std::move(liver));
        if (HasFatalFailure()) return;
        press(Qt::Key_Space); // nothing moves by itself
        press(Qt::Key_R, Qt::ControlModifier);
        ASSERT_EQ(project().regions.size(), 2U);
        ASSERT_EQ(toolInHand(), "region");
    }
    const Region& region() const { return project().regions[1]; }
    QUndoStack* steps() { return window->document().undoStack(); }
    QListWidget* list() { return child<QListWidget>("regionList"); }

    /// Where a handle of the selected region is seen.
    QPoint handle(RegionHandle::Kind kind) {
        const OrganView& view = window->view();
        const Camera& camera = view.camera();
        const double distance = (camera.eye - region().ellipsoid->centre).dot(cameraAxes(camera).col(2));
        const double pixel = 2 * std::tan(camera.verticalFieldOfView / 2) * distance / view.height();
        for (const RegionHandle& found :
             regionHandles({*region().ellipsoid, {}, true, region().rim}, camera, 26 * pixel))
            if (found.kind == kind) return placeOf(found.place);
        return {-1, -1};
    }
    bool isAtRest() {
        const auto& now = window->view().scene().nodePositions;
        const auto& rest = project().network->restPositions;
        double largest = 0;
        for (std::size_t i = 0; i < now.size(); ++i)
            largest = std::max(largest, (now[i] - rest[i]).norm());
        return largest < 1e-5;
    }
    /// Undoes one step and does it again.
    void expectOneStep(int before) {
        EXPECT_EQ(steps()->count(), before + 1) << steps()->undoText().toStdString();
        const Project after = project();
        press(Qt::Key_Z, Qt::ControlModifier);
        EXPECT_TRUE(difference(after, project()).regions);
        press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        EXPECT_FALSE(difference(after, project()).any());
    }
};

} // namespace

TEST_F(RegionsTest, HandlesMoveSizeAndTurnInOneStepEach) {
    const Ellipsoid first = *region().ellipsoid;
    int before = steps()->count();
    drag(placeOf(first.centre) + QPoint(12, 9), {30, 10});
    EXPECT_NE(region().ellipsoid->centre, first.centre);
    EXPECT_EQ(region().ellipsoid->radii, first.radii);
    expectOneStep(before++);
    drag(handle(RegionHandle::Kind::Size), {24, 0});
    EXPECT_NE(region().ellipsoid->radii, first.radii);
    expectOneStep(before++);
    drag(handle(RegionHandle::Kind::Turn), {-10, -50});
    EXPECT_GT(region().ellipsoid->orientation.angularDistance(first.orientation), 0.1);
    expectOneStep(before++);
    while (steps()->canUndo())
        press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(project().regions.size(), 1U);
}

TEST_F(RegionsTest, RimIsDrawnOutOrTypedAndShown) {
    const QString sharp = child<QLabel>("nodesInside")->text();
    auto* field = child<NumberField>("ellipsoidRim");
    EXPECT_EQ(field->value(), 0);
    int before = steps()->count();
    drag(handle(RegionHandle::Kind::Rim), {25, -25});
    EXPECT_GT(region().rim, 0.001);
    EXPECT_EQ(field->value(), region().rim);
    expectOneStep(before++);
    EXPECT_GT(window->view().scene().ellipsoids.back().rim, 0);
    const RegionCount count = countOf(*project().network, region());
    EXPECT_GT(count.rimNodes, 0U);
    EXPECT_EQ(child<QLabel>("nodesInside")->text(), sharp + QString(", rim %1").arg(count.rimNodes));
    typeInto(field, "4");
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_DOUBLE_EQ(region().rim, 0.004);
    expectOneStep(before++);
    typeInto(field, "-1");
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_DOUBLE_EQ(region().rim, 0.004);
    EXPECT_FALSE(field->refusal().isEmpty());
}

TEST_F(RegionsTest, WhatTheSelectedRegionHoldsIsMarked) {
    const auto& marked = window->view().scene().marked;
    ASSERT_TRUE(marked);
    EXPECT_EQ(marked->colour, region().colour);
    EXPECT_EQ(*marked->weights, nodeWeights(*project().network, region()));
    press(Qt::Key_H);
    EXPECT_FALSE(window->view().scene().marked);
    press(Qt::Key_H);
    list()->setCurrentRow(1);
    EXPECT_FALSE(window->view().scene().marked) << "the whole organ needs no mark";
    const std::size_t fixed = window->view().scene().fixedNodes.size();
    list()->setCurrentRow(0);
    window->windowActions().fixRegion->trigger();
    EXPECT_GT(window->view().scene().fixedNodes.size(), fixed);
    EXPECT_EQ(window->view().scene().fixedNodes, fixedNodesOf(*project().network, project().scene));
}

TEST_F(RegionsTest, OneClickLaysARegionOnASpot) {
    const Ellipsoid first = *region().ellipsoid;
    int before = steps()->count();
    window->windowActions().reset->trigger();
    ESM_EVENTUALLY(isAtRest());
    press(Qt::Key_O);
    ASSERT_EQ(toolInHand(), "place");
    const QPoint spot = window->view().rect().center() + QPoint(-60, 10);
    QTest::mouseClick(&window->view(), Qt::LeftButton, {}, spot);
    EXPECT_EQ(toolInHand(), "region") << "to be shaped next";
    EXPECT_EQ(project().regions.size(), 2U);
    EXPECT_EQ(region().ellipsoid->radii, first.radii);
    EXPECT_LE((placeOf(region().ellipsoid->centre) - spot).manhattanLength(), 3);
    expectOneStep(before++);
    press(Qt::Key_O);
    QTest::mouseClick(&window->view(), Qt::LeftButton, Qt::ControlModifier, spot + QPoint(80, 0));
    ASSERT_EQ(project().regions.size(), 3U);
    EXPECT_GT(countOf(*project().network, project().regions[2]).nodes, 0U);
    expectOneStep(before++);
}

TEST_F(RegionsTest, ARenameAndAColourAreNoNewTissue) {
    const int projects = window->preview().projectCount();
    window->document().edit("rename", [](Project& p) { p.regions[1].name = "tumour"; });
    window->document().edit("colour", [](Project& p) { p.regions[1].colour = {10, 20, 30}; });
    window->document().edit("organ", [](Project& p) { p.name = "my organ"; });
    EXPECT_EQ(window->preview().projectCount(), projects);
    window->document().edit("tissue", [](Project& p) { p.regions[1].held.springConstant = 77; });
    EXPECT_EQ(window->preview().projectCount(), projects + 1);
}

TEST_F(RegionsTest, AnEditMakesItsPartOfThePictureAnewAndNoOther) {
    window->preview().setPlaying(false);
    ESM_EVENTUALLY(!window->preview().status().playing && window->view().isUpToDate());
    const RenderScene& scene = window->view().scene();
    const auto* const nodes = scene.nodePositions.data();
    const auto rim = scene.ellipsoids.front().rim;
    window->document().edit("rim", [](Project& p) { p.regions[1].rim += 0.01; });
    EXPECT_DOUBLE_EQ(scene.ellipsoids.front().rim, rim + 0.01);
    window->document().edit("colour", [](Project& p) { p.texture.baseColour = {1, 2, 3}; });
    EXPECT_EQ(scene.baseColour, (Colour{1, 2, 3}));
    EXPECT_EQ(scene.nodePositions.data(), nodes) << "the organ's places were not even copied";
}

TEST_F(RegionsTest, OrderChangesByKeysAndTissueWithIt) {
    window->document().edit("overlap", [](Project& p) {
        p.regions.push_back(p.regions[1]);
        numberByPlace(p.regions);
        for (std::size_t i : {1U, 2U}) {
            p.regions[i].system = nullptr;
            p.regions[i].inputs.clear();
            p.regions[i].name = i == 1 ? "first" : "second";
            p.regions[i].held.springConstant = 100.0 * double(i);
        }
    });
    const auto inside = [&] {
        const auto weights = nodeWeights(*project().network, project().regions[1]);
        const auto node = std::find(weights.begin(), weights.end(), 1) - weights.begin();
        return evaluateModel(project()).springConstant[static_cast<std::size_t>(node)];
    };
    EXPECT_EQ(inside(), 200);
    const int before = steps()->count();
    list()->setCurrentRow(0);
    QTest::keyClick(list(), Qt::Key_Down, Qt::ControlModifier);
    EXPECT_EQ(project().regions[2].name, "first");
    EXPECT_EQ(inside(), 100);
    EXPECT_EQ(list()->currentRow(), 1) << "what was moved stays selected";
    QTest::keyClick(list(), Qt::Key_Down, Qt::ControlModifier);
    EXPECT_EQ(list()->currentRow(), 1) << "the whole organ stays beneath";
    expectOneStep(before);
}

TEST_F(RegionsTest, ACopyLiesAboveItsModel) {
    const int before = steps()->count();
    press(Qt::Key_D, Qt::ControlModifier);
    ASSERT_EQ(project().regions.size(), 3U);
    EXPECT_EQ(project().regions[2].ellipsoid->radii, region().ellipsoid->radii);
    EXPECT_EQ(list()->currentRow(), 0) << "the copy is selected";
    expectOneStep(before);
}

// The middle of a bent organ's box may be empty, or behind what one looks at.
TEST_F(RegionsTest, ANewRegionLiesOnTheSurfaceInTheMiddleOfTheView) {
    for (QAction* side : window->windowActions().standardViews) {
        side->trigger();
        window->windowActions().addRegion->trigger();
        const Ellipsoid& added = *project().regions.back().ellipsoid;
        const SurfaceQuery query(project().mesh->vertices, project().mesh->triangles);
        EXPECT_LT(query.nearest(added.centre)->distance, added.radii.maxCoeff() / 4);
        const QPoint seen = placeOf(added.centre), middle = window->view().rect().center();
        EXPECT_LT(std::hypot(seen.x() - middle.x(), seen.y() - middle.y()), 40);
        const Camera& camera = window->view().camera();
        const auto hit = query.firstHit({camera.eye, (added.centre - camera.eye).normalized()});
        ASSERT_TRUE(hit);
        EXPECT_GT(hit->distance + added.radii.maxCoeff(), (added.centre - camera.eye).norm())
            << "it is on the side that is seen";
    }
}
