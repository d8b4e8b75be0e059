// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Pictures for renderers outside of Balcony: if such a renderer sees what Balcony's own sees, the
// composed picture is that of Balcony.

#include "balcony/picture_samples.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "balcony/catalogue.hpp"
#include "balcony/ray_difference.hpp"
#include "support.hpp"

namespace balcony::render::picture_samples_test {

namespace {

using camera::Layer;
using camera::StageKind;

constexpr std::size_t width = 70;
constexpr std::size_t height = 40;
constexpr std::size_t passes = 3;

// Sees a slope, so that every pixel has another colour.
camera::Camera slanted_camera() {
    test::View view = test::view_down_z(0.3, 0.2, 5.0);
    view.forward = {0.3, 0.1, -1.0};
    return test::pinhole(view);
}

// No ray where u < 0, the left half.
camera::Camera half_blind_camera() {
    const auto origin = [](const camera::ParameterPoint& p, camera::Emitter& emit) {
        emit.require(0.0 <= p.u);
        return camera::ObjectPoint{p.u, p.v, emit(5.0)};
    };
    const auto down = [](const camera::ParameterPoint&, camera::Emitter& emit) {
        return camera::ObjectVector{emit(0.0), emit(0.0), emit(-1.0)};
    };
    return test::make_camera({origin, down});
}

camera::Picture picture(std::vector<Layer> layers) {
    camera::Picture::Parts parts;
    parts.name = "test";
    parts.layers = std::move(layers);
    auto made = camera::Picture::make(std::move(parts));
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return *made;
}

Layer layer(std::string name, const camera::Camera& camera) { return {std::move(name), camera}; }

// In a part of the picture, with a blend mode.
Layer inset(std::string name, const camera::Camera& camera, camera::BlendMode blend) {
    const auto* row = camera::catalogue().find(StageKind::picture_arranger, "place");
    camera::Arguments arguments;
    arguments.set("from", std::vector<camera::Scalar>{0.25, 0.25});
    arguments.set("to", std::vector<camera::Scalar>{1.0, 0.75});
    Layer made = layer(std::move(name), camera);
    made.arrangers = {
        std::static_pointer_cast<const camera::PictureArranger>(*row->make(arguments))};
    made.blend = blend;
    return made;
}

std::shared_ptr<const scene::Scene> sphere_before_wall() {
    auto scene = std::make_shared<scene::Scene>();
    test::add(*scene, test::wall(0.0F, 40.0F), test::white());
    test::add(*scene, test::coarse_sphere(1.5F, 12, 8), test::white());
    scene->default_light = true;
    return scene;
}

Film film_of(std::size_t first_pass) {
    Film film = *make_film({.width = width, .height = height, .data_layers = false});
    film.first_pass = first_pass;
    return film;
}

// The film of some passes by Balcony itself.
Film rendered(const camera::Picture& picture, std::size_t first_pass, std::size_t count) {
    const Renderer renderer = *Renderer::make(sphere_before_wall());
    Settings settings;
    settings.samples = count;
    settings.integrator = "preview";
    settings.sampling.filter = "box";
    Film film = film_of(first_pass);
    const auto summary = render::render(renderer, picture, settings, film);
    EXPECT_TRUE(summary) << to_text(summary.diagnostics);
    return film;
}

PictureSamples samples_of(const camera::Picture& picture) {
    auto samples = PictureSamples::make(picture, {.width = width, .height = height});
    EXPECT_TRUE(samples) << to_text(samples.diagnostics);
    return std::move(*samples.value);
}

}  // namespace

TEST(PictureSamples, ComposeWhatEachLayerShowsAsTheRendererDoes) {
    const std::vector<Layer> layers{layer("back", slanted_camera()),
                                    inset("product", slanted_camera(), camera::BlendMode::multiply),
                                    inset("half", half_blind_camera(), camera::BlendMode::normal)};
    const camera::Picture all = picture(layers);
    PictureSamples samples = samples_of(all);
    ASSERT_EQ(samples.layer_count(), layers.size());
    Film composed = film_of(0);
    samples.prepare(composed);
    for (std::size_t pass = 0; pass < passes; ++pass) {
        std::vector<LayerColors> colors(layers.size());
        rays::RayBatch rays;
        for (std::size_t i = 0; i < layers.size(); ++i) {
            Layer alone = layers[i];
            alone.blend = camera::BlendMode::normal;
            const Film film = rendered(picture({alone}), pass, 1);
            for (const Color4d& sum : film.sum) {
                colors[i].light.emplace_back(sum);
            }
            samples.find_rays(i, pass, {0, 0, width, height}, rays, colors[i].seen);
        }
        samples.add_pass(pass, colors, composed);
    }
    const Film expected = rendered(all, 0, passes);
    EXPECT_EQ(composed.passes, expected.passes);
    EXPECT_EQ(composed.picture_layers, expected.picture_layers);
    for (std::size_t i = 0; i < expected.sum.size(); ++i) {
        for (int channel = 0; channel < 4; ++channel) {
            // The light went through one float more.
            ASSERT_NEAR(composed.sum[i][channel], expected.sum[i][channel], 1e-5) << i;
        }
    }
}

TEST(PictureSamples, WantRaysWhereTheLayerIsSeenAndHasOne) {
    PictureSamples samples =
        samples_of(picture({inset("half", half_blind_camera(), camera::BlendMode::normal)}));
    rays::RayBatch rays;
    std::vector<std::uint8_t> wanted;
    samples.find_rays(0, 0, {0, 0, width, height}, rays, wanted);
    // The inset lies right of 0.25 and from 0.25 to 0.75; its camera has no rays in its left half.
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            const double u = (static_cast<double>(x) + 0.5) / width;
            const double v = (static_cast<double>(y) + 0.5) / height;
            if (std::abs(u - 0.625) > 1.0 / width) {
                EXPECT_EQ(wanted[y * width + x] != 0, u > 0.625 && v > 0.25 && v < 0.75)
                    << x << ", " << y;
            }
        }
    }
}

TEST(PictureSamples, HaveTheRaysOfTheCameraAtTheirPlaces) {
    PictureSamples samples = samples_of(picture({layer("one", slanted_camera())}));
    const Region region{5, 7, 20, 9};
    rays::RayBatch of_pass;
    rays::RayBatch at_points;
    std::vector<std::uint8_t> wanted;
    samples.find_rays(0, 2, region, of_pass, wanted);
    samples.find_rays(0, samples.places(2, region), at_points);
    ASSERT_EQ(of_pass.size(), region.size());
    for (std::size_t i = 0; i < region.size(); ++i) {
        EXPECT_EQ(rays::pixels_between(of_pass[i], at_points[i], 5.0), 0.0);
    }
}

TEST(PictureSamples, RefuseAnUnknownFilter) {
    EXPECT_FALSE(PictureSamples::make(picture({layer("one", slanted_camera())}),
                                      {.width = width, .height = height, .filter = "sinc"}));
}

}  // namespace balcony::render::picture_samples_test
