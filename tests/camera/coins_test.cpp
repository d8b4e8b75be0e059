// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <random>

#include "transform_probe.hpp"

namespace balcony::camera::coins_test {

namespace {

// Values of everyday size, rounded a few times.
constexpr double tolerance = 1e-14;
const Vector center{2.0, 0.5, -0.3};
constexpr std::array fall_offs{"gaussian", "inverse", "linear", "smooth"};

ObjectTransformerPointer coin(const char* fall_off, double strength, double radius = 0.8) {
    return move("coin", {{"at", numbers({center.begin(), center.end()})},
                         {"strength", numbers({strength})},
                         {"radius", numbers({radius})},
                         {"fall_off", std::string(fall_off)}});
}

std::vector<Vector> some_points() {
    std::mt19937_64 engine(7);
    std::uniform_real_distribution<double> part(-0.7, 0.7);
    std::vector<Vector> points;
    for (int i = 0; i < 100; ++i) {
        points.push_back({2.0 + part(engine), part(engine), part(engine)});
    }
    return points;
}

double textbook(std::string_view fall_off, double q) {
    return fall_off == "gaussian"  ? std::exp(-q)
           : fall_off == "inverse" ? 1.0 / (1.0 + q)
           : fall_off == "linear"  ? std::max(0.0, 1.0 - std::sqrt(q))
                                   : std::pow(std::max(0.0, 1.0 - q), 3);
}

}  // namespace

TEST(Coin, MovesByStrengthTimesFallOffOfTheWay) {
    for (const char* fall_off : fall_offs) {
        const MoveProbe probe(coin(fall_off, 0.6));
        for (const Vector& p : some_points()) {
            const Vector way = center - p;
            const double part = 0.6 * textbook(fall_off, dot(way, way) / (0.8 * 0.8));
            expect_near(probe(p).point - p, part * way, tolerance);
        }
    }
}

TEST(Coin, OfNoStrengthIsTheIdentity) {
    for (const char* fall_off : fall_offs) {
        for (const Vector& p : some_points()) {
            expect_near(transformed(coin(fall_off, 0.0), p), p, 0.0);
        }
    }
}

TEST(Coin, EnlargesAsItSaysAndNeverFolds) {
    for (const char* fall_off : fall_offs) {
        for (const double strength : {0.3, 0.99}) {
            const MoveProbe probe(coin(fall_off, strength));
            double before = -1.0;
            for (double distance = 0.0; distance < 3.0; distance += 0.01) {
                const Vector p{center[0], center[1] + distance, center[2]};
                const double after = probe(p).point[1] - center[1];
                EXPECT_GT(after, before);
                EXPECT_LE(after, distance + tolerance);
                before = after;
            }
            // A linear fall-off begins 1e-12 radii from the centre.
            const MoveSample at = probe(center);
            for (const std::size_t i : {0U, 1U, 2U}) {
                EXPECT_NEAR(at.by[i][i], 1.0 - strength, 2e-12);
            }
        }
    }
}

TEST(Coin, EndsAtItsRadiusIfItsFallOffDoes) {
    for (const char* fall_off : {"linear", "smooth"}) {
        const MoveProbe probe(coin(fall_off, 0.9));
        const Vector outside{center[0] + 0.81, center[1], center[2]};
        expect_near(probe(outside).point, outside, 0.0);
        const Vector inside{center[0] + 0.79, center[1], center[2]};
        EXPECT_LT(probe(inside).point[0], inside[0]);
    }
}

TEST(Coins, OneOfThemIsACoin) {
    const auto one = move("coins", {{"points", points(3, {2.0, 0.5, -0.3})},
                                    {"strength", numbers({0.6})},
                                    {"radius", numbers({0.8})}});
    const auto own = move("coins", {{"points", points(5, {2.0, 0.5, -0.3, 0.6, 0.8})}});
    // A coin without strength beside it leaves it as it is.
    const auto beside =
        move("coins", {{"points", points(5, {2.0, 0.5, -0.3, 0.6, 0.8, 2.0, 0.0, 0.0, 0.0, 1.0})}});
    for (const Vector& p : some_points()) {
        const Vector wanted = transformed(coin("gaussian", 0.6), p);
        expect_near(transformed(one, p), wanted, tolerance);
        expect_near(transformed(own, p), wanted, tolerance);
        expect_near(transformed(beside, p), wanted, tolerance);
    }
}

TEST(Coins, DoNotDependOnTheirOrder) {
    const auto ab = move("coins", {{"points", points(5, {2, 0.5, 0, 0.9, 1, 2, -0.5, 0, 0.4, 2})}});
    const auto ba = move("coins", {{"points", points(5, {2, -0.5, 0, 0.4, 2, 2, 0.5, 0, 0.9, 1})}});
    for (const Vector& p : some_points()) {
        expect_near(transformed(ab, p), transformed(ba, p), tolerance);
    }
}

// With centres in a plane, all on one side of a point: it comes nearer to the plane and never
// through it, however many pull.
TEST(Coins, NeverPullPastTheirCentres) {
    const auto many =
        move("coins", {{"points", points(3, {2, 0, 0, 2, 0.1, 0, 2, 0, 0.1, 2, 1, 1})},
                       {"strength", numbers({0.99})},
                       {"radius", numbers({5.0})}});
    for (const Vector& p : some_points()) {
        const double before = p[0] - 2.0;
        const double after = transformed(many, p)[0] - 2.0;
        EXPECT_GT(after * before, 0.0);
        EXPECT_LT(std::fabs(after), std::fabs(before));
    }
}

TEST(Coins, HaveStrengthsAndRadiiInRange) {
    const auto message = [](double strength, double radius) {
        const auto made =
            try_stage(StageKind::object_transformer, "coins",
                      {{"points", points(5, {0, 0, 0, 0.5, 1, 1, 0, 0, strength, radius})}});
        EXPECT_FALSE(made);
        return made ? std::string() : made.diagnostics.front().message;
    };
    EXPECT_NE(message(1.5, 1.0).find("coin 2 has strength 1.5"), std::string::npos);
    EXPECT_NE(message(0.5, 0.0).find("coin 2 has radius 0"), std::string::npos);
}

}  // namespace balcony::camera::coins_test
