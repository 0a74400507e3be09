#pragma once

#include "core/support/progress.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace esm::test {

using LongWork = std::function<void(const Progress&)>;

/// What work tells of itself until it is done.
inline std::vector<double> toldBy(const LongWork& work) {
    std::vector<double> told;
    work([&](double fraction) {
        told.push_back(fraction);
        return true;
    });
    return told;
}

/// Work tells how far it is more than once, from 0 to 1, and never goes back.
inline void expectSteadyProgress(const LongWork& work) {
    const std::vector<double> told = toldBy(work);
    ASSERT_GT(told.size(), 2U);
    EXPECT_GE(told.front(), 0);
    EXPECT_LT(told.front(), 0.5);
    EXPECT_NEAR(told.back(), 1, 1e-9);
    const auto back = std::is_sorted_until(told.begin(), told.end());
    EXPECT_TRUE(back == told.end()) << "it goes back from " << *(back - 1) << " to " << *back;
}

/// Work ends as cancelled wherever it is asked to: at once, on its way and at its very end.
/// @param isUntouched asked afterwards each time
inline void expectStopsAnywhere(
    const LongWork& work, const std::function<bool()>& isUntouched = [] { return true; }) {
    for (const double from : {0.0, 0.3, 0.6, 0.9, 1 - 1e-9}) {
        int afterwards = 0;
        bool isAsked = false;
        const Progress stop = [&](double fraction) {
            afterwards += isAsked;
            isAsked = isAsked || fraction >= from;
            return !isAsked;
        };
        EXPECT_THROW(work(stop), Cancelled) << "asked from " << from << " on";
        EXPECT_EQ(afterwards, 0) << "it goes on after it was asked to stop from " << from << " on";
        EXPECT_TRUE(isUntouched()) << "stopped from " << from << " on";
    }
}

inline void expectGoodProgress(const LongWork& work) {
    expectSteadyProgress(work);
    expectStopsAnywhere(work);
}

} // namespace esm::test
