#include "core/exchange/project/project_file.h"
#include "core/support/errors.h"
#include "tests/core/exchange/project/stored_fields.h"
#include "tests/support/rounds.h"
#include "tests/support/same_project.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <random>

namespace esm {
namespace {

class ProjectFileExtremes : public testing::Test {
protected:
    void expectComesBack(const Project& project) const {
        EXPECT_THAT(validateProjectFile(m_file), testing::IsEmpty());
        expectSameProject(project, loadProject(m_file));
    }

    TemporaryFolder m_folder;
    std::filesystem::path m_file = m_folder / "organ.esm";
};

TEST_F(ProjectFileExtremes, OfEachFieldComeBack) {
    for (const StoredField& field : storedFields())
        for (std::size_t setting = 0; setting < field.settings.size(); ++setting) {
            SCOPED_TRACE(field.name + ", " + std::to_string(setting));
            Project project = fullProject();
            field.settings[setting](project);
            ASSERT_NO_THROW(saveProject(project, m_file));
            expectComesBack(project);
        }
}

/// Sound numbers may be too large together; then nothing is saved.
TEST_F(ProjectFileExtremes, TogetherComeBackOrAreNotSaved) {
    const std::vector<StoredField> fields = storedFields();
    const int rounds = roundsOf(60, 3000);
    int saved = 0;
    for (int round = 0; round < rounds; ++round) {
        SCOPED_TRACE(seedOf(round));
        std::mt19937 random(seedOf(round));
        Project project = fullProject();
        for (const StoredField& field : fields)
            if (random() % 8 == 0) field.settings[random() % field.settings.size()](project);
        std::filesystem::remove(m_file);
        try {
            saveProject(project, m_file);
        } catch (const FileError&) {
            EXPECT_FALSE(std::filesystem::exists(m_file));
            continue;
        }
        ++saved;
        expectComesBack(project);
    }
    EXPECT_GT(2 * saved, rounds);
}

} // namespace
} // namespace esm
