// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// What constraints miss, by positions where it is plain, and its derivatives by finite differences.

#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "balcony/solve.hpp"
#include "solve/sighting_misses.hpp"

namespace balcony::solve::misses_test {
namespace {

using enum ConstraintKind;

const V2d size(640.0, 360.0);

std::vector<Dual> misses(const Constraint& constraint, const std::vector<V2d>& at) {
    std::vector<DualPoint> points;
    for (std::size_t i = 0; i < at.size(); ++i) {
        points.push_back({Dual::coordinate(at[i].x, 2 * i), Dual::coordinate(at[i].y, 2 * i + 1)});
    }
    return sighting_misses(constraint, points, size);
}

struct Case {
    Constraint constraint;
    std::vector<V2d> at;
    std::vector<double> misses;
};

std::vector<Case> cases() {
    std::vector<Case> made;
    const auto add = [&made](ConstraintKind kind, const V2d& position, double value,
                             const std::vector<V2d>& places, const std::vector<double>& expected) {
        Constraint constraint{kind, {}, position, value};
        for (std::size_t i = 0; i < places.size(); ++i) {
            constraint.marks.push_back(i);
        }
        made.push_back({constraint, places, expected});
    };
    const V2d none(0.0);
    add(at, {100, 50}, 0.0, {{103, 46}}, {3, -4});
    add(together, none, 0.0, {{10, 20}, {13, 18}}, {3, -2});
    add(inside, none, 5.0, {{2, 100}}, {3});
    add(inside, none, 5.0, {{630, 358}}, {3});
    add(inside, none, 5.0, {{-7, 100}}, {12});
    add(inside, none, 5.0, {{300, 100}}, {0});
    add(outside, none, 0.0, {{20, 350}}, {10});
    add(outside, none, 0.0, {{700, 100}}, {0});
    add(straight, none, 0.0, {{0, 0}, {100, 0}, {30, 7}}, {7});
    add(straight, none, 0.0, {{0, 0}, {30, 40}, {3, 4}}, {0});
    add(level, none, 0.0, {{10, 20}, {90, 26}}, {6});
    add(upright, none, 0.0, {{10, 20}, {13, 90}}, {3});
    add(parallel, none, 0.0, {{0, 0}, {50, 5}, {100, 100}, {200, 100}}, {5});
    add(parallel, none, 0.0, {{0, 0}, {-6, -8}, {100, 100}, {103, 104}}, {0});
    add(length, none, 40.0, {{0, 0}, {30, 40}}, {10});
    add(ratio, none, 2.0, {{0, 0}, {30, 40}, {0, 0}, {0, 20}}, {10});
    // The outermost positions of an outline: left, right, top, bottom.
    const std::vector<V2d> outermost{{100, 60}, {180, 50}, {150, 20}, {140, 90}};
    add(left, none, 90.0, outermost, {10});
    add(right, none, 200.0, outermost, {-20});
    add(top, none, 25.0, outermost, {-5});
    add(bottom, none, 80.0, outermost, {10});
    add(wide, none, 90.0, outermost, {-10});
    add(high, none, 60.0, outermost, {10});
    add(within, none, 0.0, outermost, {0, 0, 0, 0});
    add(within, none, 0.0, {{-3, 60}, {650, 50}, {150, -4}, {140, 365}}, {3, 10, 4, 5});
    add(within, none, 0.0, outermost, {10, 0, 0, 30});
    made.back().constraint.corners = {V2d(110, 10), V2d(200, 60)};
    // The farthest positions on the two sides of a line.
    add(touches, none, 0.0, {{100, 60}, {180, 90}}, {10});
    made.back().constraint.corners = {V2d(0, 70), V2d(5, 70)};
    add(touches, none, 0.0, {{100, 60}, {180, 50}}, {-10});
    made.back().constraint.corners = {V2d(0, 70), V2d(-5, 70)};
    return made;
}

}  // namespace

TEST(Misses, AreThoseOfPlainPositions) {
    for (const Case& one : cases()) {
        SCOPED_TRACE(constraint_kinds()[static_cast<std::size_t>(one.constraint.kind)].name);
        const std::vector<Dual> made = misses(one.constraint, one.at);
        ASSERT_EQ(made.size(), one.misses.size());
        for (std::size_t r = 0; r < made.size(); ++r) {
            EXPECT_NEAR(made[r].value, one.misses[r], 1e-12);
        }
    }
}

TEST(Misses, HaveTheirDerivatives) {
    constexpr double h = 1e-5;
    for (const Case& one : cases()) {
        SCOPED_TRACE(constraint_kinds()[static_cast<std::size_t>(one.constraint.kind)].name);
        const std::vector<Dual> made = misses(one.constraint, one.at);
        for (std::size_t k = 0; k < 2 * one.at.size(); ++k) {
            std::vector<V2d> before = one.at;
            std::vector<V2d> after = one.at;
            before[k / 2][static_cast<int>(k % 2)] -= h;
            after[k / 2][static_cast<int>(k % 2)] += h;
            for (std::size_t r = 0; r < made.size(); ++r) {
                const double slope = (misses(one.constraint, after)[r].value -
                                      misses(one.constraint, before)[r].value) /
                                     (2.0 * h);
                EXPECT_NEAR(made[r].by[k], slope, 1e-6) << "coordinate " << k;
            }
        }
    }
}

TEST(Misses, HaveACaseOfEveryKindWithMarks) {
    for (const ConstraintKindInfo& info : constraint_kinds()) {
        std::size_t count = 0;
        for (const Case& one : cases()) {
            count += one.constraint.kind == info.kind ? 1 : 0;
        }
        EXPECT_EQ(count > 0, info.marks > 0 || info.is_of_outline) << info.name;
        EXPECT_EQ(static_cast<std::size_t>(info.kind),
                  static_cast<std::size_t>(&info - constraint_kinds().data()))
            << info.name;
    }
}

}  // namespace balcony::solve::misses_test
