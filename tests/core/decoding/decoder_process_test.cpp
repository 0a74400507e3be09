#include "core/decoding/decoder_process.h"

#include "core/support/errors.h"
#include "tests/support/decode_with.h"
#include "tests/support/sanitized.h"

#include <gmock/gmock.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <memory>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace esm {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr DecodingLimits enough{4'000'000'000, 1'000'000'000, 300};

DecodedStream standIn(const std::string& role, const DecodingLimits& limits = enough,
                      const Progress& progress = {}, const TimeSource& clock = steadySeconds) {
    const DecodeWith program(failingDecoder());
    return decodeApart({role + ".ply", {"mesh", role + ".ply"}, nullptr, limits, clock}, progress);
}

/// The one line that tells of a decoder that plays a role.
std::string errorOf(const std::string& role, const DecodingLimits& limits = enough,
                    const TimeSource& clock = steadySeconds) {
    try {
        standIn(role, limits, {}, clock);
    } catch (const FileError& error) {
        EXPECT_THAT(error.what(), testing::StartsWith(role + ".ply: "));
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        return error.what();
    }
    return "no error";
}

bool hasChildren() {
    return ::waitpid(-1, nullptr, WNOHANG) >= 0 || errno != ECHILD;
}

TEST(DecoderProcess, CostsAMessageWhenItDies) {
    EXPECT_THAT(errorOf("abort"), AllOf(HasSubstr("decoder failed"), HasSubstr("Aborted")));
    EXPECT_THAT(errorOf("crash"), HasSubstr("decoder failed"));
    EXPECT_THAT(errorOf("exit"), HasSubstr("decoder failed"));
    EXPECT_THAT(errorOf("killed"), HasSubstr("the system ended the decoder"));
    EXPECT_FALSE(hasChildren());
}

TEST(DecoderProcess, CostsAMessageWhenItHandsBackNonsense) {
    EXPECT_THAT(errorOf("nonsense"), HasSubstr("makes no sense"));
    EXPECT_THAT(errorOf("silent"), HasSubstr("makes no sense"));
    EXPECT_EQ(errorOf("chatter"), "chatter.ply: two lines [31m");
}

TEST(DecoderProcess, IsHeldToItsTime) {
    EXPECT_THAT(errorOf("loop", {enough.memory, enough.output, 1}), HasSubstr("within the 1 s"));
    const TimeSource fast = [now = std::make_shared<double>(0)] { return *now += 1000; };
    EXPECT_THAT(errorOf("sleep", enough, fast), HasSubstr("within the 300 s"));
}

TEST(DecoderProcess, IsHeldToItsMemory) {
    if (isSanitized()) GTEST_SKIP() << "addresses are not limited under the address sanitizer";
    // It aborts when it is given no more; without the limit it would go on to the machine's last byte.
    EXPECT_THAT(errorOf("eat", {500'000'000, enough.output, 60}), HasSubstr("decoder failed"));
}

TEST(DecoderProcess, IsHeldToWhatItMayHandBack) {
    EXPECT_THAT(errorOf("long", {enough.memory, 30'000'000, 60}), HasSubstr("larger than the 0.0 GB"));
}

TEST(DecoderProcess, StopsWhenAsked) {
    for (const char* role : {"loop", "sleep"}) {
        int asked = 0;
        double told = 0;
        EXPECT_THROW(standIn(role, enough,
                             [&](double fraction) {
                                 told = fraction;
                                 return ++asked < 3;
                             }),
                     Cancelled);
        EXPECT_EQ(asked, 3);
        EXPECT_LT(told, 0.5) << "far from what it may take";
        EXPECT_FALSE(hasChildren());
    }
}

TEST(DecoderProcess, InheritsNeitherFilesNorSignals) {
    const int open = ::open("/etc/passwd", O_RDONLY);
    sigset_t interrupt, before;
    sigemptyset(&interrupt);
    sigaddset(&interrupt, SIGINT);
    ::pthread_sigmask(SIG_BLOCK, &interrupt, &before);
    const auto handler = ::signal(SIGXFSZ, SIG_IGN);
    EXPECT_THAT(errorOf("inheritance"), HasSubstr("has nothing"));
    ::signal(SIGXFSZ, handler);
    ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
    ::close(open);
}

TEST(DecoderProcess, WorksWhereChildrenAreNotWaitedFor) {
    const auto handler = ::signal(SIGCHLD, SIG_IGN);
    EXPECT_THAT(errorOf("chatter"), HasSubstr("two lines"));
    EXPECT_THAT(errorOf("abort"), HasSubstr("makes no sense"));
    ::signal(SIGCHLD, handler);
}

TEST(DecoderProcess, LeavesNoFilesOpen) {
    const auto openFiles = [] {
        return std::distance(std::filesystem::directory_iterator("/proc/self/fd"), {});
    };
    const auto before = openFiles();
    for (const char* role : {"abort", "nonsense", "chatter"})
        errorOf(role);
    EXPECT_EQ(openFiles(), before);
}

TEST(DecoderProcess, MayBeStartedFromManyThreads) {
    const DecodeWith program(failingDecoder());
    std::atomic<int> said = 0;
    std::vector<std::thread> threads;
    for (int i = 0; i < 8; ++i)
        threads.emplace_back([&] {
            try {
                decodeApart({"a.ply", {"mesh", "chatter.ply"}, nullptr, enough}, {});
            } catch (const FileError&) {
                ++said;
            }
        });
    for (std::thread& thread : threads)
        thread.join();
    EXPECT_EQ(said, 8);
}

} // namespace
} // namespace esm
