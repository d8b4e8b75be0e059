// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Tables in one, two and three variables, of all degrees.

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "balcony/expr.hpp"

namespace balcony::expr::table_axes_test {

namespace {

using Random = std::mt19937_64;
using Place = std::array<double, Table::max_axes>;

/// The sum of c[i, j, k] x^i y^j z^k; variables that are not there have degree 0.
struct Polynomial {
    std::array<std::size_t, 3> degrees{};
    std::vector<double> coefficients;  ///< Last variable fastest.

    [[nodiscard]] double operator()(const Place& at) const {
        double sum = 0.0;
        std::size_t n = 0;
        for (std::size_t i = 0; i <= degrees[0]; ++i) {
            for (std::size_t j = 0; j <= degrees[1]; ++j) {
                for (std::size_t k = 0; k <= degrees[2]; ++k) {
                    sum += coefficients[n++] * std::pow(at[0], static_cast<double>(i)) *
                           std::pow(at[1], static_cast<double>(j)) *
                           std::pow(at[2], static_cast<double>(k));
                }
            }
        }
        return sum;
    }

    /// As a polynomial in r, where the variable of an axis is start + width r.
    void substitute(std::size_t axis, double start, double width) {
        std::size_t run = 1;
        for (std::size_t i = axis + 1; i < 3; ++i) {
            run *= degrees[i] + 1;
        }
        const std::size_t count = degrees[axis] + 1;
        for (std::size_t block = 0; block < coefficients.size(); block += count * run) {
            for (std::size_t i = 0; i < run; ++i) {
                double* c = coefficients.data() + block + i;
                // Horner's rule on the polynomial (start + r) in place of the variable, ...
                for (std::size_t done = 0; done + 1 < count; ++done) {
                    for (std::size_t power = count - 1; power-- > done;) {
                        c[power * run] += start * c[(power + 1) * run];
                    }
                }
                // ... then r stretched.
                for (std::size_t power = 0; power < count; ++power) {
                    c[power * run] *= std::pow(width, static_cast<double>(power));
                }
            }
        }
    }
};

struct Case {
    Polynomial polynomial;
    Table table;
};

// A polynomial at random and the table of it over a box at random.
Case random_case(Random& random, std::size_t axes) {
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    Case made;
    std::size_t count = 1;
    std::array<Table::Axis, 3> box;
    for (std::size_t axis = 0; axis < axes; ++axis) {
        const std::size_t degree = random() % (Table::max_degree + 1);
        const double first = number(random);
        box[axis] = {first, first + 0.5 + std::fabs(number(random)), 1 + random() % 5, degree};
        made.polynomial.degrees[axis] = degree;
        count *= degree + 1;
    }
    for (std::size_t i = 0; i < count; ++i) {
        made.polynomial.coefficients.push_back(number(random));
    }
    made.table.axes.assign(box.begin(), box.begin() + static_cast<std::ptrdiff_t>(axes));
    std::array<std::size_t, 3> cell{};
    for (cell[0] = 0; cell[0] < box[0].cells; ++cell[0]) {
        for (cell[1] = 0; cell[1] < box[1].cells; ++cell[1]) {
            for (cell[2] = 0; cell[2] < box[2].cells; ++cell[2]) {
                Polynomial local = made.polynomial;
                for (std::size_t axis = 0; axis < axes; ++axis) {
                    const double width =
                        (box[axis].last - box[axis].first) / static_cast<double>(box[axis].cells);
                    local.substitute(
                        axis, box[axis].first + width * static_cast<double>(cell[axis]), width);
                }
                made.table.coefficients.insert(made.table.coefficients.end(),
                                               local.coefficients.begin(),
                                               local.coefficients.end());
            }
        }
    }
    return made;
}

// A point in the box or a tenth of it outside.
Place random_place(Random& random, const Table& table) {
    std::uniform_real_distribution<double> fraction(-0.1, 1.1);
    Place place{};
    for (std::size_t axis = 0; axis < table.axes.size(); ++axis) {
        const Table::Axis& along = table.axes[axis];
        place[axis] = along.first + (along.last - along.first) * fraction(random);
    }
    return place;
}

double at(const Table& table, const Place& place) {
    return table(std::span(place).first(table.axes.size()));
}

}  // namespace

TEST(TableAxes, AreExactOnPolynomialsOfAllDegrees) {
    Random random(1);
    for (int i = 0; i < 300; ++i) {
        const Case made = random_case(random, 1 + static_cast<std::size_t>(i) % 3);
        for (int k = 0; k < 20; ++k) {
            const Place place = random_place(random, made.table);
            // Up to 512 terms of size 2.6^7 at most for each axis, each off by some roundings.
            double scale = 1.0;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                scale *= std::pow(1.0 + std::fabs(place[axis]),
                                  static_cast<double>(made.polynomial.degrees[axis]));
            }
            EXPECT_NEAR(at(made.table, place), made.polynomial(place), 1e-13 * scale);
        }
    }
}

TEST(TableAxes, TheDerivativeAlongEachIsTheNeighbourDifference) {
    Random random(2);
    for (int i = 0; i < 300; ++i) {
        const Case made = random_case(random, 1 + static_cast<std::size_t>(i) % 3);
        for (std::size_t axis = 0; axis < made.table.axes.size(); ++axis) {
            const Table slopes = made.table.derivative(axis);
            const Place place = random_place(random, made.table);
            // Central differences of fourth order; the step is far below a cell, and the
            // polynomial goes on across the border of a cell.
            constexpr double h = 1e-3;
            const auto value = [&](double steps) {
                Place moved = place;
                moved[axis] += steps * h;
                return at(made.table, moved);
            };
            const double difference =
                (8.0 * (value(1.0) - value(-1.0)) - (value(2.0) - value(-2.0))) / (12.0 * h);
            double scale = 1.0;
            for (std::size_t k = 0; k < 3; ++k) {
                scale *= std::pow(1.0 + std::fabs(place[k]),
                                  static_cast<double>(made.polynomial.degrees[k]));
            }
            // The fifth derivative, 2520 times the scale at most, times h^4 / 30.
            EXPECT_NEAR(at(slopes, place), difference, 3e-10 * scale);
        }
    }
}

TEST(TableAxes, MixedDerivativesDoNotDependOnTheirOrder) {
    Random random(3);
    for (int i = 0; i < 100; ++i) {
        const Case made = random_case(random, 3);
        const Table a = made.table.derivative(0).derivative(2);
        const Table b = made.table.derivative(2).derivative(0);
        ASSERT_EQ(a.coefficients.size(), b.coefficients.size());
        for (std::size_t k = 0; k < a.coefficients.size(); ++k) {
            // Two products by whole numbers and scales, in another order.
            EXPECT_NEAR(a.coefficients[k], b.coefficients[k], 1e-15 * std::fabs(a.coefficients[k]));
        }
    }
}

TEST(TableAxes, StayUndefinedWhereAnyArgumentIs) {
    Random random(4);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (int i = 0; i < 60; ++i) {
        Case made = random_case(random, 2 + static_cast<std::size_t>(i) % 2);
        for (std::size_t axis = 0; axis < made.table.axes.size(); ++axis) {
            if (made.table.axes[axis].degree == 0) {
                continue;  // Constant along the axis: the table does not look at its place there.
            }
            Place place = random_place(random, made.table);
            place[axis] = nan;
            EXPECT_TRUE(std::isnan(at(made.table, place)));
        }
    }
}

TEST(LookupOfSeveral, IsOneNodeATableAndItsArguments) {
    Graph graph;
    Random random(5);
    for (std::size_t axes = 1; axes <= 3; ++axes) {
        const auto table = std::make_shared<const Table>(random_case(random, axes).table);
        const std::array xyt{graph.picture_x(), graph.picture_y(), graph.time()};
        const std::array xxt{graph.picture_x(), graph.picture_x(), graph.time()};
        const std::array tyx{graph.time(), graph.picture_y(), graph.picture_x()};
        const Expr one = graph.lookup(table, std::span(xyt).first(axes));
        EXPECT_TRUE(one.same(graph.lookup(table, std::span(xyt).first(axes))));
        EXPECT_EQ(one.same(graph.lookup(table, std::span(xxt).first(axes))), axes == 1);
        EXPECT_FALSE(one.same(graph.lookup(table, std::span(tyx).first(axes))));
        EXPECT_TRUE(simplify(std::span(&one, 1))[0].same(one));
        const Place place{0.3, -0.2, 0.7};
        EXPECT_EQ(evaluate(std::span(&one, 1), {place[0], place[1], place[2], {}})[0],
                  at(*table, place));
        const std::array constants{graph.constant(0.3), graph.constant(-0.2), graph.constant(0.7)};
        EXPECT_TRUE(
            graph.lookup(table, std::span(constants).first(axes)).is_constant(at(*table, place)));
    }
}

// The chain rule, over arguments of which each depends on the leaf.
TEST(LookupOfSeveral, HasTheDerivativeOfItsTableTimesTheInnerSlopes) {
    Graph graph;
    Random random(6);
    for (int i = 0; i < 60; ++i) {
        const std::size_t axes = 1 + static_cast<std::size_t>(i) % 3;
        const Case made = random_case(random, axes);
        const auto table = std::make_shared<const Table>(made.table);
        const Expr x = graph.picture_x();
        const std::array inner{0.5 * sin(x), x * x - 0.25, 0.1 + 0.3 * x};
        const Expr value = graph.lookup(table, std::span(inner).first(axes));
        const Expr slope = differentiate(value, x);
        for (const double place : {-0.4, 0.1, 0.6}) {
            constexpr double h = 1e-4;
            const auto composed = [&](double steps) {
                const double s = place + steps * h;
                return made.polynomial({0.5 * std::sin(s), s * s - 0.25, 0.1 + 0.3 * s});
            };
            const double difference =
                (8.0 * (composed(1.0) - composed(-1.0)) - (composed(2.0) - composed(-2.0))) /
                (12.0 * h);
            // Values up to 512, rounded, over the step; the fifth derivative times h^4 is less.
            EXPECT_NEAR(evaluate(std::span(&slope, 1), {place, 0.0, 0.0, {}})[0], difference, 2e-9);
        }
    }
}

TEST(LookupOfSeveral, IsBroughtIntoAnotherGraphWithItsTable) {
    Graph source;
    Graph target;
    Random random(7);
    const Case made = random_case(random, 3);
    const std::array free{source.variable(0), source.variable(1), source.variable(2)};
    const Expr formula = source.lookup(std::make_shared<const Table>(made.table), free);
    const std::array put{Substitution{free[0], target.picture_x()},
                         Substitution{free[1], 2.0 * target.picture_x()},
                         Substitution{free[2], target.time()}};
    const std::vector<Expr> there = substitute(target, std::span(&formula, 1), put);
    EXPECT_EQ(evaluate(there, {0.2, 0.0, -0.1, {}})[0], at(made.table, {0.2, 0.4, -0.1}));
}

}  // namespace balcony::expr::table_axes_test
