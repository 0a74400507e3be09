#include "core/support/new_folder.h"

#include "core/support/errors.h"
#include "core/support/scratch_folder.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/with_variable.h"

#include <gmock/gmock.h>

#include <fstream>
#include <sys/stat.h>

namespace esm {
namespace {

std::vector<std::string> namesIn(const std::filesystem::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        names.push_back(entry.path().filename().string());
    return names;
}

TEST(NewFolder, ComesToBeWholeOrNotAtAll) {
    const TemporaryFolder folder;
    {
        NewFolder made(folder / "organ");
        std::ofstream(made.unfinished() / "file") << "all";
        EXPECT_FALSE(std::filesystem::exists(folder / "organ"));
    }
    EXPECT_THAT(namesIn(folder.path()), testing::IsEmpty());
    NewFolder made(folder / "organ/");
    std::ofstream(made.unfinished() / "file") << "all";
    made.commit();
    EXPECT_THAT(namesIn(folder.path()), testing::ElementsAre("organ"));
    EXPECT_THAT(namesIn(folder / "organ"), testing::ElementsAre("file"));
}

TEST(NewFolder, MayBeReadByWhoeverMayReadOthers) {
    const TemporaryFolder folder;
    const mode_t mask = ::umask(027);
    NewFolder made(folder / "organ");
    made.commit();
    ::umask(mask);
    struct stat status {};
    ASSERT_EQ(::stat((folder / "organ").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777U, 0750U);
}

TEST(NewFolder, LeavesWhatHasComeInItsPlace) {
    const TemporaryFolder folder;
    NewFolder made(folder / "organ");
    std::filesystem::create_directory(folder / "organ");
    std::ofstream(folder / "organ" / "mine") << "mine";
    EXPECT_THROW(made.commit(), FileError);
    EXPECT_THAT(namesIn(folder / "organ"), testing::ElementsAre("mine"));
    EXPECT_THROW(requireNewFolder(folder / "organ"), FileError);
    EXPECT_THROW(requireNewFolder(folder / "organ" / "mine"), FileError);
    EXPECT_NO_THROW(requireNewFolder(folder / "other"));
}

TEST(NewFolder, TakesAnotherNameWhereItsOwnIsTaken) {
    const TemporaryFolder folder;
    NewFolder first(folder / "organ"), second(folder / "organ");
    EXPECT_NE(first.unfinished(), second.unfinished());
}

TEST(NewFolder, SaysThatANameIsTooLong) {
    const TemporaryFolder folder;
    try {
        const NewFolder made(folder / std::string(255, 'x'));
        FAIL();
    } catch (const FileError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("choose a shorter name"));
    }
}

TEST(ScratchFolder, NamesWhatToDoWithoutRoom) {
    const TemporaryFolder folder;
    const test::WithVariable named("TMPDIR", folder / "none");
    try {
        const ScratchFolder scratch;
        ADD_FAILURE();
    } catch (const FileError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("the folder for temporary files"));
        EXPECT_THAT(error.what(), testing::HasSubstr("TMPDIR"));
    }
}

} // namespace
} // namespace esm
