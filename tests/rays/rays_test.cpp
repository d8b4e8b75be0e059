// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Rays as numbers: the same over tiles and at points, in the axes asked for, with derivatives that
// are those of neighbouring rays; from cameras that are emitted once.

#include "balcony/rays.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "../laws/built_in_cameras.hpp"
#include "balcony/lang.hpp"

namespace balcony::rays::rays_test {
namespace {

camera::Picture picture_of(const std::string& text) {
    auto made = lang::make_picture(std::make_shared<const SourceText>("test.cam", text), "");
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return *made;
}

camera::Camera built_in(const std::string& name) { return *lang::make_camera(name, ""); }

RayProgram compiled(const camera::Camera& camera, double width, double height,
                    const CompileOptions& options) {
    auto made = compile(camera, width, height, options);
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return *made;
}

// The ray at one point, as the only one of a batch.
RayBatch batch_at(const RayProgram& program, const V2d& point, double time = 0.0) {
    Scratch scratch;
    RayBatch batch;
    program.run(Points{std::span(&point.x, 1), std::span(&point.y, 1), time}, scratch, batch);
    return batch;
}

Ray ray_at(const RayProgram& program, const V2d& point, double time = 0.0) {
    return batch_at(program, point, time)[0];
}

// The points where a ray turns, and its last direction.
std::vector<V3d> bend_of(const RayBatch& one) {
    std::vector<V3d> made;
    for (std::size_t i = 1; i < one.part_count(); ++i) {
        made.push_back(one.part(0, i).origin);
    }
    made.push_back(one.part(0, one.part_count() - 1).direction);
    return made;
}

TEST(RayProgram, GivesTheSameRaysOverTilesAndAtPoints) {
    const RayProgram program =
        compiled(built_in("superelliptic"), 300, 60, {.footprints = true, .points = true});
    Scratch scratch;
    RayBatch batch;
    program.run(Tile{37.5, 11.5, 1.0, 5, 3, 0.0}, scratch, batch);
    ASSERT_EQ(batch.size(), 15U);
    for (std::size_t i = 0; i < batch.size(); ++i) {
        const Ray one =
            ray_at(program, {37.5 + static_cast<double>(i % 5), 11.5 + static_cast<double>(i / 5)});
        EXPECT_TRUE(one.valid);
        EXPECT_EQ(one.origin, batch[i].origin);
        EXPECT_EQ(one.direction, batch[i].direction);
        EXPECT_EQ(one.parameters, batch[i].parameters);
        EXPECT_EQ(one.origin_by_x, batch[i].origin_by_x);
        EXPECT_EQ(one.direction_by_y, batch[i].direction_by_y);
    }
}

TEST(RayProgram, GivesTheSameRaysWithoutParameters) {
    for (const bool footprints : {false, true}) {
        const camera::Camera camera = built_in("superelliptic");
        const CompileOptions with{.footprints = footprints, .points = true};
        CompileOptions without = with;
        without.parameters = false;
        const Ray expected = ray_at(compiled(camera, 300, 60, with), {37.5, 11.5});
        const Ray found = ray_at(compiled(camera, 300, 60, without), {37.5, 11.5});
        EXPECT_TRUE(found.valid);
        EXPECT_EQ(found.origin, expected.origin);
        EXPECT_EQ(found.direction, expected.direction);
        EXPECT_EQ(found.origin_by_x, expected.origin_by_x);
        EXPECT_EQ(found.direction_by_y, expected.direction_by_y);
        EXPECT_NE(expected.parameters, V2d(0.0));
        EXPECT_EQ(found.parameters, V2d(0.0));
    }
}

TEST(RayProgram, AgreesWithTheScalarDefinitions) {
    for (const std::string& name : laws::single_built_in_cameras()) {
        const camera::Camera camera = built_in(name);
        expr::Graph graph;
        const camera::RayExpressions ray = camera.emit(graph, 160, 90);
        std::vector<expr::Expr> roots{ray.origin.x,    ray.origin.y,    ray.origin.z,
                                      ray.direction.x, ray.direction.y, ray.direction.z,
                                      ray.parameters.u};
        const std::size_t straight = roots.size();
        if (ray.bend) {
            for (const camera::ObjectPoint& knot : ray.bend->knots) {
                roots.insert(roots.end(), {knot.x, knot.y, knot.z});
            }
            const camera::ObjectVector& last = ray.bend->direction;
            roots.insert(roots.end(), {last.x, last.y, last.z});
        }
        const RayBatch batch =
            batch_at(compiled(camera, 160, 90, {.points = true, .bends = true}), {62.25, 50.75});
        const Ray found = batch[0];
        const std::vector<double> v = expr::evaluate(roots, {62.25, 50.75, 0.0, {}});
        ASSERT_TRUE(found.valid) << name;
        // A runner's operations err by a few units in the last place each.
        const double tolerance = 1e-12 * (1.0 + found.origin.length());
        EXPECT_LT((found.origin - V3d(v[0], v[1], v[2])).length(), tolerance) << name;
        EXPECT_LT((found.direction - V3d(v[3], v[4], v[5])).length(), 1e-12) << name;
        EXPECT_NEAR(found.parameters.x, v[6], 1e-12) << name;
        const std::vector<V3d> bend = bend_of(batch);
        for (std::size_t i = 0; straight + 3 * i < v.size(); ++i) {
            const double* wanted = &v[straight + 3 * i];
            EXPECT_LT((bend[i] - V3d(wanted[0], wanted[1], wanted[2])).length(),
                      1e-12 * (1.0 + bend[i].length()))
                << name << ' ' << i;
        }
    }
}

TEST(RayProgram, DerivativesAreNeighbourDifferences) {
    const RayProgram program =
        compiled(built_in("hyperbolic"), 160, 90, {.footprints = true, .points = true});
    // The error of a central difference is some h^2; that of its rounding 1e-15/h.
    const double h = 1e-4;
    for (const V2d& p : {V2d(10, 10), V2d(81, 40), V2d(150, 88)}) {
        const Ray ray = ray_at(program, p);
        const auto slope = [&](V3d Ray::*member, const V2d& by) {
            return (ray_at(program, p + h * by).*member - ray_at(program, p - h * by).*member) /
                   (2.0 * h);
        };
        EXPECT_LT((ray.origin_by_x - slope(&Ray::origin, {1, 0})).length(), 1e-8);
        EXPECT_LT((ray.origin_by_y - slope(&Ray::origin, {0, 1})).length(), 1e-8);
        EXPECT_LT((ray.direction_by_x - slope(&Ray::direction, {1, 0})).length(), 1e-8);
        EXPECT_LT((ray.direction_by_y - slope(&Ray::direction, {0, 1})).length(), 1e-8);
        EXPECT_GT(ray.direction_by_x.length(), 1e-4);
    }
}

TEST(RayProgram, ConvertsRaysAndDerivativesToTheRequestedAxes) {
    const camera::Camera camera = built_in("superelliptic");
    ASSERT_EQ(camera.parts().axes, Axes::z_up);
    const auto ray = [&](std::optional<Axes> axes) {
        return ray_at(compiled(camera, 300, 60, {.axes = axes, .footprints = true, .points = true}),
                      {100.0, 20.0});
    };
    const Ray own = ray({});
    const Ray y_up = ray(Axes::y_up);
    for (const auto member : {&Ray::origin, &Ray::direction, &Ray::origin_by_x, &Ray::origin_by_y,
                              &Ray::direction_by_x, &Ray::direction_by_y}) {
        const V3d& v = own.*member;
        EXPECT_EQ(y_up.*member, V3d(v.x, v.z, -v.y));
        EXPECT_NE(y_up.*member, v);
    }
    EXPECT_EQ(ray(Axes::z_up).origin, own.origin);
    EXPECT_EQ(y_up.parameters, own.parameters);
}

TEST(RayProgram, HasDerivativesOnlyOnRequest) {
    const RayProgram program = compiled(built_in("hyperbolic"), 160, 90, {.points = true});
    EXPECT_FALSE(program.has_footprints());
    EXPECT_EQ(ray_at(program, {80, 45}).origin_by_x, V3d(0.0));
}

// -------------------------------------------------------------------------------- inputs

// Moves the eye along z by an input, as a live view does or a lens.
class LiftedByInput final : public camera::ObjectTransformer {
public:
    camera::ObjectPoint transform(const camera::ObjectPoint& p,
                                  camera::Emitter& emit) const override {
        return {p.x, p.y, p.z + emit.graph().input("lift")};
    }
};

TEST(RayProgram, TakesTheValuesOfFurtherInputs) {
    camera::Camera::Parts parts = built_in("hyperbolic").parts();
    parts.eye.object_transformers.push_back(std::make_shared<const LiftedByInput>());
    const auto camera = camera::Camera::make(std::move(parts));
    ASSERT_TRUE(camera) << to_text(camera.diagnostics);
    const Tile tile{10.5, 20.5, 1.0, 2, 2, 0.0};
    Scratch scratch;
    RayBatch plain;
    compiled(built_in("hyperbolic"), 160, 90, {}).run(tile, scratch, plain);

    const std::array by_point{1.0, 2.0, 3.0, 4.0};
    const std::array<std::span<const double>, 1> values{by_point};
    const RayProgram program =
        compiled(*camera, 160, 90, {.inputs = {{"lift", program::Rate::pixel}}});
    Tile with_values = tile;
    with_values.inputs = values;
    RayBatch lifted;
    program.run(with_values, scratch, lifted);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(lifted.origin(i).z, plain.origin(i).z + by_point[i], 1e-12);
        EXPECT_EQ(lifted.origin(i).x, plain.origin(i).x);
    }
    const auto undeclared = compile(*camera, 160, 90, {});
    ASSERT_FALSE(undeclared);
    EXPECT_NE(to_text(undeclared.diagnostics).find("lift"), std::string::npos);
}

// ------------------------------------------------------------------------------ emitted once

// A plane that counts how often it writes its formula.
class CountedPlane final : public camera::ObjectGenerator {
public:
    explicit CountedPlane(std::atomic<int>& count) : count_(count) {}
    int dimension() const override { return 2; }
    camera::ObjectPoint generate(const camera::ParameterPoint& p,
                                 camera::Emitter& emit) const override {
        ++count_;
        return {p.u, p.v * p.v, emit(0.0)};
    }

private:
    std::atomic<int>& count_;
};

TEST(Camera, IsEmittedOnceForPicturesOfAllSizes) {
    std::atomic<int> count = 0;
    camera::Camera::Parts parts = built_in("hyperbolic").parts();
    parts.eye.generator = std::make_shared<const CountedPlane>(count);
    const auto camera = camera::Camera::make(std::move(parts));
    ASSERT_TRUE(camera) << to_text(camera.diagnostics);
    const int when_made = count;
    EXPECT_GE(when_made, 1);
    (void)compiled(*camera, 160, 90, {});
    (void)compiled(*camera, 321, 200, {.footprints = true});
    (void)compile(camera::Picture(*camera), 50, 50, {});
    EXPECT_EQ(count, when_made);
}

TEST(Camera, LooksOutwardAtAllTimes) {
    for (const bool outward : {true, false}) {
        const camera::Picture picture = picture_of(fmt::format(
            "camera balloon {{ map u = 180deg .. -180deg, v = -60deg .. 60deg eye sphere(1 + t)\n"
            "    move rotate(x, t*40deg), translate(3*t, t, 0) look normal({}) }}",
            outward ? "outward" : "inward"));
        const RayProgram program = compiled(*picture.only_camera(), 100, 75, {.points = true});
        for (const double time : {0.0, 2.5, 40.0}) {
            for (const V2d& point : {V2d(10, 10), V2d(50, 40), V2d(97, 70)}) {
                const Ray ray = ray_at(program, point, time);
                ASSERT_TRUE(ray.valid);
                const V3d from_center = (ray.origin - V3d(3.0 * time, time, 0.0)) / (1.0 + time);
                EXPECT_NEAR(ray.direction.dot(from_center), outward ? 1.0 : -1.0, 1e-12);
            }
        }
    }
}

TEST(Camera, DependsOnlyOnTheAspectRatio) {
    for (const std::string& name : laws::single_built_in_cameras()) {
        const camera::Camera camera = built_in(name);
        const CompileOptions options{.points = true, .bends = true};
        const RayBatch small = batch_at(compiled(camera, 100, 75, options), {33.0, 21.0});
        const RayBatch large = batch_at(compiled(camera, 400, 300, options), {132.0, 84.0});
        EXPECT_LT((small.direction(0) - large.direction(0)).length(), 1e-12) << name;
        EXPECT_LT((small.origin(0) - large.origin(0)).length(),
                  1e-12 * (1.0 + small.origin(0).length()))
            << name;
        ASSERT_EQ(small.part_count(), large.part_count()) << name;
        const std::vector<V3d> bend = bend_of(small);
        const std::vector<V3d> of_large = bend_of(large);
        for (std::size_t i = 0; i < bend.size(); ++i) {
            EXPECT_LT((bend[i] - of_large[i]).length(), 1e-12 * (1.0 + bend[i].length()))
                << name << ' ' << i;
        }
    }
}

// ---------------------------------------------------------------------------------- pictures

constexpr const char* two_layers =
    "camera left(turn = 0deg) { map u = 1 .. -1, v = -1 .. 1 eye point(0, 0, 0)\n"
    "    toward plane((1, 0, 0)) move rotate(z, turn) }\n"
    "picture both 80 x 60 {\n"
    "    layer left { stretch }\n"
    "    layer left(turn = 90deg) { place (0.5, 0) .. (1, 1)  stretch  alpha ALPHA }\n"
    "}\n";

std::string with_alpha(const std::string& alpha) {
    std::string text = two_layers;
    return text.replace(text.find("ALPHA"), 5, alpha);
}

TEST(CompiledPicture, OfACameraIsThatCamera) {
    const auto made = compile(camera::Picture(built_in("pinhole")), 160, 90, {});
    ASSERT_TRUE(made);
    EXPECT_TRUE(made->is_one_camera());
    EXPECT_EQ(made->coverage_count(), 0U);
    ASSERT_EQ(made->layers().size(), 1U);
    EXPECT_EQ(made->layers().front().name, "pinhole");
}

TEST(CompiledPicture, HasARayProgramALayerAndTheirCoverages) {
    const auto made = compile(picture_of(with_alpha("0.25")), 80, 60, {});
    ASSERT_TRUE(made);
    EXPECT_FALSE(made->is_one_camera());
    ASSERT_EQ(made->layers().size(), 2U);
    ASSERT_EQ(made->coverage_count(), 1U);
    std::array<double, 2> coverage{};
    double* const results = coverage.data();
    Scratch scratch;
    made->run_coverages(Tile{19.5, 30.5, 40.0, 2, 1, 0.0}, scratch, std::span(&results, 1));
    EXPECT_EQ(coverage[0], 0.0);
    EXPECT_EQ(coverage[1], 0.25);
    RayBatch rays;
    made->layers()[1].rays.run(Tile{60.0, 30.0, 1.0, 1, 1, 0.0}, scratch, rays);
    EXPECT_LT((rays.direction(0) - V3d(0, 1, 0)).length(), 1e-12);
}

TEST(VisibleLayers, AreHiddenByOpaqueLayersInFront) {
    const CompileOptions at_points{.tiles = false, .points = true};
    const std::array x{20.0, 60.0};
    const std::array y{30.0, 30.0};
    const auto hidden_back = [&](const std::string& alpha) {
        const auto made = compile_layers(picture_of(with_alpha(alpha)), 80, 60, at_points);
        EXPECT_TRUE(made && made->any_hidden()) << alpha;
        std::array<std::array<double, 2>, 2> hidden{};
        const std::array results{hidden[0].data(), hidden[1].data()};
        Scratch scratch;
        made->run_hidden(Points{x, y, 0.0}, scratch, results);
        EXPECT_EQ(hidden[1], (std::array{0.0, 0.0}));
        return hidden[0];
    };
    EXPECT_EQ(hidden_back("1"), (std::array{0.0, 1.0}));
    const auto translucent = compile_layers(picture_of(with_alpha("0.5")), 80, 60, at_points);
    ASSERT_TRUE(translucent);
    EXPECT_EQ(ray_at(translucent->layers()[1].rays, {20.0, 30.0}).valid, false);
    EXPECT_EQ(ray_at(translucent->layers()[1].rays, {60.0, 30.0}).valid, true);
}

TEST(VisibleLayers, OfOneCameraAreNotHidden) {
    const auto made = compile_layers(camera::Picture(built_in("pinhole")), 80, 60,
                                     {.tiles = false, .points = true});
    ASSERT_TRUE(made);
    EXPECT_FALSE(made->any_hidden());
}

// The master of layers by depth hides what is behind all of them. What covers a place in part is
// seen.
TEST(VisibleLayers, ByDepthAreHiddenByTheirMaster) {
    const std::string by_depth =
        std::string(two_layers).substr(0, std::string(two_layers).find("picture")) +
        "picture deep {\n"
        "    layer left { }\n"
        "    layer left { }\n"
        "    layer left { alpha 0.5\n blend by depth }\n"
        "}\n";
    const auto made =
        compile_layers(picture_of(by_depth), 80, 60, {.tiles = false, .points = true});
    ASSERT_TRUE(made) << to_text(made.diagnostics);
    ASSERT_TRUE(made->any_hidden());
    std::array<double, 3> hidden{};
    const std::array results{&hidden[0], &hidden[1], &hidden[2]};
    const double x = 20.0;
    const double y = 30.0;
    Scratch scratch;
    made->run_hidden(Points{std::span(&x, 1), std::span(&y, 1)}, scratch, results);
    EXPECT_EQ(hidden, (std::array{1.0, 0.0, 0.0}));
    EXPECT_TRUE(ray_at(made->layers()[2].rays, {x, y}).valid);
}

TEST(RayProgram, CountsWhatARayCosts) {
    expr::Graph graph;
    const auto number = [&](double value) { return graph.constant(value); };
    const auto cost = [&](const expr::Expr& x) {
        const camera::RayExpressions ray{.origin = {number(0), number(0), number(0)},
                                         .direction = {number(1), x, number(0)},
                                         .valid = number(1),
                                         .parameters = {number(0), number(0)}};
        return RayProgram::make(ray, Axes::z_up, {})->instruction_count();
    };
    EXPECT_EQ(cost(number(2)), 0U);
    const expr::Expr x = graph.input("x");
    EXPECT_EQ(cost(x * x), 1U);
}

// ------------------------------------------------------------------------------------ limits

// 512 warps, one after another, each towards so many seeds.
std::string with_seeds(int count) {
    std::string seeds;
    for (int i = 0; i < count; ++i) {
        seeds += fmt::format("{}({}, {}, {}, {})", i == 0 ? "" : ", ", i % 20, i / 20, i % 20 + 0.1,
                             i / 20);
    }
    return fmt::format(
        "camera large {{\n"
        "    map  u = 0 .. 19, v = 0 .. 9\n"
        "    warp repeat(64, repeat(8, inverse_distance([{}])))\n"
        "    eye  plane\n"
        "}}\n",
        seeds);
}

TEST(Limits, TheLargestCameraHasFootprintsOrADiagnostic) {
    const auto make = [](int seeds) {
        return lang::make_camera(std::make_shared<const SourceText>("large.cam", with_seeds(seeds)),
                                 "");
    };
    ASSERT_FALSE(make(200));
    // Each seed adds the same number of operations.
    const std::size_t of_four = make(4)->operations();
    const std::size_t of_each = (make(8)->operations() - of_four) / 4;
    const std::size_t seeds = (camera::max_operations_of_camera - of_four) / of_each + 4;
    const auto largest = make(static_cast<int>(seeds));
    ASSERT_TRUE(largest) << to_text(largest.diagnostics);
    EXPECT_GT(largest->operations(), camera::max_operations_of_camera * 3 / 4);
    const auto rays = compile(*largest, 100, 100, {.footprints = true});
    EXPECT_TRUE(rays || to_text(rays.diagnostics).find("is too large") != std::string::npos)
        << to_text(rays.diagnostics);
    EXPECT_TRUE(compile(*largest, 100, 100, {}));
}

}  // namespace
}  // namespace balcony::rays::rays_test
