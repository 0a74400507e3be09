#include "app/editor/document/selection.h"

#include "app/editor/document/document.h"
#include "core/authoring/regions.h"
#include "core/samples/samples.h"

#include <gtest/gtest.h>

using namespace esm;

namespace {

Project tubeWithThreeRegions() {
    Project project = makeSample("tube");
    project.regions.clear();
    for (int i = 0; i < 3; ++i)
        addRegion(project, nextId(project.regions), Eigen::Vector3d::Zero());
    return project;
}

/// Adds a region, and gives it.
RegionId addTo(Document& document) {
    const RegionId id = document.newRegionId();
    document.edit("add", [&](Project& project) { addRegion(project, id, Eigen::Vector3d::Zero()); });
    return id;
}

} // namespace

TEST(Selection, FollowsWhatIsAddedAndRemoved) {
    Document document(makeSample("tube"));
    Selection selection(document);
    const RegionId first = addTo(document), second = addTo(document);
    EXPECT_EQ(selection.region(), second);
    document.undoStack()->undo();
    EXPECT_EQ(selection.region(), first);
    const RegionId third = addTo(document);
    EXPECT_NE(third, second) << "none is given twice";
    EXPECT_EQ(selection.region(), third);
}

TEST(Selection, FindsWhatUndoBringsBack) {
    Document document(tubeWithThreeRegions());
    Selection selection(document);
    const std::vector<Region> regions = document.project().regions;
    document.edit("remove", [&](Project& p) { removeRegion(p, regions[0].id); });
    selection.setRegion(regions[2].id);
    document.undoStack()->undo();
    EXPECT_EQ(selection.region(), regions[0].id);
    document.undoStack()->redo();
    EXPECT_EQ(selection.region(), regions[1].id) << "its neighbour above";
}

TEST(Selection, StaysWithWhatIsReordered) {
    Document document(tubeWithThreeRegions());
    Selection selection(document);
    const RegionId lowest = document.project().regions[0].id;
    selection.setRegion(lowest);
    document.edit("move", [&](Project& p) { moveRegion(p, lowest, 1); });
    EXPECT_EQ(document.project().regions[1].id, lowest);
    EXPECT_EQ(selection.region(), lowest);
    document.undoStack()->undo();
    EXPECT_EQ(document.project().regions[0].id, lowest);
    EXPECT_EQ(selection.region(), lowest);
}

TEST(Selection, HoldsNothingThatIsNotThere) {
    Document document(tubeWithThreeRegions());
    Selection selection(document);
    selection.setRegion(document.newRegionId());
    EXPECT_FALSE(selection.region());
    selection.setPhoto(document.newLayerId());
    EXPECT_FALSE(selection.photo());
}

TEST(Selection, GoesBackToTheWholeOrganWhoseTissueGoes) {
    Document document(makeSample("tube"));
    document.edit("clear", [](Project& p) { p.regions.clear(); });
    addTo(document);
    Selection selection(document);
    selection.setRegion(std::nullopt);
    const RegionId whole = document.newRegionId();
    document.edit("system", [&](Project& p) { setSystem(p, whole, std::make_shared<FuzzySystem>()); });
    EXPECT_EQ(selection.region(), whole);
    document.undoStack()->undo();
    EXPECT_EQ(selection.region(), std::nullopt);
}

TEST(Selection, FollowsWhatIsUndoneInAnotherRegion) {
    Document document(tubeWithThreeRegions());
    Selection selection(document);
    const auto ids = [&] { return document.project().regions; };
    const RegionId first = ids()[0].id, second = ids()[1].id, third = ids()[2].id;
    const auto widen = [&](RegionId region, double rim) {
        document.edit("rim", [=](Project& project) { partOf(project.regions, region).rim = rim; });
    };
    selection.setRegion(first);
    widen(first, 0.01);
    selection.setRegion(third);
    document.undoStack()->undo();
    EXPECT_EQ(selection.region(), first);
    selection.setRegion(std::nullopt);
    document.undoStack()->redo();
    EXPECT_EQ(selection.region(), first);

    document.edit("both", [=](Project& project) {
        for (const RegionId region : {first, second})
            partOf(project.regions, region).rim = 0.03;
    });
    EXPECT_EQ(selection.region(), first) << "an edit selects nothing";
    document.undoStack()->undo();
    EXPECT_EQ(selection.region(), first) << "it is among those that changed";
    selection.setRegion(third);
    document.undoStack()->redo();
    EXPECT_EQ(selection.region(), second) << "the topmost of those that changed";

    widen(third, 0.02);
    EXPECT_EQ(selection.region(), second) << "who edits another one has a reason";
    document.edit("mass", [](Project& project) { project.base.mass = 0.5; });
    document.undoStack()->undo();
    EXPECT_EQ(selection.region(), second) << "no region changed";
}
