// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The direction rules of curves: sideways, binormal, principal normal, and outward in the plane of
// the curve.

#include <functional>
#include <numbers>

#include "support.hpp"

namespace balcony::camera::curve_rules_test {

namespace {

using std::numbers::pi;
constexpr double width = 80.0;
constexpr double height = 45.0;
constexpr double tolerance = 1e-12;  // unit directions after some dozen roundings

Camera::Parts seen(const ObjectGeneratorPointer& eye, const DirectionRulePointer& rule,
                   double first = 0.0, double last = 1.0) {
    Camera::Parts parts;
    parts.name = "test";
    parts.eye = {range(first, last, 0.0, 1.0), {}, eye, {}};
    parts.look = rule;
    return parts;
}

DirectionRulePointer outward() { return look("normal", {{"side", std::string("outward")}}); }

void at_columns(const std::function<void(double x)>& check) {
    for (double x = 0.5; x < width; x += 3.0) {
        check(x);
    }
}

ObjectGeneratorPointer helix() {
    return object("helix", {{"radius", numbers({2.0})}, {"pitch", numbers({3.0})}});
}

std::string problems_of(Camera::Parts parts) {
    return to_text(Camera::make(std::move(parts)).diagnostics);
}

/// A wave round a circle, with inflections: c(u) = (1 + 0.2 cos 5u) (cos u, sin u, 0).
class Wave final : public ObjectGenerator {
public:
    int dimension() const override { return 1; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        const Expr r = 1.0 + 0.2 * cos(5.0 * p.u);
        return {r * cos(p.u), r * sin(p.u), emit(0.0)};
    }
};

}  // namespace

TEST(SidewaysRule, IsPerpendicularToTheCurveAndToUp) {
    const GeneratorProbe curve(helix());
    for (const Vector& up : {Vector{0.0, 0.0, 1.0}, Vector{0.3, -2.0, 0.7}}) {
        for (const auto& [side, sign] : {std::pair("left", 1.0), std::pair("right", -1.0)}) {
            const auto rule = look(
                "sideways", {{"side", std::string(side)}, {"up", numbers({up[0], up[1], up[2]})}});
            const CameraProbe rays(camera(seen(helix(), rule, 0.0, 6.0)), width, height);
            at_columns([&, sign = sign](double x) {
                const Ray ray = rays(x, 20.5);
                ASSERT_TRUE(ray.valid);
                const Vector tangent = curve(ray.parameters[0]).along_u;
                EXPECT_NEAR(dot(ray.direction, tangent), 0.0, 4.0 * tolerance);
                EXPECT_NEAR(dot(ray.direction, up), 0.0, 4.0 * tolerance);
                EXPECT_GT(sign * dot(cross(up, tangent), ray.direction), 0.0);
            });
        }
    }
}

// Forward is x and up is z, so that left is y.
TEST(SidewaysRule, HasTheLeftOnTheLeft) {
    const auto line = object("line", {{"along", numbers({1.0, 0.0, 0.0})}});
    const CameraProbe rays(camera(seen(line, look("sideways"))), width, height);
    expect_near(rays(10.5, 10.5).direction, {0.0, 1.0, 0.0}, 0.0);
}

TEST(SidewaysRule, HasNoRayWhereTheCurveGoesStraightUp) {
    const auto line = object("line", {{"along", numbers({0.1, 0.2, 0.7})}});
    const auto rule = look("sideways", {{"up", numbers({0.3, 0.6, 2.1})}});
    const CameraProbe rays(camera(seen(line, rule)), width, height);
    EXPECT_FALSE(rays(10.5, 10.5).valid);
}

TEST(SidewaysRule, NeedsAnUpwardDirection) {
    const auto made =
        try_stage(StageKind::direction_rule, "sideways", {{"up", numbers({0.0, 0.0, 0.0})}});
    ASSERT_FALSE(made);
    EXPECT_FALSE(made.diagnostics.front().remedy.empty());
}

TEST(FrenetRules, AreAnOrthonormalFrameWithTheTangent) {
    for (const ObjectGeneratorPointer& curve :
         {helix(), object("ellipse", {{"a", numbers({3.0})}}), object("catmull_rom")}) {
        const CameraProbe tangents(camera(seen(curve, look("tangent"), 0.1, 0.9)), width, height);
        const CameraProbe normals(camera(seen(curve, look("principal_normal"), 0.1, 0.9)), width,
                                  height);
        const CameraProbe binormals(camera(seen(curve, look("binormal"), 0.1, 0.9)), width, height);
        at_columns([&](double x) {
            const Vector t = tangents(x, 20.5).direction;
            const Vector n = normals(x, 20.5).direction;
            const Vector b = binormals(x, 20.5).direction;
            EXPECT_NEAR(dot(t, n), 0.0, tolerance);
            expect_near(b, cross(t, n), tolerance);
        });
    }
}

// Of the helix (r cos u, r sin u, h u) with h = pitch / 2 pi: N = -(cos u, sin u, 0) and
// B = (h sin u, -h cos u, r) / sqrt(r^2 + h^2).
TEST(FrenetRules, OfAHelixAreThoseOfTheTextbook) {
    const double h = 3.0 / (2.0 * pi);
    const double length = std::hypot(2.0, h);
    for (const auto& [sense, sign] : {std::pair("forward", 1.0), std::pair("backward", -1.0)}) {
        const Given given{{"sense", std::string(sense)}};
        const CameraProbe normals(camera(seen(helix(), look("principal_normal", given), 0.0, 7.0)),
                                  width, height);
        const CameraProbe binormals(camera(seen(helix(), look("binormal", given), 0.0, 7.0)), width,
                                    height);
        at_columns([&, sign = sign](double x) {
            const double u = normals(x, 20.5).parameters[0];
            expect_near(normals(x, 20.5).direction, -sign * Vector{std::cos(u), std::sin(u), 0.0},
                        tolerance);
            expect_near(binormals(x, 20.5).direction,
                        (sign / length) * Vector{h * std::sin(u), -h * std::cos(u), 2.0},
                        tolerance);
        });
    }
}

// At one parameter for the whole picture there is no neighbour to take differences with.
TEST(FrenetRules, DoNotDependOnThePicture) {
    const CameraProbe rays(camera(seen(helix(), look("principal_normal"), 1.0, 1.0)), width,
                           height);
    expect_near(rays(10.5, 10.5).direction, {-std::cos(1.0), -std::sin(1.0), 0.0}, tolerance);
}

TEST(FrenetRules, HaveNoRayOnAStraightLine) {
    const auto straight =
        object("bezier", {{"points", PointList{3, {0, 0, 0, 0.1, 0.2, 0.3, 0.5, 1.0, 1.5}}}});
    for (const char* rule : {"binormal", "principal_normal"}) {
        const CameraProbe rays(camera(seen(straight, look(rule), 0.1, 0.9)), width, height);
        at_columns([&](double x) { EXPECT_FALSE(rays(x, 10.5).valid); });
    }
}

TEST(NormalRule, OutwardOfACurveIsInItsPlaneAndLeavesIt) {
    const auto tilt =
        move("rotate", {{"axis", numbers({1.0, 2.0, -1.0})}, {"angle", numbers({0.7})}});
    const GeneratorProbe probe(std::make_shared<const Wave>());
    for (const auto& [first, last] : {std::pair(-pi, pi), std::pair(pi, -pi)}) {
        Camera::Parts parts = seen(std::make_shared<const Wave>(), outward(), first, last);
        parts.eye.object_transformers = {tilt};
        const CameraProbe rays(camera(parts), width, height);
        parts.look = look("normal", {{"side", std::string("inward")}});
        const CameraProbe inward(camera(parts), width, height);
        at_columns([&](double x) {
            const Ray ray = rays(x, 20.5);
            ASSERT_TRUE(ray.valid);
            const Vector t = probe(ray.parameters[0]).along_u;
            const Vector out{t[1], -t[0], 0.0};
            expect_near(ray.direction, transformed(tilt, (1.0 / length(out)) * out), tolerance);
            expect_near(inward(x, 20.5).direction, -1.0 * ray.direction, 0.0);
        });
    }
}

// An open arc leaves its convex side; the rows of the picture may be along the curve as well.
TEST(NormalRule, OutwardOfAnArcIsItsConvexSide) {
    const auto arc = object("circle", {{"radius", numbers({3.0})}});
    for (const double turn : {0.0, 0.5 * pi, 0.25 * pi}) {
        Camera::Parts parts = seen(arc, outward(), 0.4, 1.1);
        parts.eye.parameter_transformers = {
            warp("rotate", {{"angle", numbers({turn})}, {"at", numbers({0.75, 0.5})}})};
        const CameraProbe rays(camera(parts), width, height);
        at_columns([&](double x) {
            const Ray ray = rays(x, 20.5);
            expect_near(ray.direction, (1.0 / 3.0) * ray.origin, tolerance);
        });
    }
}

TEST(NormalRule, OutwardOfACurveFollowsItsMovesInTime) {
    auto graph = std::make_shared<Graph>();
    const Formula angle(graph, {}, {graph->time()});
    Camera::Parts parts = seen(object("circle"), outward(), -pi, pi);
    Given turn{{"axis", numbers({1.0, 0.0, 0.0})}};
    turn["angle"] = std::vector<Scalar>{Scalar(angle)};
    parts.eye.object_transformers = {move("rotate", turn)};
    const CameraProbe rays(camera(parts), width, height);
    for (const double time : {0.0, 1.0, 2.0, 4.0}) {
        at_columns([&](double x) {
            const Ray ray = rays(x, 20.5, time);
            expect_near(ray.direction, ray.origin, tolerance);
        });
    }
}

TEST(NormalRule, SaysWhatHasNoOutside) {
    const auto line = object("line", {{"along", numbers({1.0, 2.0, 0.5})}});
    EXPECT_NE(problems_of(seen(line, outward())).find("error: a straight line has no outside"),
              std::string::npos);
    const std::string flat = problems_of(seen(object("plane"), outward()));
    EXPECT_NE(flat.find("warning: a flat surface has no outside"), std::string::npos);
    EXPECT_EQ(problems_of(seen(object("circle"), outward(), -3.0, 3.0)), "");
    EXPECT_EQ(problems_of(seen(object("sphere"), outward(), -3.0, 3.0)), "");
}

TEST(NormalRule, HasNoFrontOnACurve) {
    EXPECT_FALSE(Camera::make(seen(object("circle"), look("normal"))));
}

}  // namespace balcony::camera::curve_rules_test
