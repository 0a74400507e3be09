#include "app/editor/preview/latest_input.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

using namespace esm;
using std::chrono::milliseconds;

TEST(LatestInput, GivesOnlyTheLatest) {
    LatestInput<int> input;
    input.put(1);
    input.put(2);
    EXPECT_EQ(input.take(), 2);
    EXPECT_FALSE(input.isObsolete());
    EXPECT_FALSE(input.becomesObsoleteWithin(milliseconds(10)));
}

TEST(LatestInput, WaitsForAnInput) {
    LatestInput<int> input;
    std::thread giver([&] {
        std::this_thread::sleep_for(milliseconds(50));
        input.put(3);
    });
    EXPECT_EQ(input.take(), 3);
    giver.join();
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
