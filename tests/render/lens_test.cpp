// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Pictures through lenses: sharp where they are focused, blurred as a thin lens does elsewhere; the
// distance of an object; data without blur. And rays with times of their own.

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "balcony/lang.hpp"
#include "balcony/make_stage.hpp"
#include "support.hpp"

namespace balcony::render::test::lens_test {
namespace {

constexpr std::size_t size = 65;
constexpr std::size_t samples = 256;

// A camera at the origin that looks along -z; its picture spans -1 .. 1 at the distance 1.
camera::Camera with_lens(const camera::Camera& camera, double radius,
                         camera::FocusSurfacePointer focus) {
    camera::Camera::Parts parts = camera.parts();
    parts.lens = *camera::make_stage<camera::Lens>(
        "lens", {{"radius", radius}, {"focus", std::shared_ptr<const camera::Stage>(focus)}});
    Result<camera::Camera> made = camera::Camera::make(std::move(parts));
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return *made;
}

camera::Camera pinhole() { return test::pinhole(view_down_z(0.0, 0.0, 0.0)); }

camera::FocusSurfacePointer flat(double distance) {
    return *camera::make_stage<camera::FocusSurface>("flat", {{"distance", distance}});
}

camera::FocusSurfacePointer on(const std::string& object) {
    return *camera::make_stage<camera::FocusSurface>("on", {{"object", object}});
}

// A small square that emits light, in front of the camera.
scene::Scene lamp(float distance) {
    scene::Scene scene;
    scene::Material material = white();
    material.base_color = scene::Color3f(0.0F);
    material.emission = scene::Color3f(1.0F);
    add(scene, wall(-distance, 0.03F * distance), material);
    return scene;
}

// The picture as the light of each pixel.
std::vector<double> light(const Rendered& rendered) {
    std::vector<double> found;
    for (std::size_t i = 0; i < rendered.film.sum.size(); ++i) {
        found.push_back(rendered.film.sum[i].g / static_cast<double>(samples));
    }
    return found;
}

struct Spot {
    double total = 0.0;
    double radius = 0.0;  // From the second moment, as of an even disc, in the plane at distance 1.
};

Spot spot(const std::vector<double>& light) {
    Spot made;
    double moment = 0.0;
    const double middle = 0.5 * static_cast<double>(size - 1);
    for (std::size_t i = 0; i < light.size(); ++i) {
        const double x = static_cast<double>(i % size) - middle;
        const double y = static_cast<double>(i / size) - middle;
        made.total += light[i];
        moment += light[i] * (x * x + y * y);
    }
    made.radius = std::sqrt(2.0 * moment / made.total) * 2.0 / static_cast<double>(size);
    return made;
}

}  // namespace

// A small lamp at the distance z is blurred to a disc of radius r |1/s - 1/z|, with the same light.
TEST(LensPicture, IsBlurredLikeAThinLens) {
    constexpr double radius = 0.8;
    for (const double z : {2.0, 4.0, 8.0}) {
        const scene::Scene scene = lamp(static_cast<float>(z));
        const Request wanted = request(size, size, "direct", samples);
        const Spot sharp = spot(light(render(scene, pinhole(), wanted)));
        const Spot blurred =
            spot(light(render(scene, with_lens(pinhole(), radius, flat(4.0)), wanted)));
        // Second moments of a convolution add up.
        const double own =
            std::sqrt(std::max(0.0, blurred.radius * blurred.radius - sharp.radius * sharp.radius));
        // Some thousand samples hit the lamp. Three standard deviations are 10 % of their number,
        // and 3 % of the root of their mean square distance. The aperture is across each ray, so
        // that it is smaller by the cosine of its angle of at most 0.2.
        EXPECT_NEAR(own, radius * std::abs(0.25 - 1.0 / z), 0.03 * blurred.radius + 0.01) << z;
        EXPECT_NEAR(blurred.total, sharp.total, 0.1 * sharp.total) << z;
    }
}

TEST(LensPicture, OfRadiusZeroIsThatOfThePinhole) {
    const scene::Scene scene = lamp(3.0F);
    const Request wanted = request(size, size, "direct", 4);
    const Rendered a = render(scene, pinhole(), wanted);
    const Rendered b = render(scene, with_lens(pinhole(), 0.0, flat(4.0)), wanted);
    EXPECT_EQ(a.film.sum, b.film.sum);
}

TEST(LensPicture, HasTheDataOfTheCentralRays) {
    const scene::Scene scene = lamp(3.0F);
    const Request wanted = request(size, size, "direct", 2);
    const Rendered a = render(scene, pinhole(), wanted);
    const Rendered b = render(scene, with_lens(pinhole(), 1.0, flat(6.0)), wanted);
    EXPECT_NE(a.film.sum, b.film.sum);
    EXPECT_EQ(a.film.layers->ray_length, b.film.layers->ray_length);
    EXPECT_EQ(a.film.layers->object, b.film.layers->object);
    EXPECT_EQ(a.film.layers->origin, b.film.layers->origin);
}

// The distance to an object is measured along the rays that see it first.
TEST(LensPicture, IsSharpOnTheNamedObject) {
    scene::Scene scene = lamp(3.0F);
    const Request wanted = request(size, size, "direct", samples);
    const Spot sharp = spot(light(render(scene, pinhole(), wanted)));
    const Spot focused =
        spot(light(render(scene, with_lens(pinhole(), 1.0, on("object 0")), wanted)));
    EXPECT_NEAR(focused.radius, sharp.radius, 0.02);
    // Far in front of a wall, so that focusing on the wall blurs it.
    add(scene, wall(-12.0F, 20.0F), white());
    const Spot beyond =
        spot(light(render(scene, with_lens(pinhole(), 1.0, on("object 1")), wanted)));
    EXPECT_GT(beyond.radius, sharp.radius + 0.1);
}

TEST(LensPicture, IsFocusedOnAHiddenObjectByItsMiddle) {
    scene::Scene scene = lamp(3.0F);
    add(scene, wall(-6.0F, 0.01F), white());  // Behind the lamp.
    const Request wanted = request(size, size, "direct", samples);
    const auto picture = light(render(scene, with_lens(pinhole(), 1.0, on("object 1")), wanted));
    const auto at_6 = light(render(scene, with_lens(pinhole(), 1.0, flat(6.0)), wanted));
    EXPECT_NEAR(spot(picture).radius, spot(at_6).radius, 0.01);
}

// Everything is lit alike, so a sample shows 1 or, where the mount takes its light, 0: a dark
// corner, and not a hole in the picture.
TEST(LensPicture, IsDarkWhereALensOfGlassBlocksTheLight) {
    const auto text = std::make_shared<const SourceText>(
        "lens.cam",
        "camera a { aspect 1  map u = 0.5 .. -0.5, v = square  eye point  toward plane((1, 0, 0)) "
        "look absolute  lens table(\"petzval.dat\", unit = 1, focus = 3000) }");
    const Result<camera::Camera> through = lang::make_camera(text, "");
    ASSERT_TRUE(through) << to_text(through.diagnostics);
    scene::Scene scene;
    scene::Material lit = white();
    lit.base_color = scene::Color3f(0.0F);
    lit.emission = scene::Color3f(1.0F);
    add(scene,
        parallelogram({3000.0F, 9000.0F, -9000.0F}, {0.0F, -18000.0F, 0.0F},
                      {0.0F, 0.0F, 18000.0F}),
        lit);
    for (const char* integrator : {"direct", "path"}) {
        const Rendered made = render(scene, *through, request(size, size, integrator, 16));
        const RayCounts& counts = made.summary.layers[0];
        EXPECT_EQ(counts.camera_rays, size * size * 16) << integrator;
        EXPECT_EQ(counts.invalid_rays, 0U) << integrator;
        EXPECT_EQ(counts.hits + counts.blocked_rays, counts.camera_rays) << integrator;
        double sum = 0.0;
        for (const auto& pixel : made.film.sum) {
            EXPECT_EQ(pixel.a, 16.0F);
            sum += static_cast<double>(pixel.g);
        }
        // Of four samples at the border of a lamp, the mean is shown and one is counted.
        EXPECT_NEAR(sum, static_cast<double>(counts.hits), 0.01 * sum) << integrator;
        EXPECT_EQ(made.film.sum.front().g, 0.0F) << integrator;
        EXPECT_GT(made.film.sum[(size / 2) * size + size / 2].g, 4.0F) << integrator;
    }
}

TEST(LensPicture, OfAnUnknownObjectIsAnError) {
    const Result<Renderer> renderer = Renderer::make(std::make_shared<scene::Scene>(lamp(3.0F)));
    const auto film = std::make_shared<Film>(*make_film({.width = 8, .height = 8}));
    const Result<Job> job = Job::make(*renderer, with_lens(pinhole(), 1.0, on("objekt 0")),
                                      request(8, 8, "direct", 1), film);
    EXPECT_FALSE(job);
    EXPECT_NE(to_text(job.diagnostics).find("did you mean 'object 0'?"), std::string::npos)
        << to_text(job.diagnostics);
}

}  // namespace balcony::render::test::lens_test
