#include "core/exchange/journal/journal_records.h"
#include "core/support/errors.h"

#include <gmock/gmock.h>

using namespace esm;

namespace {

const std::string& threeLines() {
    static const std::string text = recordLine(moveRecord(1, 2)) + recordLine(moveRecord(2, 2)) +
                                    recordLine(viewRecord({"texture", RegionId{3}, std::nullopt}));
    return text;
}

} // namespace

TEST(JournalRecords, AreReadAsTheyWereWritten) {
    const JournalRecords read = recordsIn(threeLines());
    EXPECT_TRUE(read.areWhole);
    ASSERT_EQ(read.records.size(), 3U);
    EXPECT_EQ(read.records[0], moveRecord(1, 2));
    EXPECT_EQ(read.records[2], viewRecord({"texture", RegionId{3}, std::nullopt}));
}

TEST(JournalRecords, EndBeforeALineThatWasNotWrittenToItsEnd) {
    const std::string& text = threeLines();
    const std::size_t lastLine = text.rfind('\n', text.size() - 2) + 1;
    for (std::size_t size = lastLine; size < text.size(); ++size) {
        const JournalRecords read = recordsIn(std::string_view(text).substr(0, size));
        EXPECT_EQ(read.records.size(), 2U) << size;
        EXPECT_TRUE(read.areWhole) << size;
    }
}

TEST(JournalRecords, EndBeforeALineWithAnyByteChanged) {
    const std::size_t second = threeLines().find('\n') + 1, third = threeLines().find('\n', second) + 1;
    for (std::size_t place = second; place < third; ++place) {
        std::string text = threeLines();
        text[place] = static_cast<char>(text[place] ^ 1);
        const JournalRecords read = recordsIn(text);
        EXPECT_EQ(read.records.size(), 1U) << place;
        EXPECT_FALSE(read.areWhole) << place;
    }
}

TEST(JournalRecords, HoldAnyText) {
    JournalFile file;
    file.path = "/tmp/line\nbreak and \"quotes\" ü.esm";
    const JournalRecords read = recordsIn(recordLine(fileRecord(file)));
    ASSERT_EQ(read.records.size(), 1U);
    EXPECT_EQ(read.records[0]["path"], file.path);
}

TEST(JournalRecords, SayOnlyWhatHasChanged) {
    Project project;
    project.regions.resize(2);
    numberParts(project);
    const StoredState before =
        storedState(project, {{"name", "a"}, {"base", 1}, {"atlas", 5}}, {{"mesh", {"m"}}});
    const StoredState after = storedState(project, {{"name", "b"}, {"base", 1}}, {{"mesh", {"m"}}});
    EXPECT_EQ(changeOf(before, after),
              (nlohmann::ordered_json{{"members", {{"name", "b"}}}, {"gone", {"atlas"}}}));
}

TEST(JournalRecords, KnowTheIdentitiesOfParts) {
    Project project;
    project.regions.resize(2);
    project.regions[0].id = {7};
    project.regions[1].id = {3};
    const StoredState state = storedState(project, nlohmann::ordered_json::object(), {});
    Project read;
    read.regions.resize(2);
    giveIdentities(read, state);
    EXPECT_EQ(read.regions[0].id, RegionId{7});
    EXPECT_EQ(read.regions[1].id, RegionId{3});
    read.regions.resize(3);
    EXPECT_THROW(giveIdentities(read, state), InvalidModel) << "a region without one";
    project.regions[1].id = {7};
    read.regions.resize(2);
    EXPECT_THROW(giveIdentities(read, storedState(project, nlohmann::ordered_json::object(), {})),
                 InvalidModel)
        << "two regions with the same";
}
