// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// What stands between a camera and a point: against what the renderer sees, and in scenes where one
// can say it.

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "balcony/probe.hpp"
#include "support.hpp"

namespace balcony::render::obstacles_test {
namespace {

using test::add;
using test::V3d;
using test::wall;
using test::white;

using Obstacles = std::vector<std::optional<Obstacle>>;

Obstacles obstacles(const scene::Scene& scene, const std::vector<SightLine>& lines,
                    Axes axes = Axes::y_up) {
    const auto found = find_obstacles(test::renderer_of(scene), lines, axes);
    EXPECT_TRUE(found) << to_text(found.diagnostics);
    EXPECT_TRUE(found.diagnostics.empty()) << to_text(found.diagnostics);
    return *found;
}

// Two walls, a floor that reaches far, and pillars, all turned askew and moved far from the origin,
// so that rounding is as bad as in a large scene.
scene::Scene hall(const V3d& middle) {
    scene::M44d askew;
    askew.setEulerAngles(V3d(0.3, 0.7, -0.2));
    askew[3][0] = middle.x;
    askew[3][1] = middle.y;
    askew[3][2] = middle.z;
    scene::Scene scene;
    add(scene, test::parallelogram({-50, -1, 50}, {100, 0, 0}, {0, 0, -100}), white(), askew);
    add(scene, wall(-6.0F, 3.0F), white(), askew);
    add(scene, test::parallelogram({2, -1, -4}, {0.3F, 0, 0.4F}, {0, 3, 0}), white(), askew);
    add(scene, test::parallelogram({-2, -1, -3}, {0.5F, 0, 0.1F}, {0, 2, 0}), white(), askew);
    scene.default_light = true;
    return scene;
}

test::View view_in_hall(const V3d& middle) {
    scene::M44d askew;
    askew.setEulerAngles(V3d(0.3, 0.7, -0.2));
    const auto turned = [&](const V3d& v) { return v * askew; };
    return {middle, turned({0, 0, -1}), turned({1, 0, 0}), turned({0, 1, 0})};
}

}  // namespace

// The law: of what a pixel shows the point itself is seen, from any side and however flatly; what
// is behind it is hidden by it, what is before it is seen.
TEST(Obstacles, AreTheSurfacesThatTheRendererSees) {
    constexpr std::size_t side = 120;
    for (const V3d& middle : {V3d(0.0), V3d(300.0, -200.0, 1000.0)}) {
        const scene::Scene scene = hall(middle);
        const test::Rendered picture = test::render(scene, test::pinhole(view_in_hall(middle)),
                                                    test::request(side, side, "preview"));
        const DataLayers& data = *picture.film.layers;
        std::vector<SightLine> lines;
        std::vector<std::size_t> pixels;
        // A ray that passes an edge within rounding may pass it on the other side the next time.
        const auto inside = [&](std::size_t i) {
            const std::uint32_t object = data.object[i];
            return i >= side && i + side < data.object.size() && i % side != 0 &&
                   (i + 1) % side != 0 && data.object[i - 1] == object &&
                   data.object[i + 1] == object && data.object[i - side] == object &&
                   data.object[i + side] == object;
        };
        for (std::size_t i = 0; i < data.object.size(); ++i) {
            if (data.object[i] != 0 && inside(i)) {
                const V3d from(data.origin[i]);
                const V3d to(data.position[i]);
                lines.push_back({from, to});
                lines.push_back({from, from + 1.001 * (to - from)});
                lines.push_back({from, from + 0.999 * (to - from)});
                pixels.push_back(i);
            }
        }
        ASSERT_GT(pixels.size(), 6'500U);
        const Obstacles found = obstacles(scene, lines);
        std::size_t self_hidden = 0;
        std::size_t not_hidden = 0;
        std::size_t hidden_too_soon = 0;
        for (std::size_t k = 0; k < pixels.size(); ++k) {
            const std::size_t i = pixels[k];
            const auto& behind = found[3 * k + 1];
            self_hidden += found[3 * k] ? 1 : 0;
            hidden_too_soon += found[3 * k + 2] ? 1 : 0;
            // Where the ray is flat a thousandth more of it may still be in the plane, as far as
            // floats tell.
            const double height = 0.001 * double{data.ray_length[i]} *
                                  std::abs(data.normal[i].dot(data.direction[i]));
            const bool told_apart = height > 1e-6 * (middle.length() + 100.0);
            const bool right = behind && behind->object + 1 == data.object[i] &&
                               std::abs(behind->distance - double{data.ray_length[i]}) <
                                   1e-3 * double{data.ray_length[i]};
            not_hidden += told_apart && !right ? 1 : 0;
        }
        EXPECT_EQ(self_hidden, 0U) << "of " << pixels.size();
        EXPECT_EQ(not_hidden, 0U);
        EXPECT_EQ(hidden_too_soon, 0U);
    }
}

TEST(Obstacles, AreNamedWithTheirDistance) {
    scene::Scene scene;
    add(scene, wall(-5.0F, 1.0F), white());
    add(scene, wall(-3.0F, 1.0F), white());
    const V3d eye(0.0);
    const Obstacles found = obstacles(scene, {{eye, {0.1, 0.2, -9}},
                                              {eye, {0, 0, -5}},
                                              {eye, {0, 0, -3}},
                                              {eye, {0, 0, -2}},
                                              {eye, {5, 0, -9}},
                                              {{0, 0, -4}, {0, 0, -9}},
                                              {{0, 0, -9}, {0, 0, 0}},
                                              {eye, eye}});
    ASSERT_TRUE(found[0] && found[1] && found[5] && found[6]);
    EXPECT_EQ(found[0]->object, 1U);
    EXPECT_NEAR(found[0]->distance, 3.0 * std::sqrt(0.01 + 0.04 + 81.0) / 9.0, 1e-6);
    EXPECT_EQ(found[1]->object, 1U);
    EXPECT_NEAR(found[1]->distance, 3.0, 1e-6);
    EXPECT_EQ(found[5]->object, 0U);
    EXPECT_NEAR(found[5]->distance, 1.0, 1e-6);
    EXPECT_EQ(found[6]->object, 0U);
    for (const std::size_t seen : {2U, 3U, 4U, 7U}) {
        EXPECT_FALSE(found[seen]) << seen;
    }
}

// From a place on a floor along it: the floor hides nothing, what stands on it does.
TEST(Obstacles, AreNotTheSurfaceThatContainsTheLine) {
    scene::Scene scene;
    add(scene, test::parallelogram({-9, 0, 9}, {18, 0, 0}, {0, 0, -18}), white());
    EXPECT_FALSE(obstacles(scene, {{{0, 0, 5}, {0.3, 0, -5}}})[0]);
    EXPECT_FALSE(obstacles(scene, {{{0, 1e-4, 5}, {0.3, 0, -5}}})[0]);
    add(scene, wall(0.0F, 2.0F), white());
    const auto found = obstacles(scene, {{{0, 0, 5}, {0.3, 0, -5}}})[0];
    ASSERT_TRUE(found);
    EXPECT_EQ(found->object, 1U);
    EXPECT_NEAR(found->distance, 5.0, 0.01);
}

TEST(Obstacles, AreOpaque) {
    scene::Material glass = white();
    glass.alpha_mode = scene::AlphaMode::blend;
    glass.alpha = 0.9F;
    scene::Material grid = white();
    grid.alpha_mode = scene::AlphaMode::mask;
    grid.alpha_cutoff = 0.5F;
    scene::Scene scene;
    // Left half there, right half cut out.
    grid.base_color_texture.index = test::add_texture(
        scene, test::encode_png(8, 8, 4, [](int x, int) -> std::vector<std::uint8_t> {
            return {255, 255, 255, static_cast<std::uint8_t>(x < 4 ? 255 : 0)};
        }));
    grid.opacity_texture = grid.base_color_texture;
    grid.opacity_texture.channel = 3;
    add(scene, wall(-2.0F, 1.0F), glass);
    add(scene, wall(-3.0F, 1.0F), grid);
    const Obstacles found = obstacles(
        scene, {{V3d(0.0), {-0.5, 0, -9}}, {V3d(0.0), {0.5, 0, -9}}, {V3d(0.0), {-0.3, 0, -2.5}}});
    EXPECT_FALSE(found[1]);
    EXPECT_FALSE(found[2]);
    ASSERT_TRUE(obstacles(scene, {{{-0.6, 0, 0}, {-0.6, 0, -9}}})[0]);
    EXPECT_EQ(obstacles(scene, {{{-0.6, 0, 0}, {-0.6, 0, -9}}})[0]->object, 1U);
    EXPECT_FALSE(obstacles(scene, {{{0.6, 0, 0}, {0.6, 0, -9}}})[0]);
}

// A point that somebody wrote with six digits.
TEST(Obstacles, AreNoNearerToThePointThanItsDigitsTell) {
    scene::Scene scene;
    add(scene, wall(-3.0F, 1.0F), white());
    EXPECT_FALSE(obstacles(scene, {{V3d(0.0), {0, 0, -3.00002}}})[0]);
    EXPECT_TRUE(obstacles(scene, {{V3d(0.0), {0, 0, -3.0001}}})[0]);
}

TEST(Obstacles, LinesMayBeInOtherAxes) {
    scene::Scene scene;
    add(scene, wall(-3.0F, 1.0F), white());
    // In z_up the wall is upright at y = 3.
    EXPECT_TRUE(obstacles(scene, {{V3d(0.0), {0, 9, 0}}}, Axes::z_up)[0]);
    EXPECT_FALSE(obstacles(scene, {{V3d(0.0), {0, 0, -9}}}, Axes::z_up)[0]);
}

TEST(Obstacles, NonFiniteLinesAreNotHidden) {
    scene::Scene scene;
    add(scene, wall(-3.0F, 1.0F), white());
    const double huge = 1e300;
    const double none = std::nan("");
    const Obstacles found = obstacles(scene, {{V3d(huge), V3d(0.0)},
                                              {V3d(0.0), V3d(none, 0, -9)},
                                              {V3d(none), V3d(0, 0, -9)},
                                              {V3d(0.0), V3d(0, 0, -1e30)},
                                              {V3d(0.0), V3d(0, 0, -huge)}});
    EXPECT_FALSE(found[0] || found[1] || found[2]);
    EXPECT_TRUE(found[3] && found[4]);
}

}  // namespace balcony::render::obstacles_test
