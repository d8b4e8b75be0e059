// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// What expressions mean: each is evaluated as the x of an eye point.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support.hpp"

namespace balcony::lang::expression_test {
namespace {

using std::numbers::pi;

struct Case {
    const char* expression;
    double value;
};

Result<camera::Camera> camera_at(const std::string& expression) {
    return test::make(test::joined({"camera c { map u = 1 .. -1, v = square eye point(", expression,
                                    ", 0, 0) toward plane((1000, 0, 0)) }"}));
}

double value_of(const std::string& expression, double time = 0.0) {
    const Result<camera::Camera> made = camera_at(expression);
    EXPECT_TRUE(made) << expression << '\n' << to_text(made.diagnostics);
    return made ? test::ray(*made, 50, 50, 100, 100, time).origin[0] : std::nan("");
}

class ExpressionValue : public testing::TestWithParam<Case> {};

// Folding uses the same functions of the C library as the values here, each correct to one or two
// units in the last place; a handful of steps stays within 1e-14 of the value's size.
TEST_P(ExpressionValue, IsTheTextbooks) {
    const double value = GetParam().value;
    EXPECT_NEAR(value_of(GetParam().expression), value, 1e-14 * std::max(1.0, std::fabs(value)));
}

INSTANTIATE_TEST_SUITE_P(
    All, ExpressionValue,
    testing::Values(
        // Precedence and associativity.
        Case{"1 + 2*3", 7}, Case{"(1 + 2)*3", 9}, Case{"7 - 2 - 1", 4}, Case{"8/4/2", 1},
        Case{"2^3^2", 512}, Case{"-3^2", -9}, Case{"(-3)^2", 9}, Case{"2^-1", 0.5},
        Case{"-2 * -3", 6}, Case{"2*3^2", 18}, Case{"1e-3 * 1e3", 1}, Case{".5 + 1.", 1.5},
        // Conditions.
        Case{"1 < 2", 1}, Case{"2 <= 1", 0}, Case{"2 > 1 && 3 >= 3", 1},
        Case{"1 == 2 || !(1 != 2)", 0}, Case{"1 + 1 == 2 && 2 < 3", 1},
        Case{"if(1 < 2, 10, 20)", 10}, Case{"select(0, 10, 20)", 20}, Case{"if(0 == 0, 5, 1/0)", 5},
        Case{"if(1 == 0, sqrt(-1), 6)", 6},
        // Angles.
        Case{"180deg / 1rad", pi}, Case{"90deg / 30deg", 3}, Case{"sin(30deg)", 0.5},
        Case{"cos(pi)", -1}, Case{"atan2(1, 1) / 1deg", 45}, Case{"acos(0.5) / 1deg", 60},
        Case{"(0 + 30deg) / 1deg", 30}, Case{"tan(pi/8 * 1rad)", std::tan(pi / 8)},
        Case{"max(30deg, 1rad) / 1rad", 1}, Case{"mod(370deg, 360deg) / 1deg", 10},
        // Functions.
        Case{"sqrt(2)", std::sqrt(2.0)}, Case{"exp(1)", std::exp(1.0)},
        Case{"log(10)", std::log(10)}, Case{"pow(2, 0.5)", std::sqrt(2.0)},
        Case{"spow(-8, 1/3)", -2}, Case{"spow(4, 0.5)", 2},
        Case{"abs(-2) + sign(-3) + floor(-0.5)", 0}, Case{"min(1, 2) + max(3, 4)", 5},
        Case{"mod(-1, 3)", 2}, Case{"sinh(1) + cosh(1) - exp(1)", 0}, Case{"asinh(sinh(2))", 2},
        Case{"atanh(tanh(0.5)) + acosh(cosh(2))", 2.5}, Case{"is_finite(1)", 1},
        // Elements of lists and tuples.
        Case{"count([(1, 2), (3, 4), (5, 6)])", 3}, Case{"count((1, 2)) + count([7])", 3},
        Case{"2*count([1, 2, 3]) - [4, 5][count([6])]", 1}));

TEST(Expression, UsesTime) {
    EXPECT_EQ(value_of("2*t + 1", 3.0), 7.0);
    EXPECT_EQ(value_of("if(t < 2, 10, 20)", 1.0), 10.0);
    EXPECT_EQ(value_of("if(t < 2, 10, 20)", 2.0), 20.0);
}

TEST(Expression, EveryOperationOfTheGraphCanBeWritten) {
    for (const expr::Operation& row : expr::operations()) {
        if (row.arity == 0 || row.scalar == nullptr) {
            continue;
        }
        std::string text(row.infix.empty() ? row.name : row.arity == 1 ? row.infix : "");
        text += "(";
        for (int i = 0; i < row.arity; ++i) {
            text += i == 0 ? "" : row.infix.empty() ? ", " : row.infix;
            text += "1.0";
        }
        text += row.name == "atanh" ? "/2)" : ")";
        const bool angle =
            row.name == "asin" || row.name == "acos" || row.name == "atan" || row.name == "atan2";
        value_of(angle ? text + "/1rad" : text);
    }
}

class UnitError : public testing::TestWithParam<const char*> {};

TEST_P(UnitError, IsFound) {
    const Result<camera::Camera> made = camera_at(GetParam());
    ASSERT_FALSE(made);
    EXPECT_EQ(made.diagnostics.size(), 1U) << to_text(made.diagnostics);
}

INSTANTIATE_TEST_SUITE_P(All, UnitError,
                         testing::Values("30deg", "1 + 30deg", "30deg - 1", "30deg*30deg",
                                         "1/30deg", "30deg^2", "2^30deg", "sqrt(30deg)",
                                         "max(1, 30deg)", "1 < 30deg", "if(t < 1, 1, 1deg)",
                                         "asin(30deg)", "atan(1)", "floor(30deg)/1deg"));

class ValueError : public testing::TestWithParam<const char*> {};

TEST_P(ValueError, IsFoundOnce) {
    const Result<camera::Camera> made = camera_at(GetParam());
    ASSERT_FALSE(made);
    EXPECT_EQ(made.diagnostics.size(), 1U) << to_text(made.diagnostics);
}

INSTANTIATE_TEST_SUITE_P(All, ValueError,
                         testing::Values("1/0", "t/0", "1/(1 - 1)", "sqrt(-1) + log(-1)", "log(0)",
                                         "0^-1", "acos(2)/1rad", "exp(1000)", "1e308*10",
                                         "mod(1, 0)", "if(t < 1, 1/0, 2)", "(-8)^(1/3)"));

TEST(Expression, AValueErrorPointsAtTheCause) {
    const Result<camera::Camera> made = camera_at("1 + 2/(3 - 3)");
    ASSERT_EQ(made.diagnostics.size(), 1U);
    const SourceSpan& span = made.diagnostics[0].span;
    EXPECT_EQ(span.source->text().substr(span.begin, span.end - span.begin), "(3 - 3)");
}

}  // namespace
}  // namespace balcony::lang::expression_test
