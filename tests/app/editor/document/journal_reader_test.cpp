#include "app/editor/document/journal_reader.h"
#include "core/samples/samples.h"
#include "core/support/errors.h"
#include "tests/app/editor/document/journal_fixture.h"
#include "tests/support/rounds.h"
#include "tests/support/steady_progress.h"

using namespace esm;

namespace {

class JournalReaderTest : public JournalTest {
protected:
    JournalReaderTest() : journal(document, selection, recovery) {}

    double massIn(const BroughtBack& back) const {
        const DocumentState& state = back.state;
        return (state.index == 0 ? *state.base
                                 : *state.steps[static_cast<std::size_t>(state.index) - 1].after)
            .base.mass;
    }
    /// Another mesh, of which the step's blob is the only one.
    void moveVertex() {
        document.edit("move", [](Project& project) {
            auto mesh = std::make_shared<TriangleMesh>(*project.mesh);
            mesh->vertices[0].x() += 1e-6;
            project.mesh = mesh;
        });
    }
    static std::set<std::filesystem::path> blobsIn(const std::filesystem::path& journal) {
        std::set<std::filesystem::path> blobs;
        for (const auto& entry : std::filesystem::directory_iterator(journal / "blobs"))
            blobs.insert(entry.path().filename());
        return blobs;
    }

    Journal journal;
};

} // namespace

TEST_F(JournalReaderTest, LeavesOutALineThatWasNotWrittenToItsEnd) {
    setMass(0.5);
    setMass(0.75);
    journal.finish();
    const LeftBehind left = leftByAKill();
    const std::string text = recordsText(left.place);
    setMass(1.5);
    journal.finish();
    const std::string more = recordsText(journals()[0]);
    ASSERT_EQ(more.compare(0, text.size(), text), 0) << "records are only added";
    for (std::size_t size = text.size(); size < more.size(); size += 37) {
        overwriteRecords(left.place, more.substr(0, size));
        const BroughtBack back = bringBack(left);
        EXPECT_EQ(massIn(back), 0.75);
        EXPECT_EQ(back.state.steps.size(), 2U);
        EXPECT_TRUE(back.warnings.empty());
    }
    overwriteRecords(left.place, more);
    EXPECT_EQ(massIn(bringBack(left)), 1.5);
}

TEST_F(JournalReaderTest, TellsOfRecordsThatAreDamaged) {
    setMass(0.5);
    journal.finish();
    const std::size_t place = recordsText(journals()[0]).size() + 20;
    setMass(0.75);
    setMass(1.5);
    const LeftBehind left = leftByAKill(journal);
    std::string text = recordsText(left.place);
    text[place] = static_cast<char>(text[place] ^ 4);
    overwriteRecords(left.place, text);
    const BroughtBack back = bringBack(left);
    EXPECT_EQ(massIn(back), 0.5);
    ASSERT_EQ(back.warnings.size(), 1U);
}

TEST_F(JournalReaderTest, GoesBackToTheLatestStateWithAllItsBlobs) {
    setMass(0.5);
    journal.finish();
    const auto before = blobsIn(journals()[0]);
    moveVertex();
    setMass(0.75);
    const LeftBehind left = leftByAKill(journal);
    std::filesystem::path added;
    for (const auto& blob : blobsIn(left.place))
        if (!before.contains(blob)) added = left.place / "blobs" / blob;
    for (const bool isThere : {true, false}) {
        if (isThere)
            std::fstream(added, std::ios::in | std::ios::out | std::ios::binary).seekp(100).put('\x7f');
        else
            std::filesystem::remove(added);
        const BroughtBack back = bringBack(left);
        EXPECT_EQ(massIn(back), 0.5);
        EXPECT_EQ(back.state.steps.size(), 1U);
        EXPECT_EQ(back.warnings.size(), 1U);
    }
}

TEST_F(JournalReaderTest, KeepsTheLatestStateWhereAnEarlierOneCannotBeRead) {
    moveVertex();
    journal.finish();
    const auto before = blobsIn(journals()[0]);
    moveVertex();
    journal.finish();
    std::filesystem::path added;
    for (const auto& blob : blobsIn(journals()[0]))
        if (!before.contains(blob)) added = blob;
    document.edit("another organ", [](Project& project) { project = projectToEdit(); });
    setMass(0.5);
    setMass(0.75);
    const LeftBehind left = leftByAKill(journal);
    std::filesystem::remove(left.place / "blobs" / added);
    const BroughtBack back = bringBack(left);
    EXPECT_EQ(massIn(back), 0.75);
    EXPECT_EQ(back.state.steps.size(), 2U) << "those after the step that cannot be read";
    EXPECT_EQ(back.warnings.size(), 1U);
}

TEST_F(JournalReaderTest, ReadsWhatIsDamagedOnceAndMayBeStopped) {
    setMass(0.5);
    journal.finish();
    const auto before = blobsIn(journals()[0]);
    moveVertex();
    for (int i = 0; i < 300; ++i)
        setMass(1 + i);
    const LeftBehind left = leftByAKill(journal);
    for (const auto& blob : blobsIn(left.place))
        if (!before.contains(blob)) std::filesystem::remove(left.place / "blobs" / blob);
    int reports = 0;
    const auto counted = [&](double) { return ++reports > 0; };
    EXPECT_EQ(massIn(bringBack(left, counted)), 0.5);
    EXPECT_GT(reports, 100) << "one of each state that names the blob";
    const int stopAt = reports / 2;
    reports = 0;
    EXPECT_THROW(bringBack(left, [&](double) { return ++reports < stopAt; }), Cancelled);
    EXPECT_EQ(reports, stopAt);
}

TEST_F(JournalReaderTest, SharesWhatStepsHaveInCommon) {
    setMass(0.5);
    moveVertex();
    document.edit("rename", [](Project& project) { project.name = "other"; });
    const DocumentState state = bringBack(leftByAKill(journal)).state;
    EXPECT_FALSE(difference(*state.base, *state.steps[0].after).mesh);
    EXPECT_TRUE(difference(*state.steps[0].after, *state.steps[1].after).mesh);
    const Change renamed = difference(*state.steps[1].after, *state.steps[2].after);
    EXPECT_TRUE(renamed.name);
    EXPECT_FALSE(renamed.mesh || renamed.regions || renamed.layers || renamed.texture);
}

TEST_F(JournalReaderTest, TellsWhereNothingCanBeRead) {
    setMass(0.5);
    LeftBehind left = leftByAKill(journal);
    const std::string text = recordsText(left.place);
    for (const std::string& other : {std::string(), std::string("nonsense\n"), text.substr(0, 100)}) {
        overwriteRecords(left.place, other);
        EXPECT_THROW(bringBack(left), FileError);
    }
    overwriteRecords(left.place, text);
    std::filesystem::remove_all(left.place / "blobs");
    EXPECT_THROW(bringBack(left), FileError);
    const auto found = leftBehindIn(left.place.parent_path());
    ASSERT_EQ(found.size(), 1U) << "it can be discarded";
    discard(found[0]);
    EXPECT_FALSE(std::filesystem::exists(left.place));
}

TEST_F(JournalReaderTest, SurvivesFilesOfAnyKind) {
    RandomEdits edits(document, selection, seedOf(0));
    setMass(0.5);
    for (int i = 0; i < 30; ++i)
        edits.next();
    const LeftBehind whole = leftByAKill(journal);
    for (int round = 0; round < roundsOf(40, 2000); ++round) {
        SCOPED_TRACE(seedOf(round));
        std::mt19937 random(seedOf(round));
        const LeftBehind left = leftByAKill();
        const auto blobs = blobsIn(left.place);
        auto file = left.place / "records";
        if (random() % 2 == 0) {
            auto blob = blobs.begin();
            std::advance(blob, static_cast<std::ptrdiff_t>(random() % blobs.size()));
            file = left.place / "blobs" / *blob;
        }
        const auto size = std::filesystem::file_size(file);
        for (int times = 0; times < 3; ++times)
            std::fstream(file, std::ios::in | std::ios::out | std::ios::binary)
                .seekp(static_cast<std::streamoff>(random() % size))
                .put(static_cast<char>(random() % 256));
        if (random() % 4 == 0) std::filesystem::resize_file(file, random() % size);
        try {
            const BroughtBack back = bringBack(left);
            Document again(makeSample("tube"));
            again.restore(back.state);
            again.undoStack()->setIndex(0);
            again.undoStack()->setIndex(again.undoStack()->count());
        } catch (const FileError& error) {
            EXPECT_NE(std::string(error.what()), "");
        }
        std::filesystem::remove_all(left.place);
    }
}

TEST_F(JournalReaderTest, TellsHowFarItIsAndLeavesTheJournalWhereItIsStopped) {
    setMass(0.5);
    for (int i = 0; i < 10; ++i)
        moveVertex();
    journal.finish();
    const LeftBehind left = leftByAKill();
    test::expectGoodProgress([&](const Progress& progress) { bringBack(left, progress); });
    EXPECT_EQ(bringBack(left).state.steps.size(), 11U);
}
