// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <random>

#include "transform_probe.hpp"

namespace balcony::camera::seed_warps_test {

namespace {

// Solving for some dozen seeds loses two or three digits.
constexpr double tolerance = 1e-12;
constexpr std::array methods{"thin_plate", "inverse_distance"};

// Seeds (place, new place) at random; new places are an affine map of the places and a disturbance.
PointList random_seeds(std::size_t count, std::size_t dimension, double disturbance) {
    std::mt19937_64 engine(11);
    std::uniform_real_distribution<double> part(-2.0, 2.0);
    std::normal_distribution<double> error(0.0, 1.0);
    PointList list{2 * dimension, {}};
    for (std::size_t i = 0; i < count; ++i) {
        std::vector<double> place;
        for (std::size_t k = 0; k < dimension; ++k) {
            place.push_back(part(engine) + 5.0);
        }
        list.values.insert(list.values.end(), place.begin(), place.end());
        for (std::size_t k = 0; k < dimension; ++k) {
            const double affine = 0.3 + 1.2 * place[k] - 0.4 * place[(k + 1) % dimension];
            list.values.push_back(affine + disturbance * error(engine));
        }
    }
    return list;
}

ParameterTransformerPointer seeded(const char* method, const PointList& seeds,
                                   double smoothing = 0.0) {
    return warp(method, {{"seeds", seeds}, {"smoothing", numbers({smoothing})}});
}

// The affine map of least squares, by the normal equations, as its value at (u, v).
std::array<double, 2> affine_fit(const PointList& seeds, double u, double v) {
    std::array<std::array<double, 5>, 3> m{};
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        const std::array row{1.0, seeds[i][0], seeds[i][1]};
        for (std::size_t r = 0; r < 3; ++r) {
            for (std::size_t c = 0; c < 3; ++c) {
                m[r][c] += row[r] * row[c];
            }
            m[r][3] += row[r] * seeds[i][2];
            m[r][4] += row[r] * seeds[i][3];
        }
    }
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t r = 0; r < 3; ++r) {
            const double factor = r == i ? 0.0 : m[r][i] / m[i][i];
            for (std::size_t c = 0; c < 5; ++c) {
                m[r][c] -= factor * m[i][c];
            }
        }
    }
    const auto value = [&](std::size_t c) {
        return m[0][c] / m[0][0] + u * m[1][c] / m[1][1] + v * m[2][c] / m[2][2];
    };
    return {value(3), value(4)};
}

// The mean squared distance of where a warp takes the seeds from where they shall go.
double misfit(const char* method, const PointList& seeds, double smoothing) {
    const auto warp = seeded(method, seeds, smoothing);
    double sum = 0.0;
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        const auto p = warped(warp, seeds[i][0], seeds[i][1]);
        sum += std::pow(p[0] - seeds[i][2], 2) + std::pow(p[1] - seeds[i][3], 2);
    }
    return sum / static_cast<double>(seeds.size());
}

std::string message_of(const char* method, const Given& given) {
    const auto made = try_stage(StageKind::parameter_transformer, method, given);
    EXPECT_FALSE(made);
    return made ? std::string() : made.diagnostics.front().message;
}

}  // namespace

TEST(SeedWarps, GoThroughTheirSeeds) {
    const PointList seeds = random_seeds(32, 2, 0.3);
    for (const char* method : methods) {
        const WarpProbe probe(seeded(method, seeds));
        for (std::size_t i = 0; i < seeds.size(); ++i) {
            const WarpSample s = probe(seeds[i][0], seeds[i][1]);
            EXPECT_TRUE(s.valid);
            EXPECT_NEAR(s.point[0], seeds[i][2], tolerance);
            EXPECT_NEAR(s.point[1], seeds[i][3], tolerance);
            for (const double slope : {s.by_u[0], s.by_u[1], s.by_v[0], s.by_v[1]}) {
                EXPECT_TRUE(std::isfinite(slope));
            }
        }
    }
}

TEST(SeedWarps, GoThroughTheirSeedsInSpaceToo) {
    const PointList seeds = random_seeds(20, 3, 0.3);
    for (const char* method : methods) {
        const auto deform = move(method, {{"seeds", seeds}});
        for (std::size_t i = 0; i < seeds.size(); ++i) {
            const std::span<const double> c = seeds[i];
            expect_near(transformed(deform, {c[0], c[1], c[2]}), {c[3], c[4], c[5]}, tolerance);
        }
    }
}

TEST(ThinPlate, IsTheAffineMapWhereTheSeedsAreOne) {
    const PointList plane = random_seeds(12, 2, 0.0);
    const auto warp = seeded("thin_plate", plane);
    const auto p = warped(warp, 9.0, -3.0);
    EXPECT_NEAR(p[0], 0.3 + 1.2 * 9.0 + 0.4 * 3.0, 10.0 * tolerance);
    EXPECT_NEAR(p[1], 0.3 - 1.2 * 3.0 - 0.4 * 9.0, 10.0 * tolerance);
    const auto deform = move("thin_plate", {{"seeds", random_seeds(12, 3, 0.0)}});
    expect_near(transformed(deform, {1.0, 2.0, 3.0}),
                {0.3 + 1.2 - 0.8, 0.3 + 2.4 - 1.2, 0.3 + 3.6 - 0.4}, 10.0 * tolerance);
}

// Three seeds determine the affine map, without a bend.
TEST(ThinPlate, OfThreeSeedsIsAffine) {
    const WarpProbe probe(
        seeded("thin_plate", points(4, {0, 0, 0.5, 0, 1, 0, 2, 0.3, 0, 1, 0, 1})));
    const WarpSample s = probe(7.0, -5.0);
    EXPECT_NEAR(s.point[0], 0.5 + 7.0 * 1.5 + 5.0 * 0.5, tolerance);
    EXPECT_NEAR(s.point[1], 7.0 * 0.3 - 5.0, tolerance);
}

TEST(ThinPlate, SmoothedEverMoreIsTheAffineFit) {
    const PointList seeds = random_seeds(32, 2, 0.3);
    double distance = 1.0;
    for (const double smoothing : {1e2, 1e4, 1e6}) {
        const auto p = warped(seeded("thin_plate", seeds, smoothing), 4.3, 6.1);
        const auto limit = affine_fit(seeds, 4.3, 6.1);
        const double now = std::hypot(p[0] - limit[0], p[1] - limit[1]);
        EXPECT_LT(now, 0.02 * distance);
        distance = now;
    }
}

TEST(SeedWarps, SmoothingLetsGoOfTheSeedsMoreAndMore) {
    const PointList seeds = random_seeds(32, 2, 0.3);
    for (const char* method : methods) {
        double before = -1.0;
        for (const double smoothing : {0.0, 1e-3, 1e-2, 0.1, 1.0}) {
            const double now = misfit(method, seeds, smoothing);
            EXPECT_GT(now, before) << method;
            before = now;
        }
    }
}

// The kernel's side conditions, as forces and torques of a plate in balance: no net weight, so that
// the bent part falls off far away faster than the kernel grows.
TEST(ThinPlate, IsAlmostAffineFarAway) {
    const WarpProbe probe(seeded("thin_plate", random_seeds(32, 2, 0.3)));
    const auto slope_change = [&](double far) {
        return std::fabs(probe(far, 5.0).by_u[0] - probe(far + 1.0, 5.0).by_u[0]);
    };
    EXPECT_LT(slope_change(1e3), 0.05 * slope_change(1e2));
}

TEST(InverseDistance, IsShepardsFormula) {
    const PointList seeds = random_seeds(9, 2, 0.3);
    for (const double power : {1.5, 2.0, 3.0}) {
        const auto warp = balcony::camera::warp("inverse_distance",
                                                {{"seeds", seeds}, {"power", numbers({power})}});
        double weights = 0.0;
        std::array<double, 2> wanted{};
        for (std::size_t i = 0; i < seeds.size(); ++i) {
            const double weight =
                std::pow(std::hypot(4.3 - seeds[i][0], 5.6 - seeds[i][1]), -power);
            weights += weight;
            wanted[0] += weight * (seeds[i][2] - seeds[i][0]);
            wanted[1] += weight * (seeds[i][3] - seeds[i][1]);
        }
        const auto p = warped(warp, 4.3, 5.6);
        EXPECT_NEAR(p[0], 4.3 + wanted[0] / weights, tolerance);
        EXPECT_NEAR(p[1], 5.6 + wanted[1] / weights, tolerance);
    }
}

// A mean lies between what it is the mean of.
TEST(InverseDistance, NeverMovesFurtherThanItsSeeds) {
    const PointList seeds = random_seeds(9, 2, 0.3);
    double minimum = 1e9;
    double maximum = -1e9;
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        minimum = std::min(minimum, seeds[i][2] - seeds[i][0]);
        maximum = std::max(maximum, seeds[i][2] - seeds[i][0]);
    }
    const auto warp = seeded("inverse_distance", seeds);
    for (double u = 0.0; u < 10.0; u += 0.37) {
        for (double v = 0.0; v < 10.0; v += 0.41) {
            const double moved = warped(warp, u, v)[0] - u;
            EXPECT_GE(moved, minimum - tolerance);
            EXPECT_LE(moved, maximum + tolerance);
        }
    }
}

TEST(SeedWarps, ScaleWithTheirSeeds) {
    PointList small = random_seeds(12, 2, 0.3);
    PointList large = small;
    for (double& value : large.values) {
        value *= 1000.0;
    }
    for (const char* method : methods) {
        for (const double smoothing : {0.0, 0.1}) {
            const auto a = warped(seeded(method, small, smoothing), 4.3, 5.6);
            const auto b = warped(seeded(method, large, smoothing), 4300.0, 5600.0);
            EXPECT_NEAR(b[0], 1000.0 * a[0], 1000.0 * tolerance);
            EXPECT_NEAR(b[1], 1000.0 * a[1], 1000.0 * tolerance);
        }
    }
}

TEST(SeedWarps, NameTwinsAndTakeThemIfSmoothed) {
    const PointList twins = points(4, {0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 0, 1, 1, 0, 2, 0, 3, 3, 3, 3});
    for (const char* method : methods) {
        EXPECT_NE(message_of(method, {{"seeds", twins}}).find("seeds 2 and 4 are both at (1, 0)"),
                  std::string::npos);
        EXPECT_TRUE(try_stage(StageKind::parameter_transformer, method,
                              {{"seeds", twins}, {"smoothing", numbers({0.1})}}));
    }
}

TEST(SeedWarps, ReportErrors) {
    EXPECT_NE(message_of("thin_plate", {{"seeds", points(4, {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 3})}})
                  .find("lie on one line"),
              std::string::npos);
    for (const char* method : methods) {
        EXPECT_NE(message_of(method, {{"seeds", random_seeds(1001, 2, 0.1)}}).find("too many"),
                  std::string::npos);
    }
}

}  // namespace balcony::camera::seed_warps_test
