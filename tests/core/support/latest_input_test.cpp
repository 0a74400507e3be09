#include "core/support/latest_input.h"

#include <gtest/gtest.h>

#include <chrono>
#include <future>

using namespace esm;
using std::chrono::milliseconds;

TEST(LatestInput, GivesOnlyTheLatest) {
    LatestInput<int> input;
    input.put(1);
    input.put(2);
    EXPECT_EQ(input.take(), 2);
    EXPECT_FALSE(input.isObsolete());
    EXPECT_FALSE(input.becomesObsoleteWithin(milliseconds(0)));
}

TEST(LatestInput, WaitsForAnInput) {
    LatestInput<int> input;
    auto taken = std::async(std::launch::async, [&] { return input.take(); });
    EXPECT_EQ(taken.wait_for(milliseconds(0)), std::future_status::timeout);
    input.put(3);
    EXPECT_EQ(taken.get(), 3);
}

TEST(LatestInput, MakesObsoleteWhatWasTaken) {
    LatestInput<int> input;
    input.put(1);
    input.take();
    input.put(2);
    EXPECT_TRUE(input.isObsolete());
    EXPECT_TRUE(input.becomesObsoleteWithin(milliseconds(60000)));
    EXPECT_TRUE(input.isObsolete([](int next) { return next == 2; }));
    EXPECT_FALSE(input.isObsolete([](int next) { return next == 3; }));
}

TEST(LatestInput, GivesNothingMoreOnceStopped) {
    LatestInput<int> input;
    input.put(1);
    input.stop();
    EXPECT_TRUE(input.isObsolete([](int) { return false; }));
    EXPECT_FALSE(input.take());
}
