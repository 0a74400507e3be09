#include "core/dynamics/kernel/thread_team.h"

#include <gtest/gtest.h>

#include <chrono>
#include <ctime>
#include <numeric>

using namespace esm;

namespace {

/// s of processor time that the whole program has used.
double processorTime() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

} // namespace

TEST(ThreadTeam, DoesEveryPartOnce) {
    for (const std::size_t threads : {1, 2, 3, 5}) {
        ThreadTeam team(threads);
        EXPECT_EQ(team.size(), threads);
        for (const std::size_t parts : {0, 1, 2, 3, 4, 17, 1000}) {
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
        std::this_thread::sleep_for(std::chrono::milliseconds(30));
    }
}

TEST(ThreadTeam, UsesNoTimeWhileIdle) {
    ThreadTeam team(3);
    team.run(8, [](std::size_t) {});
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    const double before = processorTime();
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    EXPECT_LT(processorTime() - before, 0.02);
}

TEST(ThreadTeam, TakesAsManyThreadsAsTheMachineHas) {
    EXPECT_EQ(ThreadTeam().size(), std::max(1U, std::thread::hardware_concurrency()));
}

TEST(ThreadTeam, EndsAtOnceWithoutHavingWorked) {
    for (int i = 0; i < 50; ++i)
        ThreadTeam team(4);
}
