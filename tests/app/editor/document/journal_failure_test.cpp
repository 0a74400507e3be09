#include "app/editor/document/journal.h"
#include "core/exchange/project/project_file.h"
#include "core/samples/samples.h"
#include "tests/app/editor/document/journal_fixture.h"
#include "tests/support/eventually.h"

#include <QApplication>
#include <QSemaphore>

#include <atomic>

using namespace esm;

namespace {

/// What a journal does that cannot be written for a while.
class JournalFailureTest : public JournalTest {
protected:
    JournalFailureTest() : journal(document, selection, recovery, nullptr, retryingSoon()) {
        QObject::connect(&journal, &Journal::failed, [&](const QString& reason) { failures << reason; });
    }
    static JournalHabits retryingSoon() {
        JournalHabits habits;
        habits.retryPause = std::chrono::milliseconds(20);
        return habits;
    }

    Journal journal;
    QStringList failures;
};

} // namespace

TEST_F(JournalFailureTest, KeepsWhatWasLeftBehindUntilAllOfItCanBeWritten) {
    std::filesystem::create_directories(recovery);
    saveProject(document.project(), recovery / "left.esm");
    auto found = journal.leftBehind();
    ASSERT_EQ(found.size(), 1U);
    const DocumentState left = bringBack(found[0]).state;
    // Before anything is open in it that could still be written to.
    std::filesystem::rename(recovery, folder / "away");
    std::ofstream(recovery) << "no folder";
    document.restore(left);
    journal.takeOver(std::move(found[0]));
    setMass(0.5);
    ESM_EVENTUALLY(!failures.isEmpty());
    std::filesystem::remove(recovery);
    std::filesystem::rename(folder / "away", recovery);
    EXPECT_TRUE(std::filesystem::exists(recovery / "left.esm"));
    ESM_EVENTUALLY(!std::filesystem::exists(recovery / "left.esm"));
    EXPECT_EQ(bringBack(leftByAKill(journal)).state.steps.back().after->base.mass, 0.5);
}

TEST_F(JournalFailureTest, TellsOnceThatNothingCanBeWrittenAndThatItCanAgain) {
    QStringList messages;
    QObject::connect(&journal, &Journal::message, [&](const QString& text) { messages << text; });
    std::ofstream(recovery) << "no folder";
    setMass(0.5);
    ESM_EVENTUALLY(!failures.isEmpty());
    EXPECT_TRUE(failures[0].contains("recovery")) << failures[0].toStdString();
    setMass(0.75);
    QTest::qWait(0);
    EXPECT_EQ(failures.size(), 1);
    EXPECT_TRUE(messages.isEmpty());
    std::filesystem::remove(recovery);
    ESM_EVENTUALLY(failures.size() == 2);
    EXPECT_EQ(failures[1], "");
    EXPECT_EQ(messages.size(), 1);
    EXPECT_EQ(bringBack(leftByAKill(journal)).state.steps.back().after->base.mass, 0.75);
    Document other(makeSample("tube"));
    Selection none(other);
    EXPECT_TRUE(Journal(other, none, recovery).leftBehind().empty()) << "it is in use";
}

TEST_F(JournalFailureTest, WritesAllAnewAfterItCouldNot) {
    setMass(0.5);
    journal.finish();
    // As when a disk is taken away and another one comes.
    std::filesystem::rename(recovery, folder / "away");
    std::ofstream(recovery) << "no folder";
    document.edit("move", [](Project& project) {
        auto mesh = std::make_shared<TriangleMesh>(*project.mesh);
        mesh->vertices[0].x() += 1e-6;
        project.mesh = mesh;
    });
    ESM_EVENTUALLY(!failures.isEmpty());
    std::filesystem::remove(recovery);
    ESM_EVENTUALLY(failures.size() == 2);
    DocumentDigests digests;
    EXPECT_EQ(digests.of(bringBack(leftByAKill(journal)).state), digests.of(document.state()));
}

TEST_F(JournalFailureTest, TellsNoFailureWhereNothingIsUnsaved) {
    std::ofstream(recovery) << "no folder";
    setMass(0.5);
    document.markSaved(folder / "tube.esm", document.project());
    journal.finish();
    QApplication::processEvents();
    EXPECT_TRUE(failures.isEmpty());
    std::filesystem::remove(recovery);
    setMass(0.75);
    EXPECT_EQ(bringBack(leftByAKill(journal)).state.steps.size(), 2U) << "the next edit is kept";
}

TEST_F(JournalFailureTest, HasNothingToTellOnceTheWorkIsSaved) {
    std::ofstream(recovery) << "no folder";
    setMass(0.5);
    ESM_EVENTUALLY(failures.size() == 1);
    document.markSaved(folder / "tube.esm", document.project());
    ESM_EVENTUALLY(failures.size() == 2);
    EXPECT_EQ(failures[1], "");
}

TEST_F(JournalFailureTest, HasNothingToTellOnceTheWorkIsSavedWhileItTriesAgain) {
    std::ofstream(recovery) << "no folder";
    std::atomic<int> tries = 0;
    QSemaphore mayFail;
    JournalHabits slow = retryingSoon();
    slow.begins = [&](std::uint64_t) {
        if (++tries == 2) mayFail.tryAcquire(1, patience);
    };
    Journal other(document, selection, recovery, nullptr, slow);
    QStringList told;
    QObject::connect(&other, &Journal::failed, [&](const QString& reason) { told << reason; });
    setMass(0.5);
    ESM_EVENTUALLY(tries == 2);
    EXPECT_EQ(told.size(), 1);
    document.markSaved(folder / "tube.esm", document.project());
    mayFail.release();
    ESM_EVENTUALLY(told.size() == 2);
    EXPECT_EQ(told[1], "");
}

TEST_F(JournalFailureTest, TellsNothingOnceItIsGone) {
    std::ofstream(recovery) << "no folder";
    auto other = std::make_unique<Journal>(document, selection, recovery);
    int told = 0;
    QObject::connect(other.get(), &Journal::failed, [&] { ++told; });
    setMass(0.5);
    other->finish();
    other.reset();
    QApplication::processEvents();
    EXPECT_EQ(told, 0);
}
