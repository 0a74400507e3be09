#include "core/support/errors.h"
#include "core/support/file_io.h"
#include "core/support/file_lock.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <csignal>
#include <sys/wait.h>
#include <unistd.h>

using namespace esm;
namespace fs = std::filesystem;

namespace {

/// What a second writer is told; empty when it may write.
std::string refusal(const fs::path& file) {
    try {
        FileLock lock(file);
        return {};
    } catch (const FileError& error) {
        return error.what();
    }
}

std::string change(const FileLock& lock) {
    try {
        lock.requireUnchanged();
        return {};
    } catch (const FileError& error) {
        return error.what();
    }
}

/// Another process that holds the lock until it is killed.
pid_t startHolder(const fs::path& file) {
    int ready[2];
    EXPECT_EQ(::pipe(ready), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        const FileLock lock(file);
        [[maybe_unused]] const ssize_t told = ::write(ready[1], "x", 1);
        while (true)
            ::pause();
    }
    char byte = 0;
    EXPECT_EQ(::read(ready[0], &byte, 1), 1);
    ::close(ready[0]);
    ::close(ready[1]);
    return child;
}

void kill(pid_t process) {
    ::kill(process, SIGKILL);
    ::waitpid(process, nullptr, 0);
}

} // namespace

TEST(FileLock, KeepsASecondProcessAwayAndNamesTheFirst) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "a", std::string("old"));
    const pid_t holder = startHolder(folder / "a");
    const std::string told = refusal(folder / "a");
    kill(holder);
    EXPECT_NE(told.find("process " + std::to_string(holder) + " ("), std::string::npos) << told;
    EXPECT_NE(told.find("support_tests"), std::string::npos) << told;
}

TEST(FileLock, GoesWithTheProcessThatHeldIt) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "a", std::string("old"));
    kill(startHolder(folder / "a"));
    EXPECT_EQ(refusal(folder / "a"), "");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

TEST(FileLock, HoldsWhileTheSameProcessReadsTheFile) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "a", std::string("old"));
    const FileLock lock(folder / "a");
    EXPECT_EQ(readFile(folder / "a").size(), 3u);
    EXPECT_NE(refusal(folder / "a"), "");
}

TEST(FileLock, IsOfTheFileThatIsThereNow) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "a", std::string("old"));
    const FileLock former(folder / "a");
    writeFileAtomically(folder / "a", std::string("new"));
    const FileLock lock(folder / "a");
    EXPECT_EQ(change(lock), "");
    EXPECT_NE(refusal(folder / "a"), "");
}

TEST(FileLock, TellsWhenAnotherProgramCameBetween) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "a", std::string("old"));
    const FileLock lock(folder / "a"), missing(folder / "b");
    EXPECT_EQ(change(lock) + change(missing), "");
    for (const char* name : {"a", "b"})
        writeFileAtomically(folder / name, std::string("changed"));
    EXPECT_NE(change(lock).find("changed by another program"), std::string::npos);
    EXPECT_NE(change(missing).find("changed by another program"), std::string::npos);
}

TEST(FileLock, LeavesToTheWriterWhatCannotBeLocked) {
    const TemporaryFolder folder;
    EXPECT_EQ(refusal(folder.path()), "");
    EXPECT_EQ(refusal(folder / "none" / "a"), "");
    EXPECT_EQ(refusal("/dev/null"), "");
}
