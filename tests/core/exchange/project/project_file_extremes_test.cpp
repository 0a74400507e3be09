#include "core/exchange/project/project_content.h"
#include "core/exchange/project/project_file.h"
#include "core/support/errors.h"
#include "core/support/json_reader.h"
#include "tests/core/exchange/project/stored_fields.h"
#include "tests/support/rounds.h"
#include "tests/support/same_project.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <random>

namespace esm {
namespace {

std::map<std::string, std::string> entriesOf(const ProjectContent& content) {
    std::map<std::string, std::string> entries;
    for (const ContentPiece& piece : content.pieces) {
        const Bytes bytes = piece.bytes();
        entries[piece.entry].append(bytes.begin(), bytes.end());
    }
    return entries;
}

/// What a project file says, without the file: hundreds of settings need not decode the same photos again.
ReadContent storedAndRead(const Project& project, SharedParts& shared) {
    const ProjectContent content = contentOf(project);
    EXPECT_THAT(manifestProblems(project, content.manifest), testing::IsEmpty());
    const std::string manifest = manifestText(content.manifest);
    std::map<std::string, std::string> entries = entriesOf(content);
    const ContentSource source{[&](const std::string& entry, std::uint64_t, const Progress&) {
                                   const std::string& text = entries.at(entry);
                                   return Bytes(text.begin(), text.end());
                               },
                               [&](const std::string& entry) { return entries[entry]; }};
    return projectFrom(parseJson(manifest.data(), manifest.data() + manifest.size()), source, shared);
}

TEST(ProjectExtremes, OfEachFieldComeBack) {
    const Project full = fullProject();
    SharedParts shared;
    for (const StoredField& field : storedFields())
        for (std::size_t setting = 0; setting < field.settings.size(); ++setting) {
            SCOPED_TRACE(field.name + ", " + std::to_string(setting));
            Project project = full;
            field.settings[setting](project);
            EXPECT_THAT(validate(project), testing::IsEmpty());
            const ReadContent read = storedAndRead(project, shared);
            ASSERT_THAT(read.problems, testing::IsEmpty());
            EXPECT_THAT(read.warnings, testing::IsEmpty());
            expectSameProject(project, read.project);
        }
}

/// Sound numbers may be too large together; then nothing is saved.
TEST(ProjectExtremes, TogetherComeBackOrAreNotSaved) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "organ.esm";
    const std::vector<StoredField> fields = storedFields();
    const int rounds = roundsOf(60, 3000);
    const Project full = fullProject();
    int saved = 0;
    for (int round = 0; round < rounds; ++round) {
        SCOPED_TRACE(seedOf(round));
        std::mt19937 random(seedOf(round));
        Project project = full;
        for (const StoredField& field : fields)
            if (random() % 8 == 0) field.settings[random() % field.settings.size()](project);
        std::filesystem::remove(file);
        try {
            saveProject(project, file);
        } catch (const FileError&) {
            EXPECT_FALSE(std::filesystem::exists(file));
            continue;
        }
        ++saved;
        const OpenedProject opened = openProject(file);
        EXPECT_THAT(opened.warnings, testing::IsEmpty());
        expectSameProject(project, opened.project);
    }
    EXPECT_GT(2 * saved, rounds);
}

} // namespace
} // namespace esm
