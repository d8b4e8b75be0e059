// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <functional>
#include <random>

#include "transform_probe.hpp"

namespace balcony::camera::line_pairs_test {

namespace {

using Pair = std::array<double, 2>;
// Values of everyday size after some dozen roundings.
constexpr double tolerance = 1e-13;

ParameterTransformerPointer field(const PointList& lines, const Given& more = {}) {
    Given given = more;
    given["lines"] = lines;
    return warp("line_pairs", given);
}

// Lines at random with a map of them.
PointList mapped_lines(std::size_t count, const std::function<Pair(Pair)>& map) {
    std::mt19937_64 engine(13);
    std::uniform_real_distribution<double> part(-1.0, 1.0);
    PointList list{8, {}};
    for (std::size_t i = 0; i < count; ++i) {
        const Pair p{part(engine), part(engine)};
        const Pair q{part(engine), part(engine)};
        for (const Pair& end : {p, q, map(p), map(q)}) {
            list.values.insert(list.values.end(), end.begin(), end.end());
        }
    }
    return list;
}

std::vector<Pair> some_points() {
    std::vector<Pair> points;
    for (double u = -1.5; u < 1.6; u += 0.3) {
        for (double v = -1.5; v < 1.6; v += 0.3) {
            points.push_back({u, v});
        }
    }
    return points;
}

void expect_map(const ParameterTransformerPointer& warp, const std::function<Pair(Pair)>& map) {
    for (const Pair& p : some_points()) {
        const Pair found = warped(warp, p[0], p[1]);
        EXPECT_NEAR(found[0], map(p)[0], tolerance);
        EXPECT_NEAR(found[1], map(p)[1], tolerance);
    }
}

}  // namespace

TEST(LinePairs, OfEqualLinesAreTheIdentity) {
    const auto same = [](Pair p) { return p; };
    expect_map(field(mapped_lines(7, same)), same);
}

TEST(LinePairs, ThatAreMovedAlikeTranslate) {
    const auto shift = [](Pair p) { return Pair{p[0] + 0.4, p[1] - 0.7}; };
    expect_map(field(mapped_lines(7, shift)), shift);
}

TEST(LinePairs, ThatAreTurnedAlikeTurn) {
    const auto turn = [](Pair p) {
        return Pair{0.6 * p[0] - 0.8 * p[1] + 0.1, 0.8 * p[0] + 0.6 * p[1]};
    };
    expect_map(field(mapped_lines(7, turn)), turn);
}

// Along a line all is stretched with it, across it distances stay.
TEST(LinePairs, OneAloneStretchesAlongItself) {
    expect_map(field(points(8, {0, 0, 1, 0, 0, 0, 3, 0})), [](Pair p) {
        return Pair{3.0 * p[0], p[1]};
    });
}

TEST(LinePairs, AreTheWeightedMeanOfBeierAndNeely) {
    const PointList lines = points(8, {-0.5, 0, 0.5, 0.2, -0.4, 0.3, 0.6, 0.1,  //
                                       0.1, 0.8, 0.3, 1.4, 0.2, 0.7, 0.9, 1.2});
    const auto warp =
        field(lines, {{"a", numbers({0.05})}, {"b", numbers({1.5})}, {"p", numbers({0.7})}});
    for (const Pair& x : some_points()) {
        Pair sum{};
        double weights = 0.0;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const std::span<const double> c = lines[i];
            const Pair pq{c[2] - c[0], c[3] - c[1]};
            const Pair pq_new{c[6] - c[4], c[7] - c[5]};
            const Pair px{x[0] - c[0], x[1] - c[1]};
            const double size = std::hypot(pq[0], pq[1]);
            const double size_new = std::hypot(pq_new[0], pq_new[1]);
            const double along = (px[0] * pq[0] + px[1] * pq[1]) / (size * size);
            const double aside = (px[1] * pq[0] - px[0] * pq[1]) / size;
            const double distance = along < 0.0   ? std::hypot(px[0], px[1])
                                    : along > 1.0 ? std::hypot(x[0] - c[2], x[1] - c[3])
                                                  : std::fabs(aside);
            const double weight = std::pow(std::pow(size, 0.7) / (0.05 + distance), 1.5);
            weights += weight;
            sum[0] += weight * (c[4] + along * pq_new[0] - aside * pq_new[1] / size_new - x[0]);
            sum[1] += weight * (c[5] + along * pq_new[1] + aside * pq_new[0] / size_new - x[1]);
        }
        const Pair found = warped(warp, x[0], x[1]);
        EXPECT_NEAR(found[0], x[0] + sum[0] / weights, tolerance);
        EXPECT_NEAR(found[1], x[1] + sum[1] / weights, tolerance);
    }
}

TEST(LinePairs, WithASmallAGoWhereTheyShall) {
    const PointList lines = points(8, {-1, -0.5, 1, -0.5, -1, -0.5, 1, -0.5,  //
                                       0, 0, 0.4, 0.3, 0.1, 0.2, 0.5, 0.1});
    const WarpProbe probe(field(lines, {{"a", numbers({1e-6})}}));
    for (const double t : {0.0, 0.25, 0.5, 1.0}) {
        const WarpSample s = probe(0.4 * t, 0.3 * t);
        // The other line, 1e6 times as far off, has a weight of 1e-12 and a pull of 1.
        EXPECT_NEAR(s.point[0], 0.1 + 0.4 * t, 1e-10);
        EXPECT_NEAR(s.point[1], 0.2 - 0.1 * t, 1e-10);
        EXPECT_TRUE(std::isfinite(s.by_u[0]) && std::isfinite(s.by_v[0]));
    }
}

TEST(LinePairs, ReportErrors) {
    const auto message = [](const PointList& lines) {
        const auto made =
            try_stage(StageKind::parameter_transformer, "line_pairs", {{"lines", lines}});
        EXPECT_FALSE(made);
        return made ? std::string() : made.diagnostics.front().message;
    };
    EXPECT_NE(message(points(8, {0, 0, 1, 0, 0, 0, 1, 0, 2, 2, 2, 2, 0, 0, 1, 1})).find("pair 2"),
              std::string::npos);
    EXPECT_NE(message(points(8, {0, 0, 1, 1, 2, 2, 2, 2})).find("pair 1"), std::string::npos);
    EXPECT_NE(message(mapped_lines(1001, [](Pair p) { return p; })).find("too many"),
              std::string::npos);
}

}  // namespace balcony::camera::line_pairs_test
