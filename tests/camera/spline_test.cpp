// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Splines as piecewise polynomials, against their textbook definitions.

#include "camera/curves/spline.hpp"

#include <random>

#include "camera/tables/cell_position.hpp"
#include "support.hpp"

namespace balcony::camera::spline_test {

namespace {

using Random = std::mt19937_64;

std::vector<double> random_values(Random& random, std::size_t count) {
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    std::vector<double> values(count);
    for (double& value : values) {
        value = number(random);
    }
    return values;
}

/// The derivative of an order of a cell's polynomial, by the spline's parameter.
double derivative(const Spline& spline, std::span<const double> coefficients, std::size_t cell,
                  double r, int order) {
    const double width = spline.breaks()[cell + 1] - spline.breaks()[cell];
    double sum = 0.0;
    for (std::size_t power = static_cast<std::size_t>(order); power <= spline.degree(); ++power) {
        double factor = coefficients[cell * (spline.degree() + 1) + power];
        for (int k = 0; k < order; ++k) {
            factor *= static_cast<double>(power) - k;
        }
        sum += factor * std::pow(r, static_cast<double>(power) - order);
    }
    return sum / std::pow(width, order);
}

/// The basis function N[i, degree] by the recursion of Cox and de Boor.
double basis(std::span<const double> knots, std::size_t i, std::size_t degree, double t) {
    if (degree == 0) {
        return knots[i] <= t && t < knots[i + 1] ? 1.0 : 0.0;
    }
    double sum = 0.0;
    if (knots[i + degree] > knots[i]) {
        sum += (t - knots[i]) / (knots[i + degree] - knots[i]) * basis(knots, i, degree - 1, t);
    }
    if (knots[i + degree + 1] > knots[i + 1]) {
        sum += (knots[i + degree + 1] - t) / (knots[i + degree + 1] - knots[i + 1]) *
               basis(knots, i + 1, degree - 1, t);
    }
    return sum;
}

SplinePointer bspline(std::size_t points, std::size_t degree, SplineEnds ends,
                      std::span<const double> knots = {}) {
    const Result<SplinePointer> made = make_bspline(points, degree, ends, knots);
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return *made;
}

constexpr std::array all_ends{SplineEnds::clamped, SplineEnds::open, SplineEnds::closed};

}  // namespace

TEST(BSpline, IsTheSumOfCoxAndDeBoorsBasisForAnyKnots) {
    Random random(1);
    for (int i = 0; i < 200; ++i) {
        const std::size_t degree = 1 + random() % 7;
        const std::size_t points = degree + 1 + random() % 6;
        // Knots at random, some of them double.
        std::vector<double> knots{0.0};
        while (knots.size() < points + degree + 1) {
            const bool again = degree > 1 && random() % 3 == 0 && knots.size() > 1 &&
                               knots.back() > knots[knots.size() - 2];
            knots.push_back(knots.back() +
                            (again ? 0.0 : 0.2 + static_cast<double>(random() % 100) / 100.0));
        }
        if (knots[degree] == knots[points]) {
            continue;
        }
        const std::vector<double> values = random_values(random, points);
        const SplinePointer spline = bspline(points, degree, SplineEnds::clamped, knots);
        const std::vector<double> c = spline->coefficients(values);
        ASSERT_EQ(c.size(), spline->cells() * (degree + 1));
        for (std::size_t cell = 0; cell < spline->cells(); ++cell) {
            for (const double r : {0.0, 0.3, 0.9}) {
                const auto& b = spline->breaks();
                const double t = knots[degree] + (b[cell] + r * (b[cell + 1] - b[cell])) *
                                                     (knots[points] - knots[degree]);
                // At a break rounding may put t in the cell before; there the curve is continuous.
                double sum = 0.0;
                for (std::size_t k = 0; k < points; ++k) {
                    sum += values[k] * basis(knots, k, degree, t);
                }
                // Powers of r from differences of Bernstein coefficients: up to 2^7 times 35
                // roundings of values of size 1.
                EXPECT_NEAR(derivative(*spline, c, cell, r, 0), sum, 1e-12);
            }
        }
    }
}

TEST(BSpline, OfEqualValuesIsThatValue) {
    for (const SplineEnds ends : all_ends) {
        for (std::size_t degree = 1; degree <= 7; ++degree) {
            const std::vector<double> ones(degree + 4, 1.0);
            const SplinePointer spline = bspline(ones.size(), degree, ends);
            const std::vector<double> c = spline->coefficients(ones);
            for (std::size_t i = 0; i < c.size(); ++i) {
                EXPECT_NEAR(c[i], i % (degree + 1) == 0 ? 1.0 : 0.0, 1e-13);
            }
        }
    }
}

TEST(BSpline, OfSingleKnotsHasOneDerivativeLessThanItsDegree) {
    Random random(2);
    for (const SplineEnds ends : all_ends) {
        for (std::size_t degree = 1; degree <= 7; ++degree) {
            const std::vector<double> values = random_values(random, degree + 5);
            const SplinePointer spline = bspline(values.size(), degree, ends);
            const std::vector<double> c = spline->coefficients(values);
            const std::size_t cells = spline->cells();
            for (std::size_t cell = 0; cell < cells; ++cell) {
                if (cell + 1 == cells && ends != SplineEnds::closed) {
                    break;
                }
                for (int order = 0; order < static_cast<int>(degree); ++order) {
                    const double here = derivative(*spline, c, cell, 1.0, order);
                    const double next = derivative(*spline, c, (cell + 1) % cells, 0.0, order);
                    // Each derivative by u is up to twice the degree times the cells larger.
                    const double scale = std::pow(2.0 * static_cast<double>(degree * cells), order);
                    EXPECT_NEAR(here, next, 1e-13 * scale) << degree << ' ' << order;
                }
            }
        }
    }
}

TEST(BSpline, TouchesItsEndPointsIfClamped) {
    Random random(3);
    for (std::size_t degree = 1; degree <= 7; ++degree) {
        const std::vector<double> values = random_values(random, degree + 3);
        const SplinePointer spline = bspline(values.size(), degree, SplineEnds::clamped);
        const std::vector<double> c = spline->coefficients(values);
        EXPECT_NEAR(derivative(*spline, c, 0, 0.0, 0), values.front(), 1e-14);
        EXPECT_NEAR(derivative(*spline, c, spline->cells() - 1, 1.0, 0), values.back(), 1e-12);
    }
}

TEST(BSpline, SaysWhatIsWrongWithItsKnots) {
    const auto said = [](std::size_t points, std::size_t degree, SplineEnds ends,
                         std::vector<double> knots) {
        const auto made = make_bspline(points, degree, ends, knots);
        return made ? std::string() : to_text(made.diagnostics);
    };
    using enum SplineEnds;
    EXPECT_NE(said(3, 3, clamped, {}).find("needs at least 4 points"), std::string::npos);
    EXPECT_NE(said(3, 2, clamped, {0, 1, 2}).find("need 6 knots, not 3"), std::string::npos);
    EXPECT_NE(said(3, 2, clamped, {0, 0, 2, 1, 3, 3}).find("not decrease"), std::string::npos);
    EXPECT_NE(said(5, 2, clamped, {0, 0, 0, 1, 1, 1, 2, 2}).find("break"), std::string::npos);
    EXPECT_NE(said(3, 2, clamped, {0, 0, 0, 0, 1, 1}).find("break"), std::string::npos);
    EXPECT_NE(said(3, 2, closed, {0, 0, 0, 1, 1, 1}).find("equally spaced"), std::string::npos);
    EXPECT_EQ(said(3, 2, clamped, {0, 0, 0, 1, 1, 1}), "");
}

TEST(Bezier, IsTheSumOfBernsteinPolynomialsPieceByPiece) {
    Random random(4);
    for (std::size_t degree = 1; degree <= 7; ++degree) {
        for (const bool closed : {false, true}) {
            const std::size_t pieces = 3;
            const std::vector<double> values =
                random_values(random, degree * pieces + (closed ? 0 : 1));
            const Result<SplinePointer> spline = make_bezier(values.size(), degree, closed);
            ASSERT_TRUE(spline);
            ASSERT_EQ((*spline)->cells(), pieces);
            const std::vector<double> c = (*spline)->coefficients(values);
            for (std::size_t piece = 0; piece < pieces; ++piece) {
                for (const double r : {0.0, 0.4, 1.0}) {
                    double sum = 0.0;
                    double binomial = 1.0;
                    for (std::size_t i = 0; i <= degree; ++i) {
                        sum += binomial * std::pow(r, static_cast<double>(i)) *
                               std::pow(1.0 - r, static_cast<double>(degree - i)) *
                               values[(piece * degree + i) % values.size()];
                        binomial *= static_cast<double>(degree - i) / static_cast<double>(i + 1);
                    }
                    EXPECT_NEAR(derivative(**spline, c, piece, r, 0), sum, 1e-13);
                }
            }
        }
    }
    EXPECT_FALSE(make_bezier(5, 3, false));
    EXPECT_FALSE(make_bezier(4, 3, true));
}

TEST(Interpolating, PassesItsValuesWithTheContinuityItStates) {
    Random random(5);
    for (const Interpolation kind : {Interpolation::natural, Interpolation::catmull_rom}) {
        for (const bool closed : {false, true}) {
            const std::vector<double> breaks{0.0, 0.1, 0.25, 0.3, 0.6, 0.85, 1.0};
            const std::vector<double> values = random_values(random, closed ? 6 : 7);
            const InterpolatingSpline spline(kind, breaks, closed);
            const std::vector<double> c = spline.coefficients(values);
            for (std::size_t cell = 0; cell < 6; ++cell) {
                EXPECT_NEAR(derivative(spline, c, cell, 0.0, 0), values[cell], 1e-14);
                EXPECT_NEAR(derivative(spline, c, cell, 1.0, 0), values[(cell + 1) % values.size()],
                            1e-14);
                if (cell == 5 && !closed) {
                    break;
                }
                const int continuous = kind == Interpolation::natural ? 2 : 1;
                for (int order = 1; order <= continuous; ++order) {
                    // Cells of a twentieth: second derivatives of some thousand.
                    EXPECT_NEAR(derivative(spline, c, cell, 1.0, order),
                                derivative(spline, c, (cell + 1) % 6, 0.0, order), 1e-10);
                }
            }
            if (!closed && kind == Interpolation::natural) {
                EXPECT_NEAR(derivative(spline, c, 0, 0.0, 2), 0.0, 1e-10);
                EXPECT_NEAR(derivative(spline, c, 5, 1.0, 2), 0.0, 1e-10);
            }
        }
    }
}

// Both reproduce what the slopes of their ends leave them free to: a parabola, and a straight line.
TEST(Interpolating, ReproducesPolynomials) {
    const std::vector<double> breaks{0.0, 0.2, 0.3, 0.7, 1.0};
    std::vector<double> parabola;
    std::vector<double> line;
    for (const double b : breaks) {
        parabola.push_back(2.0 - 3.0 * b + 4.0 * b * b);
        line.push_back(1.0 - 2.0 * b);
    }
    const InterpolatingSpline catmull_rom(Interpolation::catmull_rom, breaks, false);
    const InterpolatingSpline natural(Interpolation::natural, breaks, false);
    const std::vector<double> c = catmull_rom.coefficients(parabola);
    const std::vector<double> n = natural.coefficients(line);
    const std::vector<double> given = natural.coefficients(parabola, {-3.0, 5.0});
    for (std::size_t cell = 0; cell < 4; ++cell) {
        for (const double r : {0.0, 0.3, 0.8}) {
            const double b = breaks[cell] + r * (breaks[cell + 1] - breaks[cell]);
            EXPECT_NEAR(derivative(catmull_rom, c, cell, r, 0), 2.0 - 3.0 * b + 4.0 * b * b, 1e-14);
            EXPECT_NEAR(derivative(natural, given, cell, r, 0), 2.0 - 3.0 * b + 4.0 * b * b, 1e-14);
            EXPECT_NEAR(derivative(natural, n, cell, r, 0), 1.0 - 2.0 * b, 1e-14);
        }
    }
}

TEST(CellPosition, IsTheCellAndTheFractionOfIt) {
    Random random(6);
    for (int i = 0; i < 60; ++i) {
        std::vector<double> breaks{0.0};
        const std::size_t cells = 1 + random() % 40;
        while (breaks.size() <= cells) {
            const double step =
                random() % 4 == 0 ? 0.01 : 0.25 * static_cast<double>(1 + random() % 8);
            breaks.push_back(breaks.back() + step);
        }
        const double whole = breaks.back();
        for (double& b : breaks) {
            b /= whole;
        }
        Graph graph;
        Emitter emit(graph);
        const Expr u = graph.picture_x();
        const Expr position = CellPosition(breaks, false)(u, emit);
        const std::array roots{position, expr::differentiate(position, u), emit.valid()};
        const auto expect = [&](std::size_t cell, double r) {
            const double width = breaks[cell + 1] - breaks[cell];
            const double at = breaks[cell] + r * width;
            const std::vector<double> found = expr::evaluate(roots, {at, 0.0, 0.0, {}});
            // A rounding of u, which is up to 1, in a cell of a ten-thousandth.
            EXPECT_NEAR(found[0], static_cast<double>(cell) + r, 1e-11);
            if (0.0 < r && r < 1.0) {
                EXPECT_NEAR(found[1] * width, 1.0, 1e-11);
            }
            EXPECT_EQ(found[2], 1.0);
        };
        for (std::size_t cell = 0; cell < cells; ++cell) {
            for (const double r : {0.0, 1e-6, 0.4, 1.0 - 1e-6, 1.0}) {
                if (breaks[cell] + r * (breaks[cell + 1] - breaks[cell]) <= 1.0) {
                    expect(cell, r);
                }
            }
        }
        EXPECT_EQ(expr::evaluate(roots, {1.001, 0.0, 0.0, {}})[2], 0.0);
        EXPECT_EQ(expr::evaluate(roots, {-0.001, 0.0, 0.0, {}})[2], 0.0);
    }
}

}  // namespace balcony::camera::spline_test
