// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/median.hpp"

#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace balcony::median_test {
namespace {

TEST(Median, IsTheMiddleOfAnOddCount) {
    EXPECT_EQ(median({7.0}), 7.0);
    EXPECT_EQ(median({9.0, -1.0, 4.0}), 4.0);
    EXPECT_EQ(median({}), std::nullopt);
}

TEST(Median, IsTheMeanOfTheTwoInTheMiddleOfAnEvenCount) {
    EXPECT_EQ(median({4.0, 1.0}), 2.5);
    EXPECT_EQ(median({100.0, 1.0, 2.0, 4.0}), 3.0);
    constexpr double large = std::numeric_limits<double>::max();
    EXPECT_EQ(median({large, large}), large);
}

// Neither turning the sign round nor the order in which numbers come makes a difference.
TEST(Median, IsSymmetrical) {
    std::mt19937 random(1);
    for (std::size_t count = 1; count < 50; ++count) {
        std::vector<double> numbers;
        std::vector<double> negated;
        for (std::size_t i = 0; i < count; ++i) {
            numbers.push_back(static_cast<double>(random() % 20));
            negated.insert(negated.begin(), -numbers.back());
        }
        EXPECT_EQ(*median(numbers), -*median(negated));
    }
}

}  // namespace
}  // namespace balcony::median_test
