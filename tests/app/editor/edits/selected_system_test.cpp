#include "app/editor/edits/selected_system.h"

#include "core/authoring/regions.h"
#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/samples/samples.h"

#include <gmock/gmock.h>

using namespace esm;

namespace {

class SelectedSystem : public testing::Test {
protected:
    SelectedSystem() {
        Project project = makeSample("tube");
        project.regions.clear();
        addRegion(project, nextId(project.regions), Eigen::Vector3d::Zero(),
                  std::make_shared<const FuzzySystem>(fuzzyPreset("susilap-g")));
        document.replace(std::move(project), std::nullopt);
        selection.setRegion(document.project().regions[0].id);
    }

    Document document{makeSample("tube")};
    Selection selection{document};
};

} // namespace

TEST_F(SelectedSystem, IsEditedInOneStepForADragAndNoneWhereNothingChanges) {
    const FuzzySystem before = *selectedSystem(selection);
    const auto moveTo = [&](double corner) {
        FuzzySystem system = *selectedSystem(selection);
        system.inputs[0].terms[1].set.b = corner;
        editSelectedSystem(document, selection, system, {"Move corner", EditKind::TermShape});
    };
    moveTo(before.inputs[0].terms[1].set.b);
    EXPECT_EQ(document.undoStack()->count(), 0);
    moveTo(2.6);
    moveTo(2.7);
    EXPECT_EQ(document.undoStack()->count(), 1);
    document.undoStack()->undo();
    EXPECT_EQ(*selectedSystem(selection), before);
    EXPECT_TRUE(isFuzzyPreset(*selectedSystem(selection)));
}

TEST_F(SelectedSystem, IsNoneWhereNoRegionIsSelected) {
    selection.setRegion(std::nullopt);
    EXPECT_EQ(selectedSystem(selection), nullptr);
}

TEST(ScopeOf, KeepsTheNamesOfSystemsThatShip) {
    EXPECT_EQ(scopeOf(Reach::CopyForOne).reach, Reach::CopyForOne);
    EXPECT_THAT(scopeOf(Reach::CopyForOne).takenNames, testing::ElementsAreArray(fuzzyPresetNames()));
}
