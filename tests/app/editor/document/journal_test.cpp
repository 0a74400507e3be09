#include "app/editor/document/journal.h"
#include "core/exchange/project/project_file.h"
#include "core/samples/samples.h"
#include "tests/app/editor/document/journal_fixture.h"
#include "tests/support/eventually.h"
#include "tests/support/rounds.h"

#include <QApplication>

#include <future>
#include <map>
#include <mutex>

using namespace esm;

TEST_F(JournalTest, WritesNothingBeforeThereIsSomethingToLose) {
    Journal journal(document, selection, recovery);
    journal.setWorkspace("texture");
    journal.finish();
    EXPECT_FALSE(std::filesystem::exists(recovery));
    setMass(0.5);
    journal.finish();
    EXPECT_EQ(journals().size(), 1U);
}

TEST_F(JournalTest, BeginsWithAnOrganThatLiesInNoFile) {
    Journal journal(document, selection, recovery);
    document.replace(makeSample("uterus"), std::nullopt, Origin::Unsaved);
    const BroughtBack back = bringBack(leftByAKill(journal));
    EXPECT_EQ(back.state.base->name, document.project().name);
    EXPECT_TRUE(back.state.steps.empty());
    EXPECT_EQ(back.state.file.clean, -1);
}

TEST_F(JournalTest, BringsBackTheDocumentAsItIs) {
    for (int round = 0; round < roundsOf(5, 100); ++round) {
        SCOPED_TRACE(seedOf(round));
        std::filesystem::remove_all(recovery);
        document.replace(projectToEdit(), std::nullopt, Origin::Unsaved);
        JournalHabits habits;
        habits.bounds.leastGrowth = round % 2 == 0 ? 32 << 20 : 1 << 10;
        Journal journal(document, selection, recovery, nullptr, habits);
        RandomEdits edits(document, selection, seedOf(round));
        DocumentDigests digests;
        for (int i = 0; i < 60; ++i) {
            edits.next();
            if (i % 20 != 19) continue;
            QApplication::processEvents();
            const BroughtBack back = bringBack(leftByAKill(journal));
            EXPECT_TRUE(back.warnings.empty());
            EXPECT_EQ(digests.of(back.state), digests.of(document.state()));
            Document again(makeSample("tube"));
            again.restore(back.state);
            EXPECT_EQ(digests.of(again.state()), digests.of(document.state()));
            EXPECT_TRUE(again.isModified());
        }
    }
}

TEST_F(JournalTest, KeepsAFullUndoList) {
    Journal journal(document, selection, recovery);
    for (int i = 0; i < Document::mostSteps + 7; ++i)
        setMass(1 + i);
    document.undoStack()->setIndex(Document::mostSteps - 3);
    setMass(0.5);
    document.undoStack()->undo();
    DocumentDigests digests;
    EXPECT_EQ(digests.of(bringBack(leftByAKill(journal)).state), digests.of(document.state()));
}

TEST_F(JournalTest, WritesADragOnceWhileItIsOnItsWay) {
    std::mutex writing;
    JournalHabits habits;
    habits.begins = [&](std::uint64_t) { const std::lock_guard wait(writing); };
    Journal journal(document, selection, recovery, nullptr, habits);
    setMass(0.5);
    journal.finish();
    const std::size_t before = recordsText(journals()[0]).size();
    setMass(1, EditKind::BaseTissue);
    journal.finish();
    const std::size_t step = recordsText(journals()[0]).size() - before;
    {
        const std::lock_guard disk(writing);
        for (int i = 0; i < 1000; ++i)
            setMass(2 + i, EditKind::BaseTissue);
    }
    journal.finish();
    // One more may have been begun before the disk stood still.
    EXPECT_LE(recordsText(journals()[0]).size() - before, 4 * step);
    EXPECT_EQ(bringBack(leftByAKill(journal)).state.steps.back().after->base.mass, 1001);
}

TEST_F(JournalTest, WritesArraysOnce) {
    Journal journal(document, selection, recovery);
    setMass(0.5);
    journal.finish();
    const auto blobs = [&] {
        std::map<std::filesystem::path, std::filesystem::file_time_type> found;
        for (const auto& entry : std::filesystem::directory_iterator(journals()[0] / "blobs"))
            found[entry.path()] = entry.last_write_time();
        return found;
    };
    const auto before = blobs();
    const auto records = recordsText(journals()[0]).size();
    setMass(0.75);
    journal.finish();
    EXPECT_EQ(blobs(), before);
    EXPECT_LT(recordsText(journals()[0]).size() - records, 1000U) << "of a mass, not of the whole organ";
}

TEST_F(JournalTest, StaysWithinItsBounds) {
    JournalHabits habits;
    habits.bounds.leastGrowth = 20'000;
    Journal journal(document, selection, recovery, nullptr, habits);
    setMass(0.5);
    journal.finish();
    const std::uint64_t first = recordsText(journals()[0]).size();
    std::uint64_t largest = 0;
    for (int i = 0; i < 2000; ++i) {
        document.undoStack()->undo();
        setMass(1 + i);
        if (i % 50 != 0) continue;
        journal.finish();
        QApplication::processEvents();
        journal.finish();
        largest = std::max<std::uint64_t>(largest, recordsText(journals()[0]).size());
    }
    EXPECT_LT(largest, 4 * first + 60'000) << "of 2000 edits with more than 300 bytes each";
    DocumentDigests digests;
    EXPECT_EQ(digests.of(bringBack(leftByAKill(journal)).state), digests.of(document.state()));
}

TEST_F(JournalTest, LeavesOutTheFirstStepsWhereAllWouldBeTooLarge) {
    JournalHabits habits;
    habits.bounds.leastGrowth = 1000;
    habits.bounds.mostRecords = 20'000;
    Journal journal(document, selection, recovery, nullptr, habits);
    for (int i = 0; i < Document::mostSteps; ++i)
        setMass(1 + i);
    const auto writtenAnew = [&] {
        journal.finish();
        QApplication::processEvents();
        return bringBack(leftByAKill(journal));
    };
    const BroughtBack back = writtenAnew();
    EXPECT_LT(back.state.steps.size(), static_cast<std::size_t>(Document::mostSteps));
    EXPECT_GT(back.state.steps.size(), 10U);
    EXPECT_EQ(back.state.steps.back().after->base.mass, Document::mostSteps);
    EXPECT_LT(recordsText(journals()[0]).size(), 60'000U) << "of 500 steps with more than 300 bytes each";

    document.undoStack()->setIndex(3);
    const DocumentState undone = writtenAnew().state;
    ASSERT_EQ(undone.index, 0);
    EXPECT_EQ(undone.base->base.mass, 3);
    EXPECT_EQ(undone.steps.back().after->base.mass, Document::mostSteps) << "what can be redone stays";
    setMass(0.5);
    EXPECT_EQ(writtenAnew().state.steps.back().after->base.mass, 0.5);
}

TEST_F(JournalTest, BringsBackWhatTheWindowShowed) {
    Journal journal(document, selection, recovery);
    setMass(0.5);
    const LayerId layer = document.project().layers.at(0).id;
    selection.setPhoto(layer);
    const RegionId region = document.project().regions.back().id;
    selection.setRegion(region);
    journal.setWorkspace("texture");
    const BroughtBack back = bringBack(leftByAKill(journal));
    EXPECT_EQ(back.view, (JournalView{"texture", region, layer}));
}

TEST_F(JournalTest, IsNotOfferedOnceItsWorkIsSaved) {
    const auto file = folder / "tube.esm";
    Journal journal(document, selection, recovery);
    setMass(0.5);
    saveProject(document.project(), file);
    document.setFileVersion(versionOf(file));
    document.markSaved(file, document.project());
    LeftBehind saved = leftByAKill(journal);
    EXPECT_TRUE(leftBehindIn(saved.place.parent_path()).empty());
    EXPECT_TRUE(std::filesystem::is_empty(saved.place.parent_path())) << "nor does it stay";

    setMass(0.75);
    LeftBehind edited = leftByAKill(journal);
    const auto found = leftBehindIn(edited.place.parent_path());
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].former.title, "tube.esm");
    const BroughtBack back = bringBack(found[0]);
    EXPECT_EQ(back.state.steps.size(), 2U) << "the undo list outlives saving";
    EXPECT_EQ(back.state.file.path, file);
    EXPECT_EQ(back.state.file.clean, 1);
    Document again(makeSample("tube"));
    again.restore(back.state);
    EXPECT_TRUE(again.isModified());
    again.undoStack()->undo();
    EXPECT_FALSE(again.isModified()) << "that lies in the file";
}

TEST_F(JournalTest, LetsGoOfAFileThatHasChanged) {
    const auto file = folder / "tube.esm";
    Journal journal(document, selection, recovery);
    saveProject(document.project(), file);
    document.setFileVersion(versionOf(file));
    document.markSaved(file, document.project());
    setMass(0.75);
    const LeftBehind left = leftByAKill(journal);
    saveProject(makeSample("uterus"), file);
    const BroughtBack back = bringBack(left);
    EXPECT_FALSE(back.state.file.path);
    EXPECT_EQ(back.state.file.clean, -1);
    EXPECT_EQ(back.state.file.former.path, file);
    EXPECT_EQ(back.state.file.former.title, "tube.esm");
}

TEST_F(JournalTest, GoesAtTheEnd) {
    {
        Journal journal(document, selection, recovery);
        setMass(0.5);
        journal.finish();
        EXPECT_EQ(journals().size(), 1U);
    }
    EXPECT_TRUE(std::filesystem::is_empty(recovery));
}

TEST_F(JournalTest, GoesWithAProjectThatIsLeft) {
    Journal journal(document, selection, recovery);
    setMass(0.5);
    journal.finish();
    document.replace(makeSample("uterus"), std::nullopt);
    journal.finish();
    EXPECT_TRUE(std::filesystem::is_empty(recovery));
}

TEST_F(JournalTest, IsNotOfferedWhileItsProgramRuns) {
    Journal running(document, selection, recovery);
    setMass(0.5);
    running.finish();
    Document other(makeSample("tube"));
    Selection none(other);
    EXPECT_TRUE(Journal(other, none, recovery).leftBehind().empty());
    EXPECT_EQ(journals().size(), 1U) << "and stays";
}

TEST_F(JournalTest, IsOfferedToOneProgramAtATime) {
    std::filesystem::create_directories(recovery);
    saveProject(document.project(), recovery / "left.esm");
    auto found = leftBehindIn(recovery);
    EXPECT_EQ(found.size(), 1U);
    EXPECT_TRUE(leftBehindIn(recovery).empty());
    found.clear();
    EXPECT_EQ(leftBehindIn(recovery).size(), 1U);
}

TEST_F(JournalTest, TakesOverWhatWasLeftBehind) {
    std::filesystem::create_directories(recovery);
    const auto left = recovery / "left.esm";
    saveProject(document.project(), left);
    std::ofstream(recovery / "left.title") << "my liver.esm";
    {
        std::promise<void> disk;
        JournalHabits habits;
        habits.begins = [stands = disk.get_future().share()](std::uint64_t) { stands.wait(); };
        Journal journal(document, selection, recovery, nullptr, habits);
        auto found = journal.leftBehind();
        ASSERT_EQ(found.size(), 1U);
        EXPECT_EQ(found[0].former.title, "my liver.esm");
        document.restore(bringBack(found[0]).state);
        journal.takeOver(std::move(found[0]));
        EXPECT_TRUE(std::filesystem::exists(left)) << "until this journal has all of it";
        disk.set_value();
        journal.finish();
        EXPECT_FALSE(std::filesystem::exists(left));
        EXPECT_EQ(journals().size(), 1U);
        EXPECT_EQ(bringBack(leftByAKill(journal)).state.file.former.title, "my liver.esm");
    }
    EXPECT_TRUE(std::filesystem::is_empty(recovery));
}

TEST_F(JournalTest, NeverLetsTheWindowWaitForADisk) {
    std::promise<void> disk;
    const std::shared_future<void> stands = disk.get_future().share();
    JournalHabits habits;
    habits.begins = [stands](std::uint64_t) { stands.wait(); };
    Journal journal(document, selection, recovery, nullptr, habits);
    std::promise<void> returned;
    auto wasInTime = std::async(std::launch::async, [&disk, done = returned.get_future()] {
        const bool inTime = done.wait_for(std::chrono::milliseconds(patience)) == std::future_status::ready;
        disk.set_value();
        return inTime;
    });
    setMass(0.5);
    document.undoStack()->undo();
    document.undoStack()->redo();
    selection.setRegion(std::nullopt);
    document.markSaved(folder / "tube.esm", document.project());
    document.replace(makeSample("uterus"), std::nullopt, Origin::Unsaved);
    returned.set_value();
    EXPECT_TRUE(wasInTime.get());
    EXPECT_EQ(bringBack(leftByAKill(journal)).state.base->name, document.project().name);
}
