// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <numbers>

#include "transform_probe.hpp"

namespace balcony::camera::deformations_test {

namespace {

using std::numbers::pi;
// Values of everyday size, rounded a few times.
constexpr double tolerance = 1e-14;

Given along(const std::vector<double>& axis, Given more) {
    more["axis"] = numbers(axis);
    return more;
}

double determinant(const MoveSample& s) { return dot(cross(s.by[0], s.by[1]), s.by[2]); }

const std::vector<double> z_axis{0.0, 0.0, 1.0};
const std::vector<Vector> some_points{
    {0.7, -0.3, 0.2}, {-0.4, 0.9, -0.8}, {0.2, 0.1, 0.95}, {0.5, 0.5, 2.0}, {0.5, 0.5, -3.0}};

ObjectTransformerPointer bend(double angle, double from, double to) {
    return move("bend", along(z_axis, {{"toward", numbers({1.0, 0.0, 0.0})},
                                       {"angle", numbers({angle})},
                                       {"from", numbers({from})},
                                       {"to", numbers({to})}}));
}

}  // namespace

TEST(Twist, TurnsByItsPartOfTheAngle) {
    const auto twist = move("twist", along(z_axis, {{"angle", numbers({pi})}}));
    expect_near(transformed(twist, {1.0, 0.0, 0.0}), {0.0, 1.0, 0.0}, tolerance);
    expect_near(transformed(twist, {1.0, 0.0, 1.0}), {-1.0, 0.0, 1.0}, tolerance);
    expect_near(transformed(twist, {1.0, 0.0, 9.0}), {-1.0, 0.0, 9.0}, tolerance);
    expect_near(transformed(twist, {1.0, 0.0, -9.0}), {1.0, 0.0, -9.0}, tolerance);
}

TEST(Twist, KeepsVolumesAndTheDistanceFromItsAxis) {
    const std::vector<double> axis{1.0, -2.0, 0.5};
    const MoveProbe probe(
        move("twist", along(axis, {{"angle", numbers({1.3})}, {"at", numbers({0.1, 0.2, 0.3})}})));
    for (const Vector& p : some_points) {
        const MoveSample s = probe(p);
        EXPECT_NEAR(determinant(s), 1.0, tolerance);
        const Vector a{axis[0], axis[1], axis[2]};
        const Vector at{0.1, 0.2, 0.3};
        EXPECT_NEAR(length(cross(a, s.point - at)), length(cross(a, p - at)), tolerance * 10.0);
        EXPECT_NEAR(dot(a, s.point - p), 0.0, tolerance);
    }
}

TEST(Taper, ScalesAcrossItsAxisFromOneToItsFactor) {
    const auto taper =
        move("taper",
             along(z_axis,
                   {{"factor", numbers({0.2})}, {"from", numbers({1.0})}, {"to", numbers({3.0})}}));
    expect_near(transformed(taper, {2.0, 1.0, 0.0}), {2.0, 1.0, 0.0}, tolerance);
    expect_near(transformed(taper, {2.0, 1.0, 2.0}), {1.2, 0.6, 2.0}, tolerance);
    expect_near(transformed(taper, {2.0, 1.0, 5.0}), {0.4, 0.2, 5.0}, tolerance);
}

// A column of height pi becomes half a circle of radius 1 about (1, 0).
TEST(Bend, MakesAnArcOfTheAxis) {
    const MoveProbe half(bend(pi, 0.0, pi));
    for (double s = 0.0; s <= pi; s += 0.1) {
        expect_near(half({0.0, 0.3, s}).point, {1.0 - std::cos(s), 0.3, std::sin(s)}, tolerance);
        // Towards the middle of the circle and out from it.
        EXPECT_NEAR(determinant(half({0.4, 0.0, s})), 0.6, tolerance);
    }
    // Straight on behind its end, which now looks down.
    expect_near(half({0.0, 0.0, pi + 1.0}).point, {2.0, 0.0, -1.0}, tolerance);
    expect_near(half({0.2, 0.1, -1.0}).point, {0.2, 0.1, -1.0}, tolerance);
}

// Of the direction that it bends to only what is across the axis counts.
TEST(Bend, TakesASlantingSide) {
    const auto slanting = move("bend", along(z_axis, {{"toward", numbers({2.0, 0.0, 3.0})},
                                                      {"angle", numbers({1.2})},
                                                      {"from", numbers({-1.0})},
                                                      {"to", numbers({1.0})}}));
    for (const Vector& p : some_points) {
        expect_near(transformed(slanting, p), transformed(bend(1.2, -1.0, 1.0), p), tolerance);
    }
}

// Behind its end it goes straight on, also where it ends below its beginning.
TEST(Bend, WorksDownwardsToo) {
    const auto down = bend(pi, 0.0, -pi);
    expect_near(transformed(down, {0.2, 0.1, 1.0}), {0.2, 0.1, 1.0}, tolerance);
    const Vector end = transformed(down, {0.0, 0.0, -pi});
    EXPECT_NEAR(length(transformed(down, {0.0, 0.0, -pi - 1.0}) - end), 1.0, tolerance);
    EXPECT_NEAR(length(end), 2.0, tolerance) << "half a circle of radius 1";
}

TEST(Bend, ByNoAngleIsTheIdentity) {
    for (const Vector& p : some_points) {
        // Straight is a curvature of 1e-12.
        expect_near(transformed(bend(0.0, -1.0, 1.0), p), p, 1e-11);
    }
}

TEST(Bend, ByAnAngleAndBackAgainIsNear) {
    const Scalar growing(formula(
        0, [](Graph& graph, const std::vector<Expr>&) { return std::vector{graph.time() * 0.5}; }));
    const MoveProbe probe(move("bend", along(z_axis, {{"toward", numbers({1.0, 0.0, 0.0})},
                                                      {"angle", std::vector{growing}}})));
    for (const Vector& p : some_points) {
        expect_near(probe(p, 0.0).point, p, 1e-11);
        // Odd in the angle to first order.
        const Vector up = probe(p, 1e-4).point - p;
        const Vector down = probe(p, -1e-4).point - p;
        expect_near(up, -1.0 * down, 1e-7);
        EXPECT_GT(length(up) + length(p), 1e-6);
    }
}

TEST(Deformations, DoNotJumpWhereTheyEnd) {
    for (const char* name : {"twist", "taper", "bend"}) {
        const MoveProbe probe(move(name, along(z_axis, {{"toward", numbers({0.0, 1.0, 0.0})}})));
        for (const double end : {-1.0, 1.0}) {
            expect_near(probe({0.5, 0.3, end - 1e-9}).point, probe({0.5, 0.3, end + 1e-9}).point,
                        1e-8);
        }
    }
}

TEST(Deformations, ReportErrors) {
    const auto message = [](const char* name, const Given& given) {
        const auto made = try_stage(StageKind::object_transformer, name, given);
        EXPECT_FALSE(made);
        return made ? std::string() : made.diagnostics.front().message;
    };
    const Given flat{{"from", numbers({1.0})}, {"to", numbers({1.0})}};
    const Given null{{"axis", numbers({0.0, 0.0, 0.0})}};
    for (const char* name : {"twist", "taper", "bend"}) {
        EXPECT_NE(message(name, flat).find("same height"), std::string::npos);
        EXPECT_NE(message(name, null).find("is not a direction"), std::string::npos);
    }
    EXPECT_NE(message("bend", along(z_axis, {{"toward", numbers({0.0, 0.0, -2.0})}}))
                  .find("is parallel to the axis"),
              std::string::npos);
}

}  // namespace balcony::camera::deformations_test
