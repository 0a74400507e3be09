#include "core/dynamics/kernel/thread_team.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <thread>
#include <unistd.h>

using namespace esm;

namespace {

/// s of processor time that the whole program has used (CLOCK_PROCESS_CPUTIME_ID), or this thread.
double processorTime(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Whether a thread of this program waits for something: what the kernel says after its name in brackets.
bool isAsleep(const std::filesystem::path& task) {
    std::ifstream file(task / "stat");
    std::string line;
    std::getline(file, line);
    const std::size_t name = line.rfind(')');
    return name != std::string::npos && line.compare(name + 2, 1, "S") == 0;
}

/// Until all other threads of the program sleep; only a test's time limit ends a wait for one that never
/// does.
void waitUntilOthersSleep() {
    const std::string self = std::to_string(::gettid());
    const auto isAwake = [&](const auto& task) {
        return task.path().filename() != self && !isAsleep(task.path());
    };
    for (bool awake = true; awake; std::this_thread::yield()) {
        const std::filesystem::directory_iterator tasks("/proc/self/task");
        awake = std::any_of(begin(tasks), end(tasks), isAwake);
    }
}

} // namespace

TEST(ThreadTeam, DoesEveryPartOnce) {
    for (const std::size_t threads : {1U, 2U, 3U, 5U}) {
        ThreadTeam team(threads);
        EXPECT_EQ(team.size(), threads);
        for (const std::size_t parts : {0U, 1U, 2U, 3U, 4U, 17U, 1000U}) {
            std::vector<int> calls(parts, 0);
            team.run(parts, [&](std::size_t part) { ++calls[part]; });
            EXPECT_EQ(calls, std::vector<int>(parts, 1)) << threads << " threads, " << parts << " parts";
        }
    }
}

TEST(ThreadTeam, SeesWhatWasWrittenBeforeAndIsSeenAfter) {
    ThreadTeam team(3);
    std::vector<std::size_t> numbers(64, 0);
    constexpr std::size_t rounds = 20000;
    for (std::size_t round = 0; round < rounds; ++round) {
        team.run(numbers.size(), [&](std::size_t part) { numbers[part] += round + part; });
        std::rotate(numbers.begin(), numbers.begin() + 1, numbers.end());
    }
    EXPECT_EQ(std::accumulate(numbers.begin(), numbers.end(), std::size_t{0}),
              rounds * (rounds - 1) / 2 * 64 + rounds * (63 * 64 / 2));
}

TEST(ThreadTeam, UsesNoMoreThreadsThanItMay) {
    ThreadTeam team(4);
    std::vector<std::thread::id> ids(100);
    team.run(
        ids.size(), [&](std::size_t part) { ids[part] = std::this_thread::get_id(); }, 1);
    EXPECT_EQ(ids, std::vector<std::thread::id>(100, std::this_thread::get_id()));
    for (int i = 0; i < 100; ++i) {
        team.run(
            ids.size(), [&](std::size_t part) { ids[part] = std::this_thread::get_id(); }, 2);
        std::sort(ids.begin(), ids.end());
        EXPECT_LE(std::unique(ids.begin(), ids.end()) - ids.begin(), 2);
    }
}

TEST(ThreadTeam, WorksAgainAfterItSlept) {
    ThreadTeam team(2);
    for (int i = 0; i < 5; ++i) {
        std::atomic<int> calls{0};
        team.run(8, [&](std::size_t) { ++calls; });
        EXPECT_EQ(calls, 8);
        waitUntilOthersSleep();
    }
}

TEST(ThreadTeam, UsesNoTimeWhileIdle) {
    ThreadTeam team(3);
    team.run(8, [](std::size_t) {});
    waitUntilOthersSleep();
    const double whole = processorTime(CLOCK_PROCESS_CPUTIME_ID);
    const double own = processorTime(CLOCK_THREAD_CPUTIME_ID);
    // This thread computes for a while, in which the others use nothing, however busy the machine is.
    while (processorTime(CLOCK_THREAD_CPUTIME_ID) - own < 0.3) {
    }
    const double used = processorTime(CLOCK_PROCESS_CPUTIME_ID) - whole;
    EXPECT_LT(used - (processorTime(CLOCK_THREAD_CPUTIME_ID) - own), 0.02);
}

TEST(ThreadTeam, TakesAsManyThreadsAsTheMachineHas) {
    EXPECT_EQ(ThreadTeam().size(), std::max(1U, std::thread::hardware_concurrency()));
}

TEST(ThreadTeam, EndsAtOnceWithoutHavingWorked) {
    for (int i = 0; i < 50; ++i)
        ThreadTeam team(4);
}
