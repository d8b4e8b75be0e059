// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bridge/text/coarse_table.hpp"

namespace balcony::bridge::coarse_table_test {
namespace {

using expr::Table;

template <class Function, class Slope>
std::shared_ptr<const Table> table_of(Function function, Slope slope, std::size_t cells) {
    std::vector<double> values;
    std::vector<double> slopes;
    for (std::size_t i = 0; i <= cells; ++i) {
        const double x = 3.0 * static_cast<double>(i) / static_cast<double>(cells);
        values.push_back(function(x));
        slopes.push_back(slope(x));
    }
    return std::make_shared<const Table>(expr::hermite_table(0.0, 3.0, values, slopes));
}

double largest_difference(const Table& a, const Table& b) {
    double largest = 0.0;
    for (int i = 0; i <= 10'007; ++i) {
        const double x = 3.0 * i / 10'007.0;
        largest = std::max(largest, std::abs(a(x) - b(x)));
    }
    return largest;
}

TEST(CoarseTable, HasFewerCellsAndTheSameValuesInSinglePrecision) {
    const auto sine =
        table_of([](double x) { return std::sin(x); }, [](double x) { return std::cos(x); }, 4096);
    const auto coarse = coarse_table(sine);
    // A cubic over a cell of width h is wrong by h^4/384: 4 units in the last place are h = 0.12.
    EXPECT_LE(coarse->axes.front().cells, 64U);
    EXPECT_LE(largest_difference(*sine, *coarse), 4.0 * std::numeric_limits<float>::epsilon());
}

TEST(CoarseTable, KeepsCornersOfTheFunction) {
    const auto corner = table_of([](double x) { return std::abs(x - 1.0); },
                                 [](double x) { return x < 1.0 ? -1.0 : 1.0; }, 3 * 512);
    const auto coarse = coarse_table(corner);
    EXPECT_LE(largest_difference(*corner, *coarse), 8.0 * std::numeric_limits<float>::epsilon());
    EXPECT_GE(coarse->axes.front().cells, 3 * 256U);
}

TEST(CoarseTable, LeavesOtherTablesAlone) {
    const auto steps =
        std::make_shared<const Table>(Table{{{0.0, 4.0, 4, 0}}, {1.0, 1.0, 1.0, 1.0}});
    EXPECT_EQ(coarse_table(steps), steps);
    const auto plane = std::make_shared<const Table>(
        Table{{{0.0, 1.0, 1, 1}, {0.0, 1.0, 1, 1}}, {0.0, 1.0, 1.0, 0.0}});
    EXPECT_EQ(coarse_table(plane), plane);
}

}  // namespace
}  // namespace balcony::bridge::coarse_table_test
