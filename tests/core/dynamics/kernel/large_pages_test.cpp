#include "core/dynamics/kernel/large_pages.h"

#include <gtest/gtest.h>

#include <cstdint>

using namespace esm;

TEST(LargePages, HoldsFewAndManyNumbers) {
    for (const std::size_t count : {1U, 7U, 1000U, 600'000U, 3'000'001U}) {
        LargeVector<double> numbers(count, 1.5);
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(numbers.data()) % 64, 0U);
        numbers.push_back(2);
        EXPECT_EQ(numbers[count - 1], 1.5);
        EXPECT_EQ(numbers.back(), 2);
        const LargeVector<double> copy = numbers;
        EXPECT_EQ(copy, numbers);
    }
}
