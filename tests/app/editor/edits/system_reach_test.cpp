#include "app/editor/edits/system_reach.h"

#include "app/editor/edits/selected_system.h"
#include "core/authoring/regions.h"
#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/samples/samples.h"

#include <gtest/gtest.h>

using namespace esm;

namespace {

/// Two regions with one system, and a third with another.
Project sharingProject() {
    Project project = makeSample("tube");
    project.regions.clear();
    for (const char* preset : {"susilap-g", "susilap-g", "robo-sim"})
        addRegion(project, nextId(project.regions), Eigen::Vector3d::Zero(),
                  std::make_shared<const FuzzySystem>(fuzzyPreset(preset)));
    return project;
}

class SystemReachTest : public testing::Test {
protected:
    SystemReachTest() {
        select(0);
        reach.setQuestion([this](const FuzzySystem& system, const std::vector<const Region*>& users) {
            ++asked;
            EXPECT_EQ(system.name, "susilap-g");
            EXPECT_EQ(users.size(), 2U);
            return answer;
        });
    }
    void select(std::size_t region) { selection.setRegion(document.project().regions.at(region).id); }
    /// As panels do it. Gives whether something was changed.
    bool edit() {
        const auto answered = reach.ask();
        if (!answered) return false;
        FuzzySystem system = *selectedSystem(selection);
        system.rules.pop_back();
        editSelectedSystem(document, selection, system, {"Edit", EditKind::Rules, *answered});
        return true;
    }
    const FuzzySystem& systemOf(std::size_t region) { return *document.project().regions.at(region).system; }

    Document document{sharingProject()};
    Selection selection{document};
    SystemReach reach{document, selection};
    std::optional<Reach> answer = Reach::EveryRegion;
    int asked = 0;
};

} // namespace

TEST_F(SystemReachTest, AsksOnceUntilAnotherRegionIsSelected) {
    EXPECT_TRUE(reach.wouldAsk());
    EXPECT_TRUE(edit() && edit());
    EXPECT_EQ(asked, 1);
    EXPECT_EQ(systemOf(0), systemOf(1));
    EXPECT_EQ(reach.decided(), Reach::EveryRegion);
    select(1);
    EXPECT_TRUE(reach.wouldAsk());
    EXPECT_TRUE(edit());
    EXPECT_EQ(asked, 2);
}

TEST_F(SystemReachTest, AsksNothingOfWhatOneRegionAloneUses) {
    select(2);
    EXPECT_FALSE(reach.wouldAsk());
    EXPECT_TRUE(edit());
    EXPECT_EQ(asked, 0);
}

TEST_F(SystemReachTest, ChangesNothingWhereTheUserWouldRatherNot) {
    answer.reset();
    const Project before = document.project();
    EXPECT_FALSE(edit());
    EXPECT_EQ(document.project(), before);
    EXPECT_EQ(document.undoStack()->count(), 0);
    EXPECT_FALSE(edit());
    EXPECT_EQ(asked, 2) << "the next edit asks again";
}

TEST_F(SystemReachTest, MakesACopyInOneStepAndAsksAgainWhereThatIsUndone) {
    answer = Reach::CopyForOne;
    const Project before = document.project();
    EXPECT_TRUE(edit() && edit());
    EXPECT_EQ(asked, 1) << "the copy is this region's alone";
    EXPECT_EQ(systemOf(0).name, "susilap-g, own");
    EXPECT_EQ(systemOf(1), *before.regions[1].system);
    EXPECT_EQ(document.undoStack()->count(), 1);
    document.undoStack()->undo();
    EXPECT_EQ(document.project(), before);
    EXPECT_TRUE(reach.wouldAsk());
}

TEST_F(SystemReachTest, AsksAgainOfAnotherSystem) {
    EXPECT_TRUE(edit());
    document.edit("System", [&](Project& project) {
        for (Region& region : project.regions)
            setSystem(project, region.id, std::make_shared<const FuzzySystem>(fuzzyPreset("susilap-g")));
    });
    EXPECT_TRUE(reach.wouldAsk());
}
