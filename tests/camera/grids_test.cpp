// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <random>

#include "transform_probe.hpp"

namespace balcony::camera::grids_test {

namespace {

// Values of everyday size after some dozen roundings.
constexpr double tolerance = 1e-13;
constexpr std::array bases{"b_spline", "interpolating", "bernstein"};

// The lattice of columns x rows over the box (-1, -0.5) .. (2, 1), v from row to row.
constexpr std::size_t columns = 5;
constexpr std::size_t rows = 4;

std::array<double, 2> place(std::size_t i) {
    return {-1.0 + 3.0 * static_cast<double>(i % columns) / (columns - 1.0),
            -0.5 + 1.5 * static_cast<double>(i / columns) / (rows - 1.0)};
}

PointList regular_lattice() {
    PointList list{2, {}};
    for (std::size_t i = 0; i < columns * rows; ++i) {
        list.values.insert(list.values.end(), {place(i)[0], place(i)[1]});
    }
    return list;
}

PointList random_offsets(std::size_t count, std::size_t coordinates, double size = 0.3) {
    std::mt19937_64 engine(3);
    std::uniform_real_distribution<double> part(-size, size);
    PointList list{coordinates, {}};
    for (std::size_t i = 0; i < coordinates * count; ++i) {
        list.values.push_back(part(engine));
    }
    return list;
}

ParameterTransformerPointer grid(PointList list, const char* given, const char* basis,
                                 double amount = 1.0) {
    return warp("grid", {{"points", std::move(list)},
                         {"columns", numbers({columns})},
                         {"from", numbers({-1.0, -0.5})},
                         {"to", numbers({2.0, 1.0})},
                         {"given", std::string(given)},
                         {"basis", std::string(basis)},
                         {"amount", numbers({amount})}});
}

// The basis functions of a lattice with n points along an axis at s in [0, 1].
double bernstein(std::size_t n, std::size_t i, double s) {
    double binomial = 1.0;
    for (std::size_t k = 0; k < i; ++k) {
        binomial *= static_cast<double>(n - 1 - k) / static_cast<double>(k + 1);
    }
    return binomial * std::pow(s, static_cast<double>(i)) *
           std::pow(1.0 - s, static_cast<double>(n - 1 - i));
}

double cardinal_b_spline(double x) {
    const double a = std::fabs(x);
    return a >= 2.0   ? 0.0
           : a >= 1.0 ? (2.0 - a) * (2.0 - a) * (2.0 - a) / 6.0
                      : 2.0 / 3.0 - a * a + 0.5 * a * a * a;
}

}  // namespace

TEST(ParameterGrid, OfARegularLatticeIsTheIdentity) {
    for (const char* basis : bases) {
        const auto by_positions = grid(regular_lattice(), "positions", basis);
        const auto by_offsets =
            grid(points(2, std::vector<double>(2 * columns * rows, 0.0)), "offsets", basis);
        for (double u = -2.0; u <= 3.0; u += 0.23) {
            for (double v = -1.0; v <= 2.0; v += 0.17) {
                const auto p = warped(by_positions, u, v);
                EXPECT_NEAR(p[0], u, tolerance);
                EXPECT_NEAR(p[1], v, tolerance);
                EXPECT_EQ(warped(by_offsets, u, v), (std::array{u, v}));
            }
        }
    }
}

// What a control lattice must do to be one: an affine map of its points is the same map of all.
TEST(ParameterGrid, OfAnAffineLatticeIsThatMapInTheBox) {
    PointList list{2, {}};
    for (std::size_t i = 0; i < columns * rows; ++i) {
        const auto [u, v] = place(i);
        list.values.insert(list.values.end(), {0.3 + 1.2 * u - 0.4 * v, 0.1 + 0.2 * u + 0.7 * v});
    }
    for (const char* basis : bases) {
        const auto affine = grid(list, "positions", basis);
        for (double u = -1.0; u <= 2.0; u += 0.23) {
            for (double v = -0.5; v <= 1.0; v += 0.17) {
                const auto p = warped(affine, u, v);
                EXPECT_NEAR(p[0], 0.3 + 1.2 * u - 0.4 * v, tolerance);
                EXPECT_NEAR(p[1], 0.1 + 0.2 * u + 0.7 * v, tolerance);
            }
        }
    }
}

TEST(ParameterGrid, InterpolatesOnRequestAndOtherwiseAtItsCorners) {
    const PointList list = random_offsets(columns * rows, 2);
    for (const char* basis : bases) {
        const auto warp = grid(list, "offsets", basis);
        for (std::size_t i = 0; i < columns * rows; ++i) {
            const bool corner = (i % columns == 0 || i % columns == columns - 1) &&
                                (i / columns == 0 || i / columns == rows - 1);
            if (corner || basis == std::string_view("interpolating")) {
                const auto p = warped(warp, place(i)[0], place(i)[1]);
                EXPECT_NEAR(p[0], place(i)[0] + list[i][0], tolerance);
                EXPECT_NEAR(p[1], place(i)[1] + list[i][1], tolerance);
            }
        }
    }
}

TEST(ParameterGrid, IsTheSumOfItsBasisFunctions) {
    const PointList list = random_offsets(columns * rows, 2);
    const auto b_spline = grid(list, "offsets", "b_spline");
    const auto bezier = grid(list, "offsets", "bernstein");
    // Inside the border's cells, where B-splines have all their control points.
    for (double s = 0.26; s < 0.74; s += 0.07) {
        for (double r = 0.34; r < 0.66; r += 0.05) {
            std::array<double, 2> spline{-1.0 + 3.0 * s, -0.5 + 1.5 * r};
            std::array<double, 2> polynomial = spline;
            const auto [u, v] = spline;
            for (std::size_t i = 0; i < columns * rows; ++i) {
                const double column = static_cast<double>(i % columns);
                const double row = static_cast<double>(i / columns);
                const double weight = cardinal_b_spline((columns - 1.0) * s - column) *
                                      cardinal_b_spline((rows - 1.0) * r - row);
                const double other =
                    bernstein(columns, i % columns, s) * bernstein(rows, i / columns, r);
                for (std::size_t k = 0; k < 2; ++k) {
                    spline[k] += weight * list[i][k];
                    polynomial[k] += other * list[i][k];
                }
            }
            EXPECT_NEAR(warped(b_spline, u, v)[0], spline[0], tolerance);
            EXPECT_NEAR(warped(b_spline, u, v)[1], spline[1], tolerance);
            EXPECT_NEAR(warped(bezier, u, v)[0], polynomial[0], tolerance);
            EXPECT_NEAR(warped(bezier, u, v)[1], polynomial[1], tolerance);
        }
    }
}

TEST(ParameterGrid, UsesTheNearestOffsetOutsideItsBox) {
    for (const char* basis : bases) {
        const auto warp = grid(random_offsets(columns * rows, 2), "offsets", basis);
        const auto border = warped(warp, 2.0, 0.3);
        const auto outside = warped(warp, 5.0, 0.3);
        EXPECT_NEAR(outside[0] - 5.0, border[0] - 2.0, tolerance);
        EXPECT_NEAR(outside[1], border[1], tolerance);
        const auto corner = warped(warp, -1.0, 1.0);
        const auto beyond = warped(warp, -4.0, 9.0);
        EXPECT_NEAR(beyond[0] + 4.0, corner[0] + 1.0, tolerance);
        EXPECT_NEAR(beyond[1] - 9.0, corner[1] - 1.0, tolerance);
    }
}

TEST(ParameterGrid, IsSmoothAcrossItsCells) {
    constexpr double h = 1e-9;
    for (const char* basis : bases) {
        const WarpProbe probe(grid(random_offsets(columns * rows, 2), "offsets", basis));
        for (const double knot : {-0.25, 0.5, 1.25}) {
            const WarpSample before = probe(knot - h, 0.2);
            const WarpSample behind = probe(knot + h, 0.2);
            EXPECT_NEAR(before.by_u[0], behind.by_u[0], 1e-7);
            EXPECT_NEAR(before.by_v[1], behind.by_v[1], 1e-7);
        }
    }
}

TEST(ParameterGrid, ItsAmountScalesTheOffsets) {
    const PointList list = random_offsets(columns * rows, 2);
    const auto whole = warped(grid(list, "offsets", "b_spline"), 0.4, 0.1);
    const auto half = warped(grid(list, "offsets", "b_spline", 0.5), 0.4, 0.1);
    EXPECT_NEAR(half[0] - 0.4, 0.5 * (whole[0] - 0.4), tolerance);
    EXPECT_EQ(warped(grid(list, "offsets", "b_spline", 0.0), 0.4, 0.1), (std::array{0.4, 0.1}));
}

// A box given from right to left has its first point on the right.
TEST(ParameterGrid, FollowsItsBoxInEitherSense) {
    PointList list{2, std::vector<double>(2 * columns * rows, 0.0)};
    list.values[0] = 0.5;
    const auto reversed = warp("grid", {{"points", list},
                                        {"columns", numbers({columns})},
                                        {"from", numbers({2.0, 1.0})},
                                        {"to", numbers({-1.0, -0.5})}});
    EXPECT_NEAR(warped(reversed, 2.0, 1.0)[0], 2.5, tolerance);
    EXPECT_NEAR(warped(reversed, -1.0, -0.5)[0], -1.0, tolerance);
}

TEST(ObjectGrid, OfARegularLatticeIsTheIdentity) {
    PointList list{3, {}};
    for (std::size_t i = 0; i < 3 * 4 * 2; ++i) {
        list.values.push_back(static_cast<double>(i % 3) - 1.0);
        list.values.push_back(static_cast<double>(i / 3 % 4) * 2.0 / 3.0 - 1.0);
        list.values.push_back(static_cast<double>(i / 12) * 2.0 - 1.0);
    }
    for (const char* basis : bases) {
        const auto identity = move("grid", {{"points", list},
                                            {"columns", numbers({3.0})},
                                            {"rows", numbers({4.0})},
                                            {"given", std::string("positions")},
                                            {"basis", std::string(basis)}});
        for (const Vector& p : {Vector{0.3, -0.2, 0.7}, {-1.0, 1.0, 0.0}, {3.0, 0.1, -4.0}}) {
            expect_near(transformed(identity, p), p, tolerance);
        }
    }
}

TEST(ObjectGrid, IsTheTrivariateBernsteinSumOfSederbergAndParry) {
    const PointList list = random_offsets(3 * 4 * 2, 3);
    const auto deform = move("grid", {{"points", list},
                                      {"columns", numbers({3.0})},
                                      {"rows", numbers({4.0})},
                                      {"basis", std::string("bernstein")}});
    for (const Vector& p : {Vector{0.3, -0.2, 0.7}, {-0.9, 0.5, -0.4}, {0.1, 0.1, -0.8}}) {
        Vector wanted = p;
        for (std::size_t i = 0; i < list.size(); ++i) {
            const double weight = bernstein(3, i % 3, 0.5 * (p[0] + 1.0)) *
                                  bernstein(4, i / 3 % 4, 0.5 * (p[1] + 1.0)) *
                                  bernstein(2, i / 12, 0.5 * (p[2] + 1.0));
            for (std::size_t k = 0; k < 3; ++k) {
                wanted[k] += weight * list[i][k];
            }
        }
        expect_near(transformed(deform, p), wanted, tolerance);
    }
}

TEST(Grids, ReportErrors) {
    const auto message = [](const Given& given) {
        const auto made = try_stage(StageKind::parameter_transformer, "grid", given);
        EXPECT_FALSE(made);
        return made ? std::string() : made.diagnostics.front().message;
    };
    EXPECT_NE(message({{"points", random_offsets(7, 2)}, {"columns", numbers({3.0})}})
                  .find("7 points do not fill rows of 3"),
              std::string::npos);
    EXPECT_NE(message({{"points", random_offsets(4, 2)}, {"columns", numbers({4.0})}})
                  .find("form only one of the rows"),
              std::string::npos);
    EXPECT_NE(message({{"points", random_offsets(4, 2)}, {"to", numbers({1.0, -1.0})}})
                  .find("no extent along its rows"),
              std::string::npos);
    EXPECT_NE(message({{"points", random_offsets(18, 2)},
                       {"columns", numbers({9.0})},
                       {"basis", std::string("bernstein")}})
                  .find("9 columns"),
              std::string::npos);
    EXPECT_NE(message({{"points", random_offsets(300 * 300, 2)}, {"columns", numbers({300.0})}})
                  .find("too many points"),
              std::string::npos);
}

}  // namespace balcony::camera::grids_test
