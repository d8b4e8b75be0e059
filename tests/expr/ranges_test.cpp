// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Where the values of operations lie: everywhere in their ranges, and up to the ends of these.

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "random_intervals.hpp"

namespace balcony::expr::ranges_test {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double pi = std::numbers::pi;
constexpr Range truth{0.0, 1.0, false};

Range between(double least, double most) { return {least, most, false}; }

// The values of an operation at numbers of intervals: the least, the largest, and whether one is
// NaN.
Range values_of(Op op, const std::array<RandomInterval, 3>& intervals) {
    const auto arity = static_cast<std::size_t>(operation(op).arity);
    Range found{infinity, -infinity, false};
    const auto count = [&](std::size_t k) {
        return k < arity ? intervals[k].numbers.size() : std::size_t{1};
    };
    for (std::size_t i = 0; i < count(0); ++i) {
        for (std::size_t j = 0; j < count(1); ++j) {
            for (std::size_t k = 0; k < count(2); ++k) {
                const std::array at{intervals[0].numbers[i], intervals[1].numbers[j],
                                    intervals[2].numbers[k]};
                const double value = operation(op).scalar(at.data());
                found.may_be_nan = found.may_be_nan || std::isnan(value);
                found.least = std::fmin(found.least, value);
                found.most = std::fmax(found.most, value);
            }
        }
    }
    return found;
}

struct Trial {
    std::array<RandomInterval, 3> intervals;
    Range told;
    Range values;
    std::string text;

    Trial(Op op, std::mt19937_64& random, std::span<const double> among, std::size_t count)
        : intervals{RandomInterval(random, among, count), RandomInterval(random, among, count),
                    RandomInterval(random, among, 3)},
          values(values_of(op, intervals)) {
        const std::array ranges{intervals[0].range, intervals[1].range, intervals[2].range};
        told = range_of(op, ranges.data());
        text = std::string(operation(op).name);
        for (const Range& range : ranges) {
            text += " " + std::to_string(range.least) + " .. " + std::to_string(range.most);
        }
    }
};

Range range(Op op, Range a, Range b = {}, Range c = {}) {
    const std::array arguments{a, b, c};
    return range_of(op, arguments.data());
}

std::optional<std::size_t> chosen(Op op, Range a, Range b = {}, Range c = {}) {
    const std::array arguments{a, b, c};
    return chosen_argument(op, arguments.data());
}

void expect_range(Range found, double least, double most) {
    EXPECT_FALSE(found.may_be_nan);
    EXPECT_NEAR(found.least, least, 1e-12);
    EXPECT_NEAR(found.most, most, 1e-12);
}

// Of the operations whose values are least and largest at the ends of their arguments, or at 0.
bool has_tight_ranges(Op op) {
    return operation(op).range != nullptr && op != Op::modulo && op != Op::sine && op != Op::cosine;
}

}  // namespace

TEST(Ranges, HoldAllValues) {
    std::mt19937_64 random(3);
    for (const Operation& row : operations()) {
        for (int trial = 0; row.scalar != nullptr && trial < 3000; ++trial) {
            const Trial found(row.op, random, special_numbers, 6);
            ASSERT_LE(found.told.least, found.values.least) << found.text;
            ASSERT_GE(found.told.most, found.values.most) << found.text;
            ASSERT_LE(found.values.may_be_nan, found.told.may_be_nan) << found.text;
        }
    }
}

// For ordinary numbers, so that sums do not overflow and domains are not left by much.
TEST(Ranges, EndAtValues) {
    constexpr std::array ordinary{-9.0, -4.0, -2.5, -1.0, -0.6, -0.2, 0.0,
                                  0.3,  0.5,  0.9,  1.0,  2.0,  5.0,  8.0};
    std::mt19937_64 random(4);
    for (const Operation& row : operations()) {
        for (int trial = 0; has_tight_ranges(row.op) && trial < 300; ++trial) {
            const Trial found(row.op, random, ordinary, 3);
            const auto& [a, b, c] = found.intervals;
            const bool divides_by_zero =
                row.op == Op::divide && b.range.least <= 0.0 && b.range.most >= 0.0;
            const bool has_base_below_zero = row.op == Op::power && a.range.least <= 0.0;
            const bool jumps = row.op == Op::arctangent2 && a.range.least <= 0.0 &&
                               a.range.most >= 0.0 && b.range.least <= 0.0;
            const bool may_meet = row.op == Op::equal && a.range.least <= b.range.most &&
                                  b.range.least <= a.range.most;
            if (found.values.may_be_nan || divides_by_zero || has_base_below_zero || jumps ||
                may_meet || std::isinf(found.values.least)) {
                continue;
            }
            ASSERT_FALSE(found.told.may_be_nan) << found.text;
            // The widening of functions by four units in the last place, and their rounding.
            const auto expect_near = [&](double told, double value) {
                ASSERT_NEAR(told, value, 3e-15 * std::fabs(value) + 1e-300) << found.text;
            };
            expect_near(found.told.least, found.values.least);
            expect_near(found.told.most, found.values.most);
        }
    }
}

TEST(Ranges, OfCrestsAreThoseOfWholeWaves) {
    expect_range(range(Op::sine, between(0.0, 3.0)), 0.0, 1.0);
    expect_range(range(Op::sine, between(2.0, 5.0)), -1.0, std::sin(2.0));
    expect_range(range(Op::sine, between(1.6, 4.6)), std::sin(4.6), std::sin(1.6));
    expect_range(range(Op::sine, between(-20.0, 20.0)), -1.0, 1.0);
    expect_range(range(Op::sine, between(2e6, 2e6 + 0.1)), -1.0, 1.0);
    expect_range(range(Op::cosine, between(-1.0, 2.0)), std::cos(2.0), 1.0);
    expect_range(range(Op::cosine, between(3.0, 6.0)), -1.0, std::cos(6.0));
    EXPECT_TRUE(range(Op::sine, between(0.0, infinity)).may_be_nan);
}

TEST(Ranges, AreUnknownOutsideOfTheDomain) {
    EXPECT_FALSE(range(Op::square_root, between(0.0, 2.0)).may_be_nan);
    EXPECT_TRUE(range(Op::square_root, between(-0.1, 2.0)).may_be_nan);
    EXPECT_FALSE(range(Op::logarithm, between(0.0, 2.0)).may_be_nan);
    EXPECT_TRUE(range(Op::logarithm, between(-0.1, 2.0)).may_be_nan);
    EXPECT_FALSE(range(Op::arcsine, between(-1.0, 1.0)).may_be_nan);
    EXPECT_TRUE(range(Op::arcsine, between(-1.1, 0.0)).may_be_nan);
    EXPECT_TRUE(range(Op::arcsine, between(0.0, 1.1)).may_be_nan);
    EXPECT_FALSE(range(Op::arccosine, between(-1.0, 1.0)).may_be_nan);
    EXPECT_TRUE(range(Op::arccosine, between(-1.1, 0.0)).may_be_nan);
    EXPECT_TRUE(range(Op::arccosine, between(0.0, 1.1)).may_be_nan);
    EXPECT_FALSE(range(Op::power, between(0.1, 2.0), between(-1.0, 1.0)).may_be_nan);
    EXPECT_TRUE(range(Op::power, between(0.0, 2.0), between(-1.0, 1.0)).may_be_nan);
    EXPECT_TRUE(range(Op::divide, between(1.0, 2.0), between(0.0, 1.0)).may_be_nan);
    EXPECT_TRUE(range(Op::divide, between(1.0, 2.0), between(-1.0, 0.0)).may_be_nan);
    EXPECT_TRUE(range(Op::add, between(1.0, infinity), between(-infinity, 0.0)).may_be_nan);
    EXPECT_TRUE(range(Op::add, {}, between(0.0, 1.0)).may_be_nan);
    EXPECT_TRUE(range(Op::tangent, between(0.0, 1.0)).may_be_nan);
    expect_range(range(Op::arctangent2, between(-1.0, 1.0), between(-1.0, 1.0)), -pi, pi);
    expect_range(range(Op::arctangent2, between(0.0, infinity), between(1.0, 2.0)), -pi, pi);
}

TEST(Ranges, OfRemaindersAreOneTurn) {
    expect_range(range(Op::modulo, between(1.0, 2.5), between(3.0, 3.0)), 1.0, 2.5);
    expect_range(range(Op::modulo, between(1.0, 3.5), between(3.0, 3.0)), 0.0, 3.0);
    expect_range(range(Op::modulo, between(-1.0, 1.0), between(2.0, 3.0)), 0.0, 3.0);
    EXPECT_TRUE(range(Op::modulo, between(1.0, 2.0), between(0.0, 3.0)).may_be_nan);
    EXPECT_TRUE(range(Op::modulo, between(1.0, 2.0), between(-3.0, -1.0)).may_be_nan);
    EXPECT_TRUE(range(Op::modulo, between(1.0, 1e308), between(3.0, 3.0)).may_be_nan);
    EXPECT_TRUE(range(Op::modulo, between(1.0, 1e300), between(1e-300, 3.0)).may_be_nan);
    EXPECT_EQ(chosen(Op::modulo, between(1.0, 2.5), between(3.0, 4.0)), 0);
    EXPECT_EQ(chosen(Op::modulo, between(1.0, 3.0), between(3.0, 4.0)), std::nullopt);
    EXPECT_EQ(chosen(Op::modulo, between(0.0, 2.5), between(3.0, 4.0)), std::nullopt);
    EXPECT_EQ(chosen(Op::modulo, between(1.0, 2.5), between(3.0, infinity)), std::nullopt);
}

TEST(Ranges, OfASquareHasNoNegativeNumbers) {
    expect_range(range_of_square(between(-2.0, 3.0)), 0.0, 9.0);
    expect_range(range_of_square(between(-3.0, -2.0)), 4.0, 9.0);
    EXPECT_TRUE(range_of_square(between(-2.0, infinity)).may_be_nan);
    EXPECT_TRUE(range_of_square({}).may_be_nan);
}

TEST(Ranges, OfConditionsSayWhetherTheyHold) {
    const Range low = between(1.0, 2.0);
    const Range high = between(2.0, 3.0);
    const Range number{1.0, 1.0, true};
    expect_range(range(Op::less, low, high), 0.0, 1.0);
    expect_range(range(Op::less, high, low), 0.0, 0.0);
    expect_range(range(Op::less, low, between(2.5, 3.0)), 1.0, 1.0);
    expect_range(range(Op::less, low, {2.5, 3.0, true}), 0.0, 1.0);
    expect_range(range(Op::less_equal, low, high), 1.0, 1.0);
    expect_range(range(Op::less_equal, high, low), 0.0, 1.0);
    expect_range(range(Op::less_equal, {1.0, 2.0, true}, high), 0.0, 1.0);
    expect_range(range(Op::equal, low, between(2.5, 3.0)), 0.0, 0.0);
    expect_range(range(Op::equal, between(2.5, 3.0), low), 0.0, 0.0);
    expect_range(range(Op::equal, low, high), 0.0, 1.0);
    expect_range(range(Op::equal, between(2.0, 2.0), between(2.0, 2.0)), 1.0, 1.0);
    expect_range(range(Op::equal, between(2.0, 2.0), between(1.0, 2.0)), 0.0, 1.0);
    expect_range(range(Op::equal, number, number), 0.0, 1.0);
    expect_range(range(Op::is_finite, low), 1.0, 1.0);
    expect_range(range(Op::is_finite, number), 0.0, 1.0);
    expect_range(range(Op::is_finite, between(0.0, infinity)), 0.0, 1.0);
    // A number that is not 0 is true.
    const Range never = between(0.0, 0.0);
    const Range always = between(-2.0, -1.0);
    expect_range(range(Op::logical_and, always, never), 0.0, 0.0);
    expect_range(range(Op::logical_and, truth, never), 0.0, 0.0);
    expect_range(range(Op::logical_and, never, truth), 0.0, 0.0);
    expect_range(range(Op::logical_and, always, high), 1.0, 1.0);
    expect_range(range(Op::logical_and, always, truth), 0.0, 1.0);
    expect_range(range(Op::logical_and, truth, always), 0.0, 1.0);
    expect_range(range(Op::logical_or, always, truth), 1.0, 1.0);
    expect_range(range(Op::logical_or, truth, always), 1.0, 1.0);
    expect_range(range(Op::logical_or, never, never), 0.0, 0.0);
    expect_range(range(Op::logical_or, never, truth), 0.0, 1.0);
    expect_range(range(Op::logical_or, truth, never), 0.0, 1.0);
    expect_range(range(Op::logical_not, always), 0.0, 0.0);
    expect_range(range(Op::logical_not, never), 1.0, 1.0);
    expect_range(range(Op::logical_not, truth), 0.0, 1.0);
    expect_range(range(Op::logical_not, number), 0.0, 1.0);
}

TEST(Ranges, TellWhichArgumentIsTheValue) {
    const Range low = between(1.0, 2.0);
    const Range high = between(3.0, 4.0);
    EXPECT_EQ(chosen(Op::minimum, low, high), 0);
    EXPECT_EQ(chosen(Op::minimum, high, low), 1);
    EXPECT_EQ(chosen(Op::minimum, low, between(2.0, 4.0)), std::nullopt);
    EXPECT_EQ(chosen(Op::minimum, between(2.0, 4.0), low), std::nullopt);
    EXPECT_EQ(chosen(Op::minimum, low, {3.0, 4.0, true}), std::nullopt);
    EXPECT_EQ(chosen(Op::maximum, low, high), 1);
    EXPECT_EQ(chosen(Op::maximum, high, low), 0);
    EXPECT_EQ(chosen(Op::maximum, low, between(2.0, 4.0)), std::nullopt);
    EXPECT_EQ(chosen(Op::maximum, between(2.0, 4.0), low), std::nullopt);
    EXPECT_EQ(chosen(Op::select, between(1.0, 1.0), low, high), 1);
    EXPECT_EQ(chosen(Op::select, between(-1.0, -0.5), low, high), 1);
    EXPECT_EQ(chosen(Op::select, between(0.0, 0.0), low, {}), 2);
    EXPECT_EQ(chosen(Op::select, truth, low, high), std::nullopt);
    EXPECT_EQ(chosen(Op::select, {1.0, 1.0, true}, low, high), std::nullopt);
    EXPECT_EQ(chosen(Op::add, low, high), std::nullopt);
    expect_range(range(Op::select, between(1.0, 1.0), low, {}), 1.0, 2.0);
    expect_range(range(Op::select, between(0.0, 0.0), {}, high), 3.0, 4.0);
    expect_range(range(Op::select, truth, low, high), 1.0, 4.0);
    EXPECT_TRUE(range(Op::select, truth, low, {3.0, 4.0, true}).may_be_nan);
    EXPECT_TRUE(range(Op::select, truth, {3.0, 4.0, true}, low).may_be_nan);
}

}  // namespace balcony::expr::ranges_test
