#include "core/support/atomic_file.h"
#include "core/support/errors.h"
#include "core/support/file_io.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <csignal>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace esm;
namespace fs = std::filesystem;

namespace {

std::vector<std::string> filesIn(const TemporaryFolder& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder.path()))
        names.push_back(entry.path().filename().string());
    return names;
}

} // namespace

TEST(AtomicFile, AppearsOnlyWhenItIsWhole) {
    const TemporaryFolder folder;
    const std::string piece(700'000, 'x');
    {
        AtomicFile file(folder / "big");
        for (int i = 0; i < 5; ++i)
            file.write(piece);
        EXPECT_FALSE(fs::exists(folder / "big"));
        file.commit();
    }
    EXPECT_EQ(fs::file_size(folder / "big"), 5 * piece.size());
    EXPECT_EQ(filesIn(folder).size(), 1u);
}

TEST(AtomicFile, LeavesNothingWhenGivenUp) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "a", std::string("old"));
    { AtomicFile(folder / "a").write(std::string(3'000'000, 'n')); }
    EXPECT_EQ(readFile(folder / "a"), (Bytes{'o', 'l', 'd'}));
    EXPECT_EQ(filesIn(folder).size(), 1u);
}

TEST(AtomicFile, KeepsTheOldFileOnAFullDisk) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "a", std::string("old"));
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{100'000, 100'000};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        try {
            writeFileAtomically(folder / "a", std::string(1'000'000, 'n'));
        } catch (const FileError&) {
            ::_exit(7);
        }
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(WEXITSTATUS(status), 7);
    EXPECT_EQ(readFile(folder / "a"), (Bytes{'o', 'l', 'd'}));
    EXPECT_EQ(filesIn(folder).size(), 1u);
}

TEST(AtomicFile, LeavesAWriteProtectedFileAlone) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "a", std::string("old"));
    ASSERT_EQ(::chmod((folder / "a").c_str(), 0444), 0);
    try {
        AtomicFile file(folder / "a");
        FAIL() << "accepted";
    } catch (const FileError& error) {
        EXPECT_NE(std::string(error.what()).find("write-protected"), std::string::npos) << error.what();
    }
    EXPECT_EQ(readFile(folder / "a"), (Bytes{'o', 'l', 'd'}));
    EXPECT_EQ(filesIn(folder).size(), 1u);
}

TEST(AtomicFile, GivesANewFileThePermissionsOfNewFiles) {
    const TemporaryFolder folder;
    const mode_t before = ::umask(027);
    writeFileAtomically(folder / "a", std::string("x"));
    const mode_t after = ::umask(before);
    EXPECT_EQ(after, mode_t{027}) << "the process' own mask was changed";
    struct stat status {};
    ASSERT_EQ(::stat((folder / "a").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0640u);
}

TEST(AtomicFile, RefusesWhatIsNoRegularFile) {
    const TemporaryFolder folder;
    EXPECT_THROW(AtomicFile("/dev/full"), FileError);
    EXPECT_THROW(AtomicFile(folder.path()), FileError);
    EXPECT_THROW(AtomicFile(folder / "none" / "a"), FileError);
    EXPECT_THROW(AtomicFile(""), FileError);
}

TEST(AtomicFile, RefusesALinkToNothing) {
    const TemporaryFolder folder;
    fs::create_symlink("nowhere", folder / "a");
    try {
        AtomicFile file(folder / "a");
        FAIL() << "accepted";
    } catch (const FileError& error) {
        EXPECT_NE(std::string(error.what()).find("a link to nowhere"), std::string::npos) << error.what();
    }
    EXPECT_TRUE(fs::is_symlink(folder / "a"));
}

TEST(AtomicFile, GoesIntoAFolderThatIsMadeWhenItIsWritten) {
    const TemporaryFolder folder;
    AtomicFile file(folder / "new" / "a", folder.path());
    file.write("whole");
    file.sync();
    EXPECT_TRUE(filesIn(folder).empty());
    fs::create_directory(folder / "new");
    file.commit();
    EXPECT_EQ(readFile(folder / "new" / "a").size(), 5u);
    EXPECT_EQ(filesIn(folder).size(), 1u);
}
