#include "core/support/errors.h"
#include "core/support/file_io.h"
#include "core/support/file_lock.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <csignal>
#include <sys/wait.h>
#include <unistd.h>

using namespace esm;
using namespace testing;
namespace fs = std::filesystem;

namespace {

/// What a second writer is told; empty when it may write.
std::string refusal(const fs::path& file) {
    try {
        FileLock lock(file);
        return {};
    } catch (const std::exception& error) {
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

/// Another process, which does this work until it is killed. It is there once the work has told that it
/// began.
class OtherProcess {
public:
    template<class Work> explicit OtherProcess(Work work) {
        int ready[2];
        EXPECT_EQ(::pipe(ready), 0);
        m_process = ::fork();
        if (m_process == 0) work([&] { [[maybe_unused]] const ssize_t told = ::write(ready[1], "x", 1); });
        char byte = 0;
        EXPECT_EQ(::read(ready[0], &byte, 1), 1);
        ::close(ready[0]);
        ::close(ready[1]);
    }
    OtherProcess(const OtherProcess&) = delete;
    OtherProcess& operator=(const OtherProcess&) = delete;
    ~OtherProcess() {
        ::kill(m_process, SIGKILL);
        ::waitpid(m_process, nullptr, 0);
    }

    pid_t id() const { return m_process; }

private:
    pid_t m_process = 0;
};

auto holding(const fs::path& file) {
    return [file](const auto& tellBegun) {
        const FileLock lock(file);
        tellBegun();
        while (true)
            ::pause();
    };
}

/// Locks and lets go, as often as it can.
auto lockingAgainAndAgain(const fs::path& file) {
    return [file](const auto& tellBegun) {
        tellBegun();
        while (true) {
            try {
                const FileLock lock(file);
            } catch (const std::exception&) {
                // held by the test at this moment
            }
        }
    };
}

} // namespace

TEST(FileLock, KeepsASecondProcessAwayAndNamesTheFirst) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "a", std::string("old"));
    const OtherProcess holder(holding(folder / "a"));
    EXPECT_THAT(refusal(folder / "a"), AllOf(HasSubstr("process " + std::to_string(holder.id()) + " ("),
                                             HasSubstr("support_tests")));
}

TEST(FileLock, RefusesInTheSameWordsWhereTheFirstIsDoneWhileItIsLookedFor) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "a", std::string("old"));
    const OtherProcess other(lockingAgainAndAgain(folder / "a"));
    for (int refusals = 0; refusals < 500;) {
        const std::string told = refusal(folder / "a");
        if (told.empty()) continue;
        ++refusals;
        ASSERT_THAT(told, HasSubstr("is being changed by "));
    }
}

TEST(FileLock, GoesWithTheProcessThatHeldIt) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "a", std::string("old"));
    { const OtherProcess holder(holding(folder / "a")); }
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
