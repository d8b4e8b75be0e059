// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// look_at and follow: rigid motions that put a camera somewhere.

#include <functional>
#include <numbers>

#include "support.hpp"

namespace balcony::camera::camera_placements_test {

namespace {

using std::numbers::pi;

// Values of everyday size, rounded a few times.
constexpr double tolerance = 1e-14;

Vector unit(const Vector& a) { return (1.0 / length(a)) * a; }

/// Where a transformer puts the camera, and where its axes point.
struct Placed {
    Vector at, forward, left, up;

    explicit Placed(const ObjectTransformerPointer& transformer)
        : at(transformed(transformer, {0.0, 0.0, 0.0})),
          forward(transformed(transformer, {1.0, 0.0, 0.0}) - at),
          left(transformed(transformer, {0.0, 1.0, 0.0}) - at),
          up(transformed(transformer, {0.0, 0.0, 1.0}) - at) {}
};

void expect_rigid(const Placed& placed) {
    EXPECT_NEAR(length(placed.forward), 1.0, tolerance);
    EXPECT_NEAR(length(placed.left), 1.0, tolerance);
    EXPECT_NEAR(dot(placed.forward, placed.left), 0.0, tolerance);
    expect_near(cross(placed.forward, placed.left), placed.up, tolerance);
}

Placed look_at(const Vector& from, const Vector& target, const Given& others = {}) {
    Given given{{"from", numbers({from[0], from[1], from[2]})},
                {"target", numbers({target[0], target[1], target[2]})}};
    given.insert(others.begin(), others.end());
    return Placed(move("look_at", given));
}

ObjectGeneratorPointer curve(const std::function<std::vector<Expr>(Graph&, Expr)>& build) {
    Arguments arguments;
    arguments.set_formula(
        formula(1, [&](Graph& graph, const std::vector<Expr>& u) { return build(graph, u[0]); }));
    const StageEntry* row = catalogue().find(StageKind::object_generator, "curve");
    return std::static_pointer_cast<const ObjectGenerator>(*row->make(arguments).value);
}

/// From the origin along x, then to the left and upwards.
ObjectGeneratorPointer helix() {
    return curve([](Graph&, Expr u) {
        return std::vector{2.0 * sin(u), 2.0 - 2.0 * cos(u), 0.5 * u};
    });
}

ObjectGeneratorPointer circle(double radius) {
    return object("circle", {{"radius", numbers({radius})}});
}

Placed follow(const ObjectGeneratorPointer& path, double at, Given others = {}) {
    others.emplace("path", path);
    others["at"] = numbers({at});
    return Placed(move("follow", others));
}

std::string error_of(std::string_view name, const Given& given) {
    const auto made = try_stage(StageKind::object_transformer, name, given);
    return made ? "" : made.diagnostics.front().message;
}

}  // namespace

// gluLookAt takes the target to the negative z axis, up into the y-z plane and the right to x: here
// these are the axes x, z and -y.
TEST(LookAt, IsTheInverseOfTheViewMatrix) {
    const Vector from{1.0, -2.0, 3.0};
    const Vector target{-2.0, 4.0, 0.5};
    const Vector f = unit(target - from);
    const Vector s = unit(cross(f, {0.0, 0.0, 1.0}));
    const Vector u = cross(s, f);
    const Placed placed = look_at(from, target);
    expect_near(placed.at, from, tolerance);
    expect_near(placed.forward, f, tolerance);
    expect_near(placed.left, -1.0 * s, tolerance);
    expect_near(placed.up, u, tolerance);
    expect_rigid(placed);
}

TEST(LookAt, StaysUprightAndRollsClockwise) {
    const Placed straight = look_at({3.0, 1.0, 5.0}, {-1.0, 2.0, 0.0});
    EXPECT_NEAR(straight.left[2], 0.0, tolerance);
    EXPECT_GT(straight.up[2], 0.0);
    const double angle = 0.3;
    const Placed rolled = look_at({3.0, 1.0, 5.0}, {-1.0, 2.0, 0.0}, {{"roll", numbers({angle})}});
    expect_near(rolled.forward, straight.forward, tolerance);
    // The top of the camera turns to its right.
    EXPECT_NEAR(dot(rolled.up, straight.up), std::cos(angle), tolerance);
    EXPECT_NEAR(dot(rolled.up, straight.left), -std::sin(angle), tolerance);
    expect_rigid(rolled);
}

TEST(LookAt, ChangesNothingForACameraThatLooksThere) {
    const Placed same =
        look_at({0.0, 0.0, 0.0}, {5.0, 0.0, 0.0}, {{"up", numbers({0.0, 0.3, 1.0})}});
    expect_near(same.forward, {1.0, 0.0, 0.0}, tolerance);
    expect_near(same.left, {0.0, 1.0, 0.0}, tolerance);
    // A camera with y up stays upright in its own axes: y up, z to the right.
    const Placed y_up =
        look_at({0.0, 1.0, 0.0}, {0.0, 1.0, 4.0}, {{"up", numbers({0.0, 1.0, 0.0})}});
    expect_near(y_up.forward, {0.0, 0.0, 1.0}, tolerance);
    expect_near(y_up.left, {0.0, 1.0, 0.0}, tolerance);
    expect_near(y_up.up, {-1.0, 0.0, 0.0}, tolerance);
}

TEST(LookAt, NeedsADirectionThatIsNotUp) {
    const auto fault = [](std::vector<double> target, std::vector<double> up) {
        return error_of("look_at", {{"from", numbers({1.0, 1.0, 1.0})},
                                    {"target", numbers(std::move(target))},
                                    {"up", numbers(std::move(up))}});
    };
    EXPECT_EQ(fault({1.0, 1.0, 1.0}, {0.0, 0.0, 1.0}), "from and target are the same point");
    EXPECT_EQ(fault({1.0, 1.0, 5.0}, {0.0, 0.0, 1.0}),
              "the target is straight along up, so nothing says what is upright");
    EXPECT_EQ(fault({2.0, 3.0, 4.0}, {0.0, 0.0, 0.0}), "up has no direction");
    EXPECT_EQ(fault({2.0, 3.0, 4.0}, {-2.0, 0.0, 0.0}),
              "up is parallel to x, along which the camera looks");
    EXPECT_EQ(fault({2.0, 3.0, 4.0}, {0.0, 0.0, 1.0}), "");
}

TEST(Follow, LooksAlongThePathUpright) {
    for (const double at : {0.0, 0.2, 0.7, 1.0}) {
        const Placed placed = follow(helix(), at, {{"to", numbers({3.0})}});
        const double u = 3.0 * at;
        expect_near(placed.at, {2.0 * std::sin(u), 2.0 - 2.0 * std::cos(u), 0.5 * u}, tolerance);
        expect_near(placed.forward, unit({2.0 * std::cos(u), 2.0 * std::sin(u), 0.5}), tolerance);
        EXPECT_NEAR(placed.left[2], 0.0, tolerance);
        expect_rigid(placed);
        const Placed back =
            follow(helix(), at, {{"to", numbers({3.0})}, {"look", std::string("backward")}});
        expect_near(back.forward, -1.0 * placed.forward, tolerance);
        EXPECT_GT(back.up[2], 0.0);
        const Placed fixed =
            follow(helix(), at, {{"to", numbers({3.0})}, {"look", std::string("fixed")}});
        expect_near(fixed.at, placed.at, tolerance);
        expect_near(fixed.forward, {1.0, 0.0, 0.0}, tolerance);
        expect_near(fixed.up, {0.0, 0.0, 1.0}, tolerance);
    }
}

TEST(Follow, GoesTheOtherWayFromTheEnd) {
    const Placed there = follow(helix(), 0.25, {{"to", numbers({3.0})}});
    const Placed back = follow(helix(), 0.75, {{"from", numbers({3.0})}, {"to", numbers({0.0})}});
    expect_near(back.at, there.at, tolerance);
    expect_near(back.forward, -1.0 * there.forward, tolerance);
}

TEST(Follow, FacesItsTarget) {
    const Vector target{0.5, 7.0, -1.0};
    for (const double at : {0.0, 0.4, 1.0}) {
        const Placed placed =
            follow(helix(), at, {{"to", numbers({3.0})}, {"target", numbers({0.5, 7.0, -1.0})}});
        expect_near(placed.forward, unit(target - placed.at), tolerance);
        EXPECT_NEAR(placed.left[2], 0.0, tolerance);
    }
}

TEST(Follow, EndsAtTheEndsOfAnOpenPathAndGoesOnAlongAClosedOne) {
    const Given way{{"to", numbers({2.0 * pi})}};
    expect_near(follow(helix(), 3.7, way).at, follow(helix(), 1.0, way).at, tolerance);
    expect_near(follow(helix(), -2.0, way).at, follow(helix(), 0.0, way).at, tolerance);
    expect_near(follow(circle(3.0), 2.3, way).at, follow(circle(3.0), 0.3, way).at, 1e-13);
    expect_near(follow(circle(3.0), -0.7, way).at, follow(circle(3.0), 0.3, way).at, 1e-13);
}

// The weight and the centrifugal force of a rider add up along the leaning axis: its tangent is the
// length of the option divided by the radius.
TEST(Follow, LeansIntoBends) {
    const double radius = 4.0;
    const Given way{{"to", numbers({2.0 * pi})}, {"bank", numbers({2.0})}};
    for (const double at : {0.1, 0.6}) {
        const Placed placed = follow(circle(radius), at, way);
        EXPECT_NEAR(placed.up[2], std::cos(std::atan(2.0 / radius)), tolerance);
        // Towards the centre of the circle, which is on the left.
        EXPECT_LT(dot(placed.up, placed.at), 0.0);
        expect_rigid(placed);
        Given reverse = way;
        reverse["from"] = numbers({2.0 * pi});
        reverse["to"] = numbers({0.0});
        EXPECT_LT(dot(follow(circle(radius), at, reverse).up, placed.at), 0.0);
        Given back = way;
        back["look"] = std::string("backward");
        EXPECT_LT(dot(follow(circle(radius), at, back).up, placed.at), 0.0);
    }
}

// A loop in the plane y = 0 passes through directions that are up.
TEST(Follow, GoesThroughALoopWithoutTurningOver) {
    const auto loop = curve([](Graph& graph, Expr u) {
        return std::vector{sin(u), graph.constant(0.0), 1.0 - cos(u)};
    });
    for (const double at : {0.0, 0.25, 0.5, 0.8}) {
        const Placed placed = follow(
            loop, at, {{"to", numbers({2.0 * pi})}, {"frame", std::string("rotation_minimising")}});
        // The frame is off by 1e-6 radians at most.
        expect_near(placed.left, {0.0, 1.0, 0.0}, 1e-5);
        expect_near(placed.up, (Vector{0.0, 0.0, 1.0} - placed.at), 1e-5);
    }
    const auto vertical =
        move("follow", {{"path", loop}, {"at", numbers({0.25})}, {"to", numbers({2.0 * pi})}});
    Graph graph;
    Emitter emit(graph);
    (void)vertical->transform({emit(0.0), emit(0.0), emit(0.0)}, emit);
    EXPECT_EQ(expr::evaluate(std::array{emit.valid()}, {}).front(), 0.0);
}

TEST(Follow, NeedsAWayAndAnUpwardDirection) {
    EXPECT_EQ(error_of("follow", {{"path", helix()}, {"to", numbers({0.0})}}),
              "from and to are equal, so the path is empty");
    EXPECT_EQ(error_of("follow", {{"path", helix()}, {"up", numbers({1.0, 0.0, 0.0})}}),
              "up is parallel to x, along which the camera looks");
}

}  // namespace balcony::camera::camera_placements_test
