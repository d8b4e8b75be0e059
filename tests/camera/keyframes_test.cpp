// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Values between keyframes, against their definitions.

#include "balcony/keyframes.hpp"

#include <cmath>
#include <random>

#include "support.hpp"

namespace balcony::camera::keyframes_test {

namespace {

/// One value at keys, as a function of time.
class Curve {
public:
    Curve(std::vector<double> times, const std::vector<double>& values, Ease ease,
          BeyondKeys beyond = BeyondKeys::constant) {
        Keyframes keys{std::move(times), {{}}, ease, beyond};
        for (const double value : values) {
            keys.values.front().push_back(graph_.constant(value));
        }
        value_ = between_keys(keys, graph_.time()).front();
        slope_ = expr::differentiate(value_, graph_.time());
    }
    double operator()(double time) const { return at(value_, time); }
    [[nodiscard]] double slope(double time) const { return at(slope_, time); }
    [[nodiscard]] std::size_t nodes() const { return graph_.size(); }

private:
    static double at(expr::Expr e, double time) {
        return expr::evaluate(std::array{e}, {.time = time}).front();
    }
    expr::Graph graph_;
    expr::Expr value_, slope_;
};

/// Some keys, at uneven times: few for a formula, many for tables.
struct Keys {
    std::vector<double> times, values;

    explicit Keys(std::size_t count) {
        std::mt19937_64 random(count);
        std::uniform_real_distribution<double> number(0.2, 1.0);
        double time = -1.7;
        for (std::size_t i = 0; i < count; ++i) {
            times.push_back(time);
            values.push_back(4.0 * number(random) - 2.0);
            time += number(random);
        }
    }
};

constexpr std::array<std::size_t, 2> counts = {6, 60};

class EachEase : public testing::TestWithParam<Named<Ease>> {};

}  // namespace

// The sum of a value and a rise cancels by rounding alone.
constexpr double rounding = 1e-14;

TEST_P(EachEase, MeetsTheKeysAndStaysBeyondThem) {
    for (const std::size_t count : counts) {
        const Keys keys(count);
        const Curve curve(keys.times, keys.values, GetParam().value);
        for (std::size_t i = 0; i < count; ++i) {
            EXPECT_NEAR(curve(keys.times[i]), keys.values[i], rounding) << i;
        }
        EXPECT_NEAR(curve(keys.times.front() - 10.0), keys.values.front(), rounding);
        EXPECT_NEAR(curve(keys.times.back() + 10.0), keys.values.back(), rounding);
        EXPECT_EQ(curve.slope(keys.times.back() + 10.0), 0.0);
    }
}

TEST_P(EachEase, IsContinuousAndHasItsSlope) {
    if (GetParam().value == Ease::hold) {
        return;
    }
    for (const std::size_t count : counts) {
        const Keys keys(count);
        const Curve curve(keys.times, keys.values, GetParam().value);
        constexpr double h = 1e-6;
        for (std::size_t i = 0; i + 1 < count; ++i) {
            EXPECT_NEAR(curve(keys.times[i] - h), curve(keys.times[i] + h), 1e-3) << i;
            const double t = std::lerp(keys.times[i], keys.times[i + 1], 0.37);
            const double difference = (curve(t + h) - curve(t - h)) / (2.0 * h);
            // The third derivative of an ease is below 1e5 over a cell of 0.2.
            EXPECT_NEAR(curve.slope(t), difference, 1e-6 * (1.0 + std::fabs(difference)));
        }
    }
}

// A few keys are a formula and many are tables; both mean the same.
TEST_P(EachEase, IsTheSameAsFormulaAndAsTables) {
    const Keys keys(60);
    const Curve tables(keys.times, keys.values, GetParam().value);
    // The slopes at a key depend on its neighbours only.
    constexpr std::ptrdiff_t first = 20;
    constexpr std::ptrdiff_t last = 32;
    const auto part = [](const std::vector<double>& all) {
        return std::vector<double>(all.begin() + first, all.begin() + last);
    };
    const Curve formula(part(keys.times), part(keys.values), GetParam().value);
    for (double t = keys.times[first + 1]; t < keys.times[last - 2]; t += 0.01) {
        EXPECT_NEAR(tables(t), formula(t), 1e-13) << t;
    }
}

TEST_P(EachEase, RepeatsAndMirrors) {
    const bool is_cubic = GetParam().value == Ease::spline || GetParam().value == Ease::catmull_rom;
    for (const std::size_t count : counts) {
        Keys keys(count);
        const double length = keys.times.back() - keys.times.front();
        const Curve once(keys.times, keys.values, GetParam().value, BeyondKeys::constant);
        const Curve repeated(keys.times, keys.values, GetParam().value, BeyondKeys::repeat);
        const Curve mirrored(keys.times, keys.values, GetParam().value, BeyondKeys::mirror);
        for (double s = 0.013; s < 1.0; s += 0.1) {
            const double t = keys.times.front() + s * length;
            const double back = keys.times.back() + (1.0 - s) * length;
            // The time differs by rounding, and the curve has slopes below 1000.
            EXPECT_NEAR(mirrored(t), once(t), 1e-10);
            if (!is_cubic) {  // A cubic that repeats is not at rest at its ends.
                EXPECT_NEAR(repeated(t), once(t), 1e-10);
            }
            EXPECT_NEAR(repeated(t), repeated(t + 3.0 * length), 1e-10);
            EXPECT_NEAR(repeated(t), repeated(t - 2.0 * length), 1e-10);
            EXPECT_NEAR(mirrored(t), mirrored(back), 1e-10);
            EXPECT_NEAR(mirrored(t), mirrored(t - 2.0 * length), 1e-10);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, EachEase, testing::ValuesIn(eases().begin(), eases().end()),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(Keyframes, HaveTheFormulasOfTheirEases) {
    const auto ease = [](Ease which, double s) {
        return Curve({10.0, 14.0}, {100.0, 102.0}, which)(10.0 + 4.0 * s) / 2.0 - 50.0;
    };
    for (double s = 0.05; s < 1.0; s += 0.1) {
        const double r = 1.0 - s;
        EXPECT_NEAR(ease(Ease::linear, s), s, 1e-13);
        EXPECT_NEAR(ease(Ease::hold, s), 0.0, 1e-13);
        EXPECT_NEAR(ease(Ease::smooth, s), 3 * s * s - 2 * s * s * s, 1e-13);
        EXPECT_NEAR(ease(Ease::smoother, s),
                    10 * std::pow(s, 3) - 15 * std::pow(s, 4) + 6 * std::pow(s, 5), 1e-13);
        EXPECT_NEAR(ease(Ease::ease_in, s), s * s, 1e-13);
        EXPECT_NEAR(ease(Ease::ease_out, s), 1 - r * r, 1e-13);
        EXPECT_NEAR(ease(Ease::ease_in_out, s), s < 0.5 ? 2 * s * s : 1 - 2 * r * r, 1e-13);
        // Of two keys, both cubics are at rest at the ends.
        EXPECT_NEAR(ease(Ease::spline, s), 3 * s * s - 2 * s * s * s, 1e-13);
        EXPECT_NEAR(ease(Ease::catmull_rom, s), 3 * s * s - 2 * s * s * s, 1e-13);
    }
    double highest = 0.0;
    for (double s = 0.0; s < 1.0; s += 0.001) {
        highest = std::max(highest, ease(Ease::overshoot, s));
        EXPECT_LE(ease(Ease::bounce, s), 1.0 + 1e-13);
    }
    EXPECT_NEAR(highest, 1.1, 1e-4);
    for (const double contact : {4.0 / 11.0, 8.0 / 11.0, 10.0 / 11.0}) {
        EXPECT_NEAR(ease(Ease::bounce, contact), 1.0, 1e-13);
    }
}

TEST(Keyframes, ASplineStaysBetweenItsKeysAndKeepsItsDirection) {
    for (const std::size_t count : counts) {
        const Keys keys(count);
        const Curve curve(keys.times, keys.values, Ease::spline);
        bool overshoots = false;
        const Curve other(keys.times, keys.values, Ease::catmull_rom);
        for (std::size_t i = 0; i + 1 < count; ++i) {
            const double sign = keys.values[i + 1] < keys.values[i] ? -1.0 : 1.0;
            const auto [low, high] = std::minmax(keys.values[i], keys.values[i + 1]);
            for (double s = 0.01; s < 1.0; s += 0.01) {
                const double t = std::lerp(keys.times[i], keys.times[i + 1], s);
                EXPECT_GE(sign * curve.slope(t), -1e-12);
                overshoots = overshoots || other(t) < low || other(t) > high;
            }
        }
        EXPECT_TRUE(overshoots);
    }
}

// In contrast to eases of one cell each, a cubic keeps its speed at a key on its way.
TEST(Keyframes, ACubicHasOneSlopeAtAKey) {
    for (const Ease ease : {Ease::spline, Ease::catmull_rom}) {
        const Curve curve({0.0, 1.0, 3.0, 4.0}, {0.0, 1.0, 2.0, 5.0}, ease);
        constexpr double h = 1e-7;
        for (const double key : {1.0, 3.0}) {
            EXPECT_GT(curve.slope(key), 0.4);
            EXPECT_NEAR(curve.slope(key - h), curve.slope(key + h), 1e-5);
        }
    }
    // One that repeats goes on with its speed.
    const Curve turning({0.0, 1.0, 2.0}, {0.0, 1.0, 0.0}, Ease::catmull_rom, BeyondKeys::repeat);
    EXPECT_NEAR(turning.slope(2.0 - 1e-7), turning.slope(2.0 + 1e-7), 1e-5);
}

// A film's frame at the time of a key shows the key, however the times are written.
TEST(Keyframes, ASteppedValueChangesExactlyAtItsKeys) {
    for (const std::size_t count : {std::size_t{12}, std::size_t{120}}) {
        std::vector<double> times, values;
        for (std::size_t i = 0; i < count; ++i) {
            times.push_back(static_cast<double>(i) / 24.0);
            values.push_back(static_cast<double>(i) * 0.1);
        }
        const Curve curve(times, values, Ease::hold);
        for (std::size_t i = 0; i < count; ++i) {
            EXPECT_EQ(curve(times[i]), values[i]) << i;
            EXPECT_EQ(curve(std::nextafter(times[i], -100.0)), values[i > 0 ? i - 1 : 0]) << i;
        }
    }
}

TEST(Keyframes, OfAnyNumberCostTheSame) {
    const Keys some(100);
    const Keys many(3000);
    const Curve a(some.times, some.values, Ease::smooth);
    const Curve b(many.times, many.values, Ease::smooth);
    // The graph also holds the constants of each key.
    EXPECT_LT(a.nodes(), 500U);
    EXPECT_LT(b.nodes(), 3000U + 500U);
}

TEST(Keyframes, MayChangeThemselves) {
    expr::Graph graph;
    const expr::Expr u = graph.variable(0);
    const Keyframes keys{{0.0, 1.0, 2.0}, {{u, 2.0 * u, -u}}, Ease::spline, BeyondKeys::constant};
    const expr::Expr value = between_keys(keys, graph.time()).front();
    const Curve fixed({0.0, 1.0, 2.0}, {3.0, 6.0, -3.0}, Ease::spline);
    for (double t = -0.5; t < 2.5; t += 0.1) {
        const std::array u_is{3.0};
        EXPECT_NEAR(expr::evaluate(std::array{value}, {.time = t, .variables = u_is}).front(),
                    fixed(t), 1e-13);
    }
}

}  // namespace balcony::camera::keyframes_test
