// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The path integrator against laws of light.

#include <cmath>

#include <gtest/gtest.h>

#include "support.hpp"

namespace balcony::render::test::path_test {
namespace {

scene::Material glowing(float radiance) {
    scene::Material material = white();
    material.base_color = Color3f(0.0F);
    material.emission = Color3f(radiance);
    return material;
}

// A room of 2 x 2 x 2 with a lamp below its ceiling, a glossy box-like step, and a grey wall.
scene::Scene room(float roughness = 0.4F) {
    scene::Scene scene;
    const auto side = [&](V3f corner, V3f right, V3f up, Color3f color, float rough = 1.0F) {
        scene::Material material = white();
        material.base_color = color;
        material.roughness = rough;
        add(scene, parallelogram(corner, right, up), material);
    };
    const Color3f grey(0.5F);
    side({-1, -1, 1}, {2, 0, 0}, {0, 0, -2}, grey, roughness);                    // floor
    side({-1, 1, -1}, {2, 0, 0}, {0, 0, 2}, grey);                                // ceiling
    side({-1, -1, -1}, {2, 0, 0}, {0, 2, 0}, grey);                               // back
    side({-1, -1, 1}, {0, 0, -2}, {0, 2, 0}, Color3f(0.6F, 0.1F, 0.1F));          // left
    side({1, -1, -1}, {0, 0, 2}, {0, 2, 0}, Color3f(0.1F, 0.6F, 0.1F));           // right
    side({1, -1, 1.5F}, {-2, 0, 0}, {0, 2, 0}, grey);                             // front
    side({-0.5F, -0.5F, -0.5F}, {0.5F, 0, 0.5F}, {0, 0.7F, 0}, grey, roughness);  // screen
    add(scene, parallelogram({-0.3F, 0.95F, -0.3F}, {0.6F, 0, 0}, {0, 0, 0.6F}), glowing(5.0F));
    return scene;
}

Request traced(std::size_t width, std::size_t height, std::size_t samples) {
    return request(width, height, "path", samples);
}

Color3f mean(const Film& film) {
    Color3f sum(0.0F);
    for (std::size_t y = 0; y < film.height; ++y) {
        for (std::size_t x = 0; x < film.width; ++x) {
            const Color4f pixel = film.pixel(x, y);
            sum += Color3f(pixel.r, pixel.g, pixel.b);
        }
    }
    return sum / static_cast<float>(film.width * film.height);
}

scene::Light lamp_at(double x, double y, double z) {
    scene::Light light;
    light.position = V3d(x, y, z);
    return light;
}

TEST(Path, WithoutBouncesAndWithOneLampIsDirectLight) {
    scene::Scene scene = room();
    scene.meshes.pop_back();
    scene.instances.pop_back();
    scene.lights = {lamp_at(0.3, 0.7, 0.4)};
    const camera::Camera camera = pinhole(view_down_z(0.0, 0.0, 1.2));
    Request asked = traced(24, 24, 1);
    asked.path.bounces = {0, 0, 0, 0};
    const Film path = render(scene, camera, asked).film;
    const Film direct = render(scene, camera, request(24, 24, "direct")).film;
    for (std::size_t i = 0; i < path.sum.size(); ++i) {
        ASSERT_NEAR(path.sum[i].g, direct.sum[i].g, 1e-5 * direct.sum[i].g) << i;
    }
}

// The three ways to sample lamps are estimates of one integral: their means agree within five
// standard errors of the noisiest, found from the spread of the samples themselves.
TEST(Path, SamplingLampsOrSurfacesOrBothConvergesToOnePicture) {
    const scene::Scene scene = room();
    const camera::Camera camera = pinhole(view_down_z(0.0, 0.0, 1.2));
    const auto rendered = [&](LampSampling sampling) {
        Request asked = traced(16, 16, 256);
        asked.path.lamp_sampling = sampling;
        asked.path.bounces = {2, 2, 2, 2};
        asked.layout.second_moment = true;
        return render(scene, camera, asked).film;
    };
    const Film both = rendered(LampSampling::both);
    for (const LampSampling sampling : {LampSampling::lamps, LampSampling::surfaces}) {
        const Film other = rendered(sampling);
        double variance = 0.0;
        for (std::size_t y = 0; y < other.height; ++y) {
            for (std::size_t x = 0; x < other.width; ++x) {
                variance += (other.variance(x, y).g + both.variance(x, y).g) / 256.0;
            }
        }
        const double error = std::sqrt(variance) / static_cast<double>(other.sum.size());
        EXPECT_GT(mean(both).y, 0.05F);
        EXPECT_LT(error, 0.02 * static_cast<double>(mean(both).y));
        EXPECT_NEAR(mean(other).y, mean(both).y, 5.0 * error);
    }
}

// The power heuristic is never much worse than the better method: Veach 1997, section 9.2.
TEST(Path, BothMethodsTogetherAreAboutAsGoodAsTheBetterOne) {
    const scene::Scene scene = room(0.2F);
    const camera::Camera camera = pinhole(view_down_z(0.0, 0.0, 1.2));
    const auto noise = [&](LampSampling sampling) {
        Request asked = traced(16, 16, 64);
        asked.path.lamp_sampling = sampling;
        asked.layout.second_moment = true;
        const Film film = render(scene, camera, asked).film;
        double variance = 0.0;
        for (std::size_t i = 0; i < film.sum.size(); ++i) {
            variance += film.variance(i % film.width, i / film.width).g;
        }
        return variance;
    };
    const double both = noise(LampSampling::both);
    EXPECT_LT(both, 1.1 * noise(LampSampling::lamps));
    EXPECT_LT(both, 0.8 * noise(LampSampling::surfaces));
}

TEST(Path, MoreBouncesAddLight) {
    const scene::Scene scene = room();
    const camera::Camera camera = pinhole(view_down_z(0.0, 0.0, 1.2));
    float before = 0.0F;
    for (const std::size_t bounces : {0U, 1U, 2U, 6U}) {
        Request asked = traced(16, 16, 64);
        asked.path.bounces = {bounces, bounces, bounces, bounces};
        const float now = mean(render(scene, camera, asked).film).y;
        EXPECT_GT(now, 1.01F * before) << bounces;
        before = now;
    }
}

// A closed room whose walls all emit 1 and reflect a: each place has the radiance 1 / (1 - a), of
// which n bounces leave out a^(n + 2).
scene::Scene furnace(float albedo) {
    scene::Scene scene;
    scene::Material wall = white();
    wall.base_color = Color3f(albedo);
    wall.specular = 0.0F;
    wall.emission = Color3f(1.0F);
    add(scene, coarse_sphere(1.0F, 32, 16), wall);
    return scene;
}

TEST(Path, DefaultLimitsLeaveAWhiteRoomItsLight) {
    for (const float albedo : {0.75F, 0.95F}) {
        const scene::Scene scene = furnace(albedo);
        const Request asked = traced(16, 16, 256);
        const float found = mean(render(scene, pinhole(view_down_z(0.0, 0.0, 0.3)), asked).film).y;
        const float all = 1.0F / (1.0F - albedo);
        EXPECT_NEAR(found, all, 0.02F * all) << albedo;
    }
}

// One in eight of the paths that reach a limit tells what it cuts off: at the rarest, 0.95^21 / 8
// of 65,536, whose number deviates by 2 %. Five times that is tolerated.
TEST(Path, TellsWhatLimitsOfBouncesCutOff) {
    struct Case {
        float albedo;
        std::size_t bounces;
        bool by_kind;
        LampSampling sampling = LampSampling::both;
    };
    for (const Case& one : {Case{0.75F, 0, false}, Case{0.75F, 2, false}, Case{0.75F, 2, true},
                            Case{0.75F, 2, false, LampSampling::surfaces}, Case{0.95F, 20, false},
                            Case{0.95F, 20, true}}) {
        const scene::Scene scene = furnace(one.albedo);
        Request asked = traced(16, 16, 256);
        asked.path.bounces.all = one.by_kind ? BounceLimits::most : one.bounces;
        asked.path.bounces.diffuse = one.bounces;
        asked.path.lamp_sampling = one.sampling;
        const auto summary = render(scene, pinhole(view_down_z(0.0, 0.0, 0.3)), asked).summary;
        // The first of the sum is the wall's own light.
        const double lost = std::pow(one.albedo, static_cast<double>(one.bounces + 2));
        EXPECT_NEAR(summary.layers.front().share_cut_off(), lost, 0.1 * lost)
            << one.albedo << ' ' << one.bounces << ' ' << one.by_kind;
    }
}

TEST(Path, LimitsByKindHold) {
    const scene::Scene scene = room();
    const camera::Camera camera = pinhole(view_down_z(0.0, 0.0, 1.2));
    Request asked = traced(8, 8, 16);
    asked.path.bounces = {0, 0, 0, 0};
    const float none = mean(render(scene, camera, asked).film).y;
    asked.path.bounces = {12, 0, 0, 12};
    const float by_kind = mean(render(scene, camera, asked).film).y;
    // The two differ by noise alone. One diffuse bounce adds at least twice the tolerance.
    EXPECT_NEAR(by_kind, none, 0.02F * none);
    asked.path.bounces = {12, 1, 0, 12};
    EXPECT_GT(mean(render(scene, camera, asked).film).y, 1.04F * none);
}

TEST(Path, IsTheSameForAnyNumberOfThreadsAndAnyRegion) {
    const scene::Scene scene = room();
    const camera::Camera camera = pinhole(view_down_z(0.0, 0.0, 1.2));
    Request asked = traced(80, 50, 2);
    asked.threads = 1;
    const Film whole = render(scene, camera, asked).film;
    asked.threads = 2;
    EXPECT_EQ(render(scene, camera, asked).film.sum, whole.sum);
    asked.layout.window = Region{37, 13, 30, 29};
    const Film part = render(scene, camera, asked).film;
    for (std::size_t y = 13; y < 42; ++y) {
        for (std::size_t x = 37; x < 67; ++x) {
            ASSERT_EQ(part.sum[part.index(x, y)], whole.sum[whole.index(x, y)]) << x << ' ' << y;
        }
    }
}

TEST(Path, OpacityIsTheMeanOfWhatIsSeen) {
    scene::Scene scene;
    scene::Material pane = glowing(2.0F);
    pane.alpha_mode = scene::AlphaMode::blend;
    pane.alpha = 0.25F;
    add(scene, wall(0.0F, 10.0F), pane);
    const Film film =
        render(scene, orthographic(view_down_z(0.0, 0.0, 1.0)), traced(1, 1, 4096)).film;
    // Five standard errors of a share of 1/4 in 4,096 independent samples; stratified ones are
    // nearer.
    const double tolerance = 5.0 * std::sqrt(0.25 * 0.75 / 4096.0);
    EXPECT_NEAR(film.pixel(0, 0).a, 0.25, tolerance);
    EXPECT_NEAR(film.pixel(0, 0).g, 0.5, 2.0 * tolerance);
}

TEST(Path, AnUnlitSurfaceShowsItsColorAndReflectsNothing) {
    scene::Scene scene;
    scene::Material shown = white();
    shown.base_color = Color3f(0.3F);
    shown.unlit = true;
    add(scene, wall(0.0F, 10.0F), shown);
    scene.lights = {lamp_at(0.0, 0.0, 0.5)};
    shown.roughness = 0.0F;
    Request asked = traced(2, 2, 4);
    for (const char* integrator : {"path", "direct", "preview"}) {
        asked.integrator = integrator;
        // From the side, where a preview would darken it.
        const Film film = render(scene, pinhole(view_down_z(0.0, 0.0, 1.2)), asked).film;
        EXPECT_FLOAT_EQ(film.pixel(0, 0).g, 0.3F) << integrator;
    }
}

TEST(Path, ClampedIndirectLightIsDarkerAndDirectLightIsNot) {
    const scene::Scene scene = room();
    const camera::Camera camera = pinhole(view_down_z(0.0, 0.0, 1.2));
    Request asked = traced(16, 16, 16);
    const float unclamped = mean(render(scene, camera, asked).film).y;
    asked.path.clamp_indirect = 1e-3F;
    const float clamped = mean(render(scene, camera, asked).film).y;
    asked.path.bounces = {0, 0, 0, 0};
    const float direct = mean(render(scene, camera, asked).film).y;
    EXPECT_LT(clamped, 0.95F * unclamped);
    EXPECT_GT(clamped, 0.95F * direct);
}

}  // namespace
}  // namespace balcony::render::test::path_test
