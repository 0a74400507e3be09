#include "core/support/child_process.h"

#include "tests/support/running_process.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <optional>
#include <sys/wait.h>
#include <system_error>
#include <thread>

namespace esm {
namespace {

using namespace std::chrono_literals;

TEST(ChildProcess, TellsHowItEnded) {
    ChildProcess process({.words = {"/bin/sh", "-c", "exit 7"}});
    while (!process.endsWithin(20ms)) {
    }
    EXPECT_TRUE(WIFEXITED(process.status()));
    EXPECT_EQ(WEXITSTATUS(process.status()), 7);
}

TEST(ChildProcess, SaysWhyItCannotBeStarted) {
    try {
        const ChildProcess process({.words = {"/nowhere/program"}});
        FAIL();
    } catch (const std::system_error& error) {
        EXPECT_EQ(error.code().value(), ENOENT);
    }
}

TEST(ChildProcess, EndsWhatItLeftBehind) {
    const TemporaryFolder folder;
    const auto written = folder / "child";
    ChildProcess process({.words = {"/bin/sh", "-c", "sleep infinity & echo $! > " + written.string()}});
    while (!process.endsWithin(20ms)) {
    }
    EXPECT_EQ(WEXITSTATUS(process.status()), 0);
    EXPECT_TRUE(process.endsWithin(0ms));
    EXPECT_TRUE(WIFEXITED(process.status()));
    pid_t child = 0;
    ASSERT_TRUE(std::ifstream(written) >> child);
    while (test::isRunning(child)) // its new parent hears of it soon
        std::this_thread::yield();
}

TEST(ChildProcess, EndsWithItsOwnerAndWithAllThatItStarted) {
    const TemporaryFolder folder;
    const auto written = folder / "child";
    pid_t child = 0;
    {
        ChildProcess process(
            {.words = {"/bin/sh", "-c", "sleep infinity & echo $! > " + written.string() + "; wait"}});
        while (!(std::ifstream(written) >> child))
            ASSERT_FALSE(process.endsWithin(20ms));
    }
    while (test::isRunning(child)) // its new parent hears of it soon
        std::this_thread::yield();
}

TEST(ProgramInPath, IsTheFirstThatCanBeRun) {
    EXPECT_TRUE(canBeRun(programInPath("sh").value()));
    EXPECT_EQ(programInPath("no-such-program"), std::nullopt);
    EXPECT_FALSE(canBeRun("/tmp"));
    EXPECT_FALSE(canBeRun("/etc/passwd"));
}

} // namespace
} // namespace esm
