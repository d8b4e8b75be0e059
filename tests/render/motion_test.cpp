// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Pictures of moving scenes against the formulas of their blur.

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "balcony/motion.hpp"
#include "shading/lights/light_set.hpp"
#include "support.hpp"

namespace balcony::render::test::motion_test {

namespace {

using std::numbers::pi;

// A Fibonacci number of passes: the moments of the passes are then nearly equal steps. Any part of
// the exposure has the right number of them but for less than two.
constexpr std::size_t passes = 233;
constexpr double moments = 2.0 / passes;

/// Where a node is at the keys 0 and 1, in seconds.
struct Turned {
    V3d from{0.0}, to{0.0};               ///< Translation.
    double from_angle = 0, to_angle = 0;  ///< About `axis`.
    V3d axis{0.0, 0.0, 1.0};
};

/// Lets the last instance of a scene move, from where it is.
void set_in_motion(scene::Scene& scene, const Turned& turned) {
    auto motion = std::make_shared<scene::Motion>();
    const auto numbers = [](const V3d& v) {
        return std::vector<float>{static_cast<float>(v.x), static_cast<float>(v.y),
                                  static_cast<float>(v.z)};
    };
    scene::Track moves{scene::Interpolation::linear, 3, {0.0, 1.0}, numbers(turned.from)};
    const std::vector<float> to = numbers(turned.to);
    moves.values.insert(moves.values.end(), to.begin(), to.end());
    scene::Track turns{scene::Interpolation::linear, 4, {0.0, 1.0}, {}};
    for (const double angle : {turned.from_angle, turned.to_angle}) {
        const std::vector<float> axis = numbers(turned.axis * std::sin(0.5 * angle));
        turns.values.insert(turns.values.end(), axis.begin(), axis.end());
        turns.values.push_back(static_cast<float>(std::cos(0.5 * angle)));
    }
    motion->tracks = {moves, turns};
    scene::Node node;
    node.world_from_parent = scene.instances.back().world_from_mesh;
    node.translation_track = scene::TrackIndex(0);
    node.rotation_track = scene::TrackIndex(1);
    motion->nodes = {node};
    motion->instances = {{scene.instances.size() - 1, scene::NodeIndex(0)}};
    motion->animations = {{"test", 1.0, 2}};
    scene.motion = std::move(motion);
}

/// A picture with the shutter open from 0 to 1 seconds.
Film exposed(scene::Scene scene, const camera::Picture& camera, Request request,
             ShutterShape shape = ShutterShape::box) {
    request.time = 0.5;
    request.shutter = {1.0, shape};
    const Result<Renderer> renderer =
        Renderer::make(at_time(scene, request.time),
                       RendererSettings{.interval = request.shutter.exposure(request.time)});
    EXPECT_TRUE(renderer) << to_text(renderer.diagnostics);
    Result<Film> film = make_film(request.layout);
    const Result<Summary> summary = render::render(*renderer, camera, request, *film);
    EXPECT_TRUE(summary && summary.diagnostics.empty()) << to_text(summary.diagnostics);
    return std::move(*film);
}

double red(const Film& film, std::size_t x, std::size_t y = 0) {
    return static_cast<double>(film.pixel(x, y).r);
}

/// The part of a shutter's light that comes before a part of the exposure.
double before(ShutterShape shape, double part) {
    const double s = std::clamp(part, 0.0, 1.0);
    if (shape == ShutterShape::box) {
        return s;
    }
    if (s > 0.5) {
        return 1.0 - before(shape, 1.0 - s);
    }
    return s < 0.25 ? 8.0 / 3.0 * s * s : 1.0 / 6.0 + 4.0 / 3.0 * (s - 0.25);
}

/// A strip across a picture of one row, which the pixel filter does not leave.
scene::Mesh bar(float z, float half_width) {
    return parallelogram({-half_width, -9.0F, z}, {2.0F * half_width, 0.0F, 0.0F},
                         {0.0F, 18.0F, 0.0F});
}

/// The picture's x of the middle of a pixel, from -1 to 1.
double across(std::size_t x, std::size_t width) {
    return 2.0 * (static_cast<double>(x) + 0.5) / static_cast<double>(width) - 1.0;
}

constexpr std::size_t wide = 512;
// The filter reaches 1.5 pixels to both sides, and no light changes faster than by 4/3 per unit.
constexpr double filter = 1.5 * 2.0 / wide * 4.0 / 3.0;

Request strip(std::string integrator = "preview") {
    Request made = request(wide, 1, std::move(integrator), passes);
    return made;
}

}  // namespace

// A square of width 1/2 that moves by 1: a point of its way is covered while the square passes.
TEST(Motion, TranslationBlursByTheShutter) {
    for (const ShutterShape shape : {ShutterShape::box, ShutterShape::trapezoid}) {
        scene::Scene scene;
        add(scene, bar(0.0F, 0.25F), white());
        set_in_motion(scene, {{-0.5, 0, 0}, {0.5, 0, 0}});
        const Film film = exposed(scene, orthographic(view_down_z(0, 0, 2)), strip(), shape);
        for (std::size_t x = 0; x < wide; ++x) {
            // The middle of the square is at s - 1/2.
            const double at = across(x, wide) + 0.5;
            const double expected = before(shape, at + 0.25) - before(shape, at - 0.25);
            ASSERT_NEAR(red(film, x), expected, moments + filter)
                << shutter_shapes()[shape].name << ' ' << x;
        }
    }
}

// A wedge that turns about its tip: a point is covered while the wedge passes its direction.
TEST(Motion, RotationFollowsTheArc) {
    constexpr double half_wedge = 0.2;
    constexpr double turn = 1.2;
    scene::Scene scene;
    scene::Mesh wedge;
    const auto reach = static_cast<float>(1.2 * std::tan(half_wedge));
    wedge.positions = {{0, 0, 0}, {1.2F, -reach, 0}, {1.2F, reach, 0}};
    wedge.normals.assign(3, {0, 0, 1});
    wedge.triangles = {{0, 1, 2}};
    add(scene, wedge, white());
    Turned turned;
    turned.from_angle = -turn;
    turned.to_angle = turn;
    set_in_motion(scene, turned);
    constexpr std::size_t side = 128;
    const Film film =
        exposed(scene, orthographic(view_down_z(0, 0, 2)), request(side, side, "preview", passes));
    std::size_t seen = 0;
    for (std::size_t y = 0; y < side; ++y) {
        for (std::size_t x = 0; x < side; ++x) {
            const double px = across(x, side);
            const double py = -across(y, side);
            const double radius = std::hypot(px, py);
            const double angle = std::atan2(py, px);
            if (radius < 0.5 || radius > 0.95) {
                continue;
            }
            ++seen;
            const double first = std::clamp(angle - half_wedge, -turn, turn);
            const double last = std::clamp(angle + half_wedge, -turn, turn);
            const double pixel = 1.5 * 2.0 / side / radius;  // In radians.
            ASSERT_NEAR(red(film, x, y), (last - first) / (2.0 * turn),
                        moments + pixel / (2.0 * turn) + scene::step_error)
                << x << ' ' << y;
        }
    }
    EXPECT_GT(seen, 1000U);
}

// A wall that turns about the vertical axis is seen at cos(angle), by its normal at each time.
TEST(Motion, NormalsTurn) {
    scene::Scene scene;
    add(scene, wall(0.0F, 9.0F), white());
    constexpr double turn = 1.0;
    set_in_motion(scene, {V3d(0.0), V3d(0.0), -turn, turn, {0.0, 1.0, 0.0}});
    const Film film = exposed(scene, orthographic(view_down_z(0, 0, 5)), strip());
    EXPECT_NEAR(red(film, wide / 2), std::sin(turn) / turn, moments);
}

// The shadow of a square between a lamp and a wall, seen from behind the square.
TEST(Motion, ShadowsMove) {
    scene::Scene scene;
    scene::Light lamp;
    lamp.kind = scene::LightKind::directional;
    lamp.intensity = scene::Color3f(static_cast<float>(pi));
    scene.lights = {lamp};
    scene::Material rough = white();
    rough.metallic = 0.0F;
    add(scene, wall(0.0F, 9.0F), rough);
    add(scene, bar(2.0F, 0.25F), white());
    set_in_motion(scene, {{-0.5, 0, 0}, {0.5, 0, 0}});
    const Film film = exposed(scene, orthographic(view_down_z(0, 0, 1)), strip("direct"));
    const double lit = red(film, 0);
    EXPECT_GT(lit, 0.5);
    for (std::size_t x = 0; x < wide; ++x) {
        const double at = across(x, wide) + 0.5;
        const double shadow =
            before(ShutterShape::box, at + 0.25) - before(ShutterShape::box, at - 0.25);
        ASSERT_NEAR(red(film, x) / lit, 1.0 - shadow, moments + filter) << x;
    }
}

// Shared meshes are placed by matrices, and those that Embree cannot invert are copied.
TEST(Motion, AllWaysToPlaceAMeshMove) {
    for (const double shrink : {1.0, 1e-7}) {
        scene::Scene scene;
        scene::M44d small;
        small.setScale(shrink);
        scene::Mesh mesh = bar(0.0F, static_cast<float>(0.25 / shrink));
        for (V3f& position : mesh.positions) {
            position.y /= static_cast<float>(shrink);
        }
        add(scene, mesh, white(), small);
        scene::M44d aside = small;
        aside[3][0] = 50.0;
        scene.instances.insert(scene.instances.begin(), {scene::MeshIndex(0), aside, 0});
        set_in_motion(scene, {{-0.5 / shrink, 0, 0}, {0.5 / shrink, 0, 0}});
        const Film film = exposed(scene, orthographic(view_down_z(0, 0, 2)), strip());
        EXPECT_NEAR(red(film, wide / 2), 0.5, moments + filter) << shrink;
        EXPECT_NEAR(red(film, wide / 4), 0.25, moments + filter) << shrink;
        EXPECT_EQ(red(film, 8), 0.0) << shrink;
    }
}

// A morph target that moves the bar of TranslationBlursByTheShutter.
TEST(Motion, ShapesBlur) {
    scene::Scene scene;
    add(scene, bar(0.0F, 0.25F), white());
    auto motion = std::make_shared<scene::Motion>();
    motion->tracks = {{scene::Interpolation::linear, 1, {0.0, 1.0}, {-0.5F, 0.5F}}};
    scene::Deformation deformation;
    deformation.mesh = scene::MeshIndex(0);
    deformation.positions = scene.meshes[0]->positions;
    deformation.normals = scene.meshes[0]->normals;
    deformation.targets = {{std::vector<V3f>(4, V3f(1.0F, 0.0F, 0.0F)), {}}};
    deformation.weights = {0.0F};
    deformation.weights_track = scene::TrackIndex(0);
    motion->deformations = {deformation};
    scene.motion = std::move(motion);
    const Film film = exposed(scene, orthographic(view_down_z(0, 0, 2)), strip());
    for (std::size_t x = 0; x < wide; ++x) {
        const double at = across(x, wide) + 0.5;
        const double expected =
            before(ShutterShape::box, at + 0.25) - before(ShutterShape::box, at - 0.25);
        ASSERT_NEAR(red(film, x), expected, moments + filter) << x;
    }
}

// A wall that leans to the left and then to the right, by its corners or, while it moves in its
// plane, by their normals.
TEST(Motion, NormalsOfShapesTurn) {
    for (const bool by_normals : {false, true}) {
        scene::Scene scene;
        scene::Mesh mesh = wall(0.0F, 9.0F);
        mesh.normals.assign(by_normals ? 4 : 0, V3f(0.0F, 0.0F, 1.0F));
        std::vector<V3f> moves;
        for (const V3f& position : mesh.positions) {
            moves.push_back(by_normals ? V3f(0.0F, 1.0F, 0.0F) : V3f(0.0F, 0.0F, position.x));
        }
        add(scene, mesh, white());
        auto motion = std::make_shared<scene::Motion>();
        motion->tracks = {{scene::Interpolation::linear, 1, {0.0, 1.0}, {-1.0F, 1.0F}}};
        scene::Deformation deformation;
        deformation.mesh = scene::MeshIndex(0);
        deformation.positions = mesh.positions;
        deformation.normals = mesh.normals;
        deformation.targets = {
            {moves, std::vector<V3f>(mesh.normals.size(), V3f(-1.0F, 0.0F, 0.0F))}};
        deformation.weights = {0.0F};
        deformation.weights_track = scene::TrackIndex(0);
        motion->deformations = {deformation};
        scene.motion = std::move(motion);
        const Film film = exposed(scene, orthographic(view_down_z(0, 0, 5)), strip());
        // The mean of cos(angle) = 1 / sqrt(1 + slope²) over slopes from -1 to 1.
        EXPECT_NEAR(red(film, wide / 2), std::asinh(1.0), moments) << by_normals;
    }
}

// What a moving light gives at a time is what it gives where it then stands.
TEST(Motion, LightsAreWhereTheyAreAtTheTime) {
    scene::Scene scene;
    scene::Material glowing = white();
    glowing.emission = scene::Color3f(5.0F);
    add(scene, parallelogram({-0.5F, -0.5F, 0}, {0, 1, 0}, {1, 0, 0}), glowing);
    set_in_motion(scene, {{-2, 0, 3}, {2, 0, 1}, 0.0, 1.0, {1.0, 0.0, 0.0}});
    scene::Light lamp;
    lamp.intensity = scene::Color3f(7.0F);
    scene.lights = {lamp};
    auto motion = std::make_shared<scene::Motion>(*scene.motion);
    motion->lights = {{0, scene::NodeIndex(0)}};
    scene.motion = motion;
    scene = *scene::moved_to(scene, 0.5);
    const scene::Movement movement = scene::movement(scene, {0.0, 1.0});
    const LightSet moving(scene, nullptr, movement);
    const auto irradiance = [](const LightSet& lights, const LitPoint& point) {
        constexpr int cells = 48;
        double total = 0.0;
        for (int i = 0; i < cells * cells * cells; ++i) {
            const auto at = [](int cell) {
                return (static_cast<float>(cell % cells) + 0.5F) / cells;
            };
            const auto sample = lights.sample(point, {at(i), at(i / cells), at(i / cells / cells)});
            total += sample ? double{std::max(sample->to_light.dot(point.normal), 0.0F) *
                                     sample->radiance.x / sample->pdf}
                            : 0.0;
        }
        return total / (cells * cells * cells);
    };
    for (const float time : {0.0F, 0.25F, 0.5F, 1.0F}) {
        const auto stopped = at_time(scene, static_cast<double>(time));
        const LightSet still(*stopped);
        const LitPoint point{V3f(0.0F), {0, 0, 1}, {0, 0, 1}, time};
        const double expected = irradiance(still, point);
        EXPECT_GT(expected, 0.1);
        // The grid of numbers divides differently among the lights, by at most a cell of each.
        EXPECT_NEAR(irradiance(moving, point), expected, expected * 3.0 / 48.0) << time;
        const float direct = still.arriving(0, point).irradiance.x;
        EXPECT_NEAR(moving.arriving(0, point).irradiance.x, direct, 1e-4F * direct) << time;
    }
}

TEST(Motion, AnInstantIsTheSceneAtThatTime) {
    scene::Scene moving;
    add(moving, wall(-1.0F, 2.0F), white());
    add(moving, wall(0.0F, 0.5F), white());
    set_in_motion(moving, {{-0.5, 0, 0}, {0.5, 0.25, 0}, 0.0, 2.0, {1.0, 2.0, 3.0}});
    moving = *scene::moved_to(moving, 0.25);
    scene::Scene still = moving;
    still.motion = nullptr;
    const camera::Camera camera = pinhole(view_down_z(0, 0, 2));
    Request wanted = request(64, 64, "preview", 4);
    wanted.time = 0.25;
    const Rendered a = render(moving, camera, wanted);
    const Rendered b = render(still, camera, wanted);
    EXPECT_EQ(a.film.sum, b.film.sum);
    EXPECT_NE(render(*scene::moved_to(moving, 0.5), camera, wanted).film.sum, b.film.sum);
}

TEST(Motion, WhatStandsStillIsNotBlurred) {
    scene::Scene scene;
    add(scene, wall(0.0F, 0.5F), white());
    const camera::Camera camera = pinhole(view_down_z(0, 0, 2));
    const Request wanted = request(64, 64, "preview", 4);
    EXPECT_EQ(exposed(scene, camera, wanted).sum, render(scene, camera, wanted).film.sum);
}

TEST(Motion, ThreadsDoNotMatter) {
    scene::Scene scene;
    add(scene, wall(-1.0F, 2.0F), white());
    add(scene, wall(0.0F, 0.5F), white());
    set_in_motion(scene, {{-0.5, 0, 0}, {0.5, 0.25, 0}, 0.0, 2.0, {1.0, 2.0, 3.0}});
    Request wanted = request(130, 70, "preview", 8);
    const camera::Camera camera = pinhole(view_down_z(0, 0, 2));
    wanted.threads = 1;
    const Film one = exposed(scene, camera, wanted);
    wanted.threads = 3;
    EXPECT_EQ(one.sum, exposed(scene, camera, wanted).sum);
}

TEST(Shutter, ShapesGiveMomentsAsOftenAsTheyCount) {
    for (const ShutterShape shape : {ShutterShape::box, ShutterShape::trapezoid}) {
        const Shutter shutter{4.0, shape};
        EXPECT_DOUBLE_EQ(shutter.exposure(10.0).begin, 8.0);
        EXPECT_DOUBLE_EQ(shutter.moment(10.0, 0.5), 10.0);
        for (int i = 0; i <= 100; ++i) {
            const double random = 0.01 * i;
            const double part = (shutter.moment(10.0, random) - 8.0) / 4.0;
            EXPECT_NEAR(before(shape, part), random, 1e-12) << shutter_shapes()[shape].name;
        }
    }
    EXPECT_EQ(Shutter{}.moment(0.1, 0.9), 0.1);
}

namespace {

/// A camera of a square picture that looks along -z, whose rays meet the scene at time(x, y): of
/// the picture point in fractions from its top left.
camera::Camera timed(RayFormula rays,
                     const std::function<expr::Expr(expr::Expr, expr::Expr)>& time) {
    camera::Camera::Parts parts = make_camera(std::move(rays)).parts();
    const auto graph = std::make_shared<expr::Graph>();
    const std::vector<expr::Expr> at{graph->fresh_variable(), graph->fresh_variable()};
    parts.time = camera::Formula(graph, at, {time(at[0], at[1])});
    Result<camera::Camera> made = camera::Camera::make(std::move(parts));
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return std::move(*made);
}

RayFormula straight(double width) {
    return {[width](const camera::ParameterPoint& p, camera::Emitter& emit) {
                return camera::ObjectPoint{width * p.u, p.v, emit(2.0)};
            },
            [](const camera::ParameterPoint&, camera::Emitter& emit) {
                return camera::ObjectVector{emit(0.0), emit(0.0), emit(-1.0)};
            }};
}

constexpr std::size_t square = 64;
constexpr double readout = 0.25;  // Seconds from the first row or column to the last.
constexpr double speed = 3.0;     // Of the bar, to the right.
constexpr double bar_width = 0.25;
constexpr std::size_t even_samples = 64;

/// A bar that is in the middle of the picture at time 0, and has radiance 1.
Film of_moving_bar(const camera::Camera& camera, std::string_view integrator) {
    scene::Scene scene;
    scene::Material shown = white();
    shown.unlit = true;
    add(scene, bar(0.0F, static_cast<float>(0.5 * bar_width)), shown);
    set_in_motion(scene, {{0, 0, 0}, {speed, 0, 0}});
    auto motion = std::make_shared<scene::Motion>(*scene.motion);
    motion->tracks[0].times = {-1.0, 1.0};
    motion->tracks[0].values[0] = static_cast<float>(-speed);
    scene.motion = std::move(motion);
    const Result<Renderer> renderer = Renderer::make(
        at_time(scene, 0.0), RendererSettings{.interval = scene::TimeInterval{-readout, readout}});
    EXPECT_TRUE(renderer) << to_text(renderer.diagnostics);
    Request wanted = request(square, square, std::string(integrator), even_samples);
    wanted.light.visible = false;
    Result<Film> film = make_film(wanted.layout);
    EXPECT_TRUE(render::render(*renderer, camera, wanted, *film));
    return std::move(*film);
}

/// The light of a row: how many pixels it fills, and where its middle is, in pixels.
struct RowOfLight {
    double width = 0.0;
    double middle = 0.0;
};
RowOfLight light_of_row(const Film& film, std::size_t y) {
    RowOfLight found;
    for (std::size_t x = 0; x < film.width; ++x) {
        found.width += red(film, x, y);
        found.middle += red(film, x, y) * (static_cast<double>(x) + 0.5);
    }
    found.middle /= found.width;
    return found;
}

// The samples are displaced by the filter, which is 3 pixels wide, along x and, times the slant of
// 3/8 pixel per row, along y, and they see a pixel as lit or not. Their mean is as even as the
// moments of an exposure: it errs by 2 parts in their number.
constexpr double sampled = (3.0 + 3.0 * 3.0 / 8.0 + 1.0) * 2.0 / even_samples;

class EachIntegrator : public testing::TestWithParam<const char*> {};

}  // namespace

INSTANTIATE_TEST_SUITE_P(Motion, EachIntegrator, testing::Values("path", "direct", "preview"),
                         [](const auto& name) { return std::string(name.param); });

// Each row is seen a row time after the one above: the bar leans by its speed times the row time.
TEST_P(EachIntegrator, RollingShutterSlantsTheBar) {
    const Film film = of_moving_bar(
        timed(straight(1.0), [](expr::Expr, expr::Expr y) { return readout * (y - 0.5); }),
        GetParam());
    constexpr double pixels_per_unit = square / 2.0;
    constexpr double row_time = readout / square;
    for (std::size_t y = 2; y + 2 < square; ++y) {
        const RowOfLight row = light_of_row(film, y);
        EXPECT_NEAR(row.width, bar_width * pixels_per_unit, 2.0 * sampled) << y;
        const double rows_below_the_middle = static_cast<double>(y) + 0.5 - 0.5 * square;
        EXPECT_NEAR(row.middle - 0.5 * square,
                    speed * row_time * pixels_per_unit * rows_below_the_middle, sampled)
            << y;
    }
}

// All columns show the same line, each a column time after the one to its left: the bar is as wide
// as it takes columns to pass the line.
TEST_P(EachIntegrator, SlitScanShowsHowLongTheBarTakes) {
    const Film film = of_moving_bar(
        timed(straight(0.0), [](expr::Expr x, expr::Expr) { return readout * (x - 0.5); }),
        GetParam());
    constexpr double column_time = readout / square;
    for (std::size_t y = 2; y + 2 < square; ++y) {
        const RowOfLight row = light_of_row(film, y);
        EXPECT_NEAR(row.width, bar_width / (speed * column_time), 2.0 * sampled) << y;
        EXPECT_NEAR(row.middle, 0.5 * square, sampled) << y;
    }
}

}  // namespace balcony::render::test::motion_test
