// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Light from far away that enters rooms by windows.

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "directions.hpp"
#include "shading/lights/distant_lights.hpp"
#include "shading/lights/distant_visibility.hpp"
#include "shading/lights/light_set.hpp"
#include "support.hpp"

namespace balcony::render::test::distant_visibility_test {
namespace {

// A window from the origin: light comes along directions near -y, a little from above.
bool is_open(const V3f& to_light) {
    return to_light.y < -0.9F && to_light.z > 0.1F && to_light.z < 0.3F;
}

Environment sky() { return *Environment::sky(Sky{}); }

// What the window lets reach the neighbourhood of the origin, by the probes of some points.
std::shared_ptr<const DistantVisibility> through_window(const LightSet& lights) {
    Random random(1);
    std::vector<DistantProbe> probes;
    for (int i = 0; i < 500; ++i) {
        std::vector<Imath::V2f> numbers;
        for (int k = 0; k < 64; ++k) {
            numbers.push_back(random.pair());
        }
        probes.push_back(lights.distant().probe(
            random.point(1.0F), numbers,
            [](const V3f& to_light) { return is_open(to_light) ? 1.0F : 0.0F; }));
    }
    return std::make_shared<const DistantVisibility>(std::move(probes));
}

struct Estimate {
    double mean = 0.0;
    double deviation = 0.0;  // Of a sample.
};

// The light from the window on a surface that faces it.
Estimate irradiance(const LightSet& lights, const V3f& position, int draws) {
    const V3f normal(0.0F, -1.0F, 0.0F);
    const LitPoint at{position, normal, normal};
    Random random(2);
    double first = 0.0;
    double second = 0.0;
    for (int draw = 0; draw < draws; ++draw) {
        const auto sample = lights.sample(at, random.numbers());
        if (!sample || !is_open(sample->to_light)) {
            continue;
        }
        EXPECT_NEAR(lights.pdf_of_distant(at, sample->to_light) / sample->pdf, 1.0F, 1e-3F);
        const double light =
            double{sample->radiance.y} * double{-sample->to_light.y} / double{sample->pdf} / draws;
        first += light;
        second += light * light * draws;
    }
    return {first, std::sqrt(second - first * first)};
}

TEST(DistantVisibility, KeepsTheLightOfAWindowAndTakesItsNoise) {
    const scene::Scene empty;
    const LightSet without = LightSet(empty).with(sky());
    const LightSet with = without.with(through_window(without));
    constexpr int draws = 200'000;
    for (const V3f& position : {V3f(0.0F), V3f(0.9F, -0.8F, 0.7F), V3f(50.0F, 0.0F, 0.0F)}) {
        const Estimate expected = irradiance(without, position, draws);
        const Estimate found = irradiance(with, position, draws);
        EXPECT_NEAR(found.mean, expected.mean,
                    4.0 * std::hypot(found.deviation, expected.deviation) / std::sqrt(draws));
        EXPECT_LT(found.deviation, 0.4 * expected.deviation);
    }
}

TEST(DistantVisibility, IsNeverBlindToWhatNoProbeHasSeen) {
    const scene::Scene empty;
    const LightSet without = LightSet(empty).with(sky());
    const LightSet with = without.with(through_window(without));
    const LitPoint at{V3f(0.0F), {0.0F, 0.0F, 1.0F}, V3f(0.0F)};
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const V3f direction = random.direction();
        EXPECT_GT(with.pdf_of_distant(at, direction), 0.0F) << direction;
    }
}

// A closed room of two units with a window in one wall, under a sky whose sun does not shine in.
scene::Scene room() {
    scene::Scene scene;
    scene::Material plaster = white();
    plaster.base_color = Color3f(0.6F);
    const auto add_wall = [&](const V3f& corner, const V3f& right, const V3f& up) {
        add(scene, parallelogram(corner, right, up), plaster);
    };
    const V3f x(2.0F, 0.0F, 0.0F);
    const V3f y(0.0F, 2.0F, 0.0F);
    const V3f z(0.0F, 0.0F, 2.0F);
    add_wall({-1.0F, -1.0F, -1.0F}, x, z);
    add_wall({-1.0F, 1.0F, -1.0F}, x, z);
    add_wall({-1.0F, -1.0F, -1.0F}, x, y);
    add_wall({-1.0F, -1.0F, 1.0F}, x, y);
    add_wall({1.0F, -1.0F, -1.0F}, y, z);
    add_wall({-1.0F, -1.0F, -1.0F}, 0.8F * y, z);
    add_wall({-1.0F, 0.6F, -1.0F}, 0.4F * V3f(0.0F, 1.0F, 0.0F), 0.8F * z);
    return scene;
}

struct Light {
    double mean = 0.0;
    double variance = 0.0;  // Of the mean of a sample's pixel.
};

// Of the picture with independent pixels.
Light light_of(const scene::Scene& scene, bool probes_windows) {
    Request asked = request(24, 24, "path", 64);
    asked.light.environment = sky();
    asked.path.reuse = false;
    asked.path.probes_windows = probes_windows;
    asked.layout.second_moment = true;
    const Film film = render(scene, pinhole(view_down_z(0.0, 0.0, 0.9)), asked).film;
    Light light;
    const auto pixels = static_cast<double>(film.window.size());
    for (std::size_t y = 0; y < 24; ++y) {
        for (std::size_t x = 0; x < 24; ++x) {
            light.mean += double{film.surface_light(x, y).g} / pixels;
            light.variance += film.variance(x, y).g / film.samples(x, y) / (pixels * pixels);
        }
    }
    return light;
}

TEST(DistantVisibility, ARoomWithAWindowHasTheSameLightWithLessNoise) {
    const scene::Scene scene = room();
    const Light without = light_of(scene, false);
    const Light with = light_of(scene, true);
    EXPECT_NEAR(with.mean, without.mean, 4.0 * std::sqrt(with.variance + without.variance));
    EXPECT_LT(with.variance, 0.6 * without.variance);
}

}  // namespace
}  // namespace balcony::render::test::distant_visibility_test
