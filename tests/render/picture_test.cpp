// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Pictures of several layers: which rays are traced, and how layers join.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "balcony/catalogue.hpp"
#include "render/job/blend.hpp"
#include "support.hpp"

namespace balcony::render::picture_test {

namespace {

using camera::BlendMode;
using camera::Layer;
using camera::StageKind;
using test::Rendered;
using test::Request;

constexpr std::size_t width = 80;
constexpr std::size_t height = 50;
constexpr std::uint64_t pixels = width * height;

camera::Camera wall_camera() { return test::orthographic(test::view_down_z(0.0, 0.0, 5.0)); }

// Looks away from everything.
camera::Camera sky_camera() {
    test::View view = test::view_down_z(0.0, 0.0, 5.0);
    view.forward = -view.forward;
    return test::orthographic(view);
}

// No ray where u < 0, the left half.
camera::Camera half_blind_camera() {
    const auto wall_ray = [](const camera::ParameterPoint& p, camera::Emitter& emit) {
        emit.require(0.0 <= p.u);
        return camera::ObjectPoint{p.u, p.v, emit(5.0)};
    };
    const auto down = [](const camera::ParameterPoint&, camera::Emitter& emit) {
        return camera::ObjectVector{emit(0.0), emit(0.0), emit(-1.0)};
    };
    return test::make_camera({wall_ray, down});
}

scene::Scene white_wall() {
    scene::Scene scene;
    test::add(scene, test::wall(0.0F, 4.0F), test::white());
    scene.default_light = true;
    return scene;
}

camera::Picture picture(std::vector<Layer> layers) {
    camera::Picture::Parts parts;
    parts.name = "test";
    parts.layers = std::move(layers);
    auto made = camera::Picture::make(std::move(parts));
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return *made;
}

camera::PictureArrangerPointer place(double x0, double y0, double x1, double y1) {
    const auto* row = camera::catalogue().find(StageKind::picture_arranger, "place");
    camera::Arguments arguments;
    arguments.set("from", std::vector<camera::Scalar>{x0, y0});
    arguments.set("to", std::vector<camera::Scalar>{x1, y1});
    return std::static_pointer_cast<const camera::PictureArranger>(*row->make(arguments));
}

Layer layer(std::string name, const camera::Camera& camera) { return {std::move(name), camera}; }

Layer right_half(std::string name, const camera::Camera& camera) {
    Layer made = layer(std::move(name), camera);
    made.arrangers = {place(0.5, 0.0, 1.0, 1.0)};
    return made;
}

Layer group(std::string name, std::vector<Layer> layers) {
    return {std::move(name), std::make_shared<const camera::Picture>(picture(std::move(layers)))};
}

Request preview(std::size_t samples = 1) {
    return test::request(width, height, "preview", samples);
}

std::uint64_t rays(const Summary& summary, const std::string& name) {
    for (const Summary::Layer& layer : summary.layers) {
        if (layer.name == name) {
            return layer.camera_rays;
        }
    }
    ADD_FAILURE() << "no layer " << name;
    return 0;
}

Rendered rendered(std::vector<Layer> layers, std::size_t samples = 1) {
    return test::render(white_wall(), picture(std::move(layers)), preview(samples));
}

}  // namespace

TEST(PictureRays, AnOpaqueLayerLeavesTheOtherHalfToTheOneBelow) {
    const Rendered made =
        rendered({layer("below", wall_camera()), right_half("above", wall_camera())});
    EXPECT_EQ(rays(made.summary, "below"), pixels / 2);
    EXPECT_EQ(rays(made.summary, "above"), pixels / 2);
    EXPECT_EQ(made.summary.camera_rays, pixels);
}

TEST(PictureRays, AHiddenGroupCostsNone) {
    const Rendered made =
        rendered({group("inner", {layer("a", wall_camera()), right_half("b", wall_camera())}),
                  layer("above", wall_camera())});
    EXPECT_EQ(rays(made.summary, "inner/a"), 0U);
    EXPECT_EQ(rays(made.summary, "inner/b"), 0U);
    EXPECT_EQ(rays(made.summary, "above"), pixels);
}

TEST(PictureRays, AGroupHidesWhereOneOfItsLayersDoes) {
    const Rendered made =
        rendered({layer("below", wall_camera()), group("inner", {right_half("b", wall_camera())})});
    EXPECT_EQ(rays(made.summary, "below"), pixels / 2);
    EXPECT_EQ(rays(made.summary, "inner/b"), pixels / 2);
}

TEST(PictureRays, TransparentOrBlendedLayersHideNothing) {
    Layer half_alpha = layer("above", wall_camera());
    half_alpha.alpha = 0.5;
    EXPECT_EQ(rendered({layer("below", wall_camera()), half_alpha}).summary.camera_rays,
              2 * pixels);
    Layer multiplied = layer("above", wall_camera());
    multiplied.blend = BlendMode::multiply;
    EXPECT_EQ(rendered({layer("below", wall_camera()), multiplied}).summary.camera_rays,
              2 * pixels);
    Layer absent = layer("above", wall_camera());
    absent.alpha = 0.0;
    EXPECT_EQ(rendered({layer("below", wall_camera()), absent}).summary.camera_rays, pixels);
}

TEST(PictureRays, WhereALayerHasNoRayTheOneBelowIsSeen) {
    const Rendered made =
        rendered({layer("below", wall_camera()), layer("above", half_blind_camera())});
    EXPECT_EQ(rays(made.summary, "above"), pixels);
    EXPECT_EQ(made.summary.layers[1].invalid_rays, pixels / 2);
    EXPECT_EQ(rays(made.summary, "below"), pixels / 2);
    EXPECT_EQ(made.summary.invalid_pixels, 0U);
    EXPECT_EQ(made.film.pixel(3, 3), made.film.pixel(70, 3));
}

TEST(PictureData, ComeFromTheLayerInFront) {
    Request settings = preview();
    Layer thin = right_half("thin", wall_camera());
    thin.alpha = 0.4;
    const Rendered made = test::render(
        white_wall(),
        picture({layer("below", wall_camera()), right_half("above", sky_camera()), thin}),
        settings);
    ASSERT_EQ(made.film.picture_layers, (std::vector<std::string>{"below", "above", "thin"}));
    const DataLayers& data = *made.film.layers;
    EXPECT_EQ(data.layer[0], 1);
    EXPECT_EQ(data.object[0], 1U);
    EXPECT_EQ(data.layer[width - 1], 2);
    EXPECT_EQ(data.object[width - 1], 0U);
    EXPECT_EQ(data.valid[width - 1], 1);
}

TEST(PictureComposition, ACoveringLayerHidesAlsoWhereItsSceneIsEmpty) {
    const Rendered made =
        rendered({layer("below", wall_camera()), right_half("above", sky_camera())});
    EXPECT_EQ(made.film.pixel(3, 3).a, 1.0F);
    EXPECT_EQ(made.film.pixel(70, 3).a, 0.0F);
}

TEST(PictureComposition, AlphaMixesInLinearLight) {
    Layer above = right_half("above", sky_camera());
    above.alpha = 0.25;
    const Rendered made = rendered({layer("below", wall_camera()), above});
    EXPECT_NEAR(made.film.pixel(70, 3).r, 0.75F * made.film.pixel(3, 3).r, 1e-6);
    EXPECT_NEAR(made.film.pixel(70, 3).a, 0.75F, 1e-6);
}

TEST(PictureComposition, AFrameIsPaintedInsideTheEdge) {
    Layer framed = right_half("above", wall_camera());
    framed.frame = camera::Stroke{0.08, {2.0, 0.0, 0.0}};  // 4 pixels.
    const Rendered made = rendered({layer("below", wall_camera()), framed});
    const auto red = [&](std::size_t x) {
        const Color4f c = made.film.pixel(x, height / 2);
        return c.g < 0.5F * c.r;
    };
    EXPECT_FALSE(red(width / 2 - 1));
    EXPECT_TRUE(red(width / 2));
    EXPECT_TRUE(red(width / 2 + 3));
    EXPECT_FALSE(red(width / 2 + 4));
    EXPECT_EQ(made.film.pixel(width / 2 + 1, height / 2).r, 2.0F);
    // Exposure is for light, not for the frame.
    EXPECT_EQ(made.film.display_color(width / 2 + 1, height / 2), Color4f(2.0F, 0.0F, 0.0F, 1.0F));
    EXPECT_EQ(made.film.light(width / 2 + 1, height / 2), Color4f(0.0F));
    EXPECT_EQ(made.film.display_color(3, 3), Color4f(0.0F));
}

TEST(PictureComposition, ModesLeaveDisplayColoursAlone) {
    Layer framed = layer("below", wall_camera());
    framed.frame = camera::Stroke{0.08, {0.5, 0.25, 0.0}};
    const Rendered alone = rendered({framed});
    for (const BlendMode mode : {BlendMode::multiply, BlendMode::difference, BlendMode::screen}) {
        Layer above = layer("above", wall_camera());
        above.blend = mode;
        const Rendered made = rendered({framed, above});
        EXPECT_EQ(made.film.display_color(1, height / 2), alone.film.display_color(1, height / 2));
        EXPECT_EQ(made.film.light(1, height / 2), Color4f(0.0F))
            << camera::blend_modes()[mode].name;
        EXPECT_EQ(made.film.pixel(width / 2, height / 2).a, 1.0F);
    }
}

// The exposure that suits the light does not depend on what is drawn over it or lies behind it.
TEST(PictureComposition, ExposureSeesOnlyLight) {
    scene::Scene scene;
    scene::Material glow = test::white();
    glow.emission = Color3f(1000.0F);
    test::add(scene, test::wall(0.0F, 0.5F), glow);
    Layer plain = layer("a", wall_camera());
    Request asked = preview();
    const double exposure = automatic_exposure(test::render(scene, picture({plain}), asked).film);
    EXPECT_LT(exposure, -8.0);
    plain.frame = camera::Stroke{0.2, {1.0, 1.0, 1.0}};
    asked.background = Color3f(0.7F);
    const Film film = test::render(scene, picture({plain}), asked).film;
    EXPECT_EQ(automatic_exposure(film), exposure);
    EXPECT_EQ(film.pixel(width / 2, 11).a, 0.0F) << "the background is not in the film";
    EXPECT_EQ(film.background, Color3f(0.7F));
}

TEST(PictureComposition, OneLayerIsTheCameraBitForBit) {
    const scene::Scene scene = white_wall();
    const camera::Camera camera = test::pinhole(test::view_down_z(0.3, 0.2, 3.0));
    const Rendered alone = test::render(scene, camera, preview(4));
    // A paint of no opacity makes it take the way of pictures with several layers.
    Layer framed = layer("camera", camera);
    framed.frame = camera::Stroke{0.0, {}};
    const Rendered composed = test::render(scene, picture({framed}), preview(4));
    for (std::size_t y = 2; y + 2 < height; ++y) {
        for (std::size_t x = 2; x + 2 < width; ++x) {
            ASSERT_EQ(alone.film.pixel(x, y), composed.film.pixel(x, y)) << x << ' ' << y;
        }
    }
}

TEST(PictureComposition, DoesNotDependOnThreads) {
    Layer soft = right_half("above", sky_camera());
    soft.softness = 0.2;
    const camera::Picture wanted = picture({layer("below", wall_camera()), soft});
    Request settings = preview(3);
    settings.threads = 1;
    const Rendered one = test::render(white_wall(), wanted, settings);
    settings.threads = 2;
    const Rendered two = test::render(white_wall(), wanted, settings);
    EXPECT_EQ(one.film.sum, two.film.sum);
}

TEST(PictureBorder, LayersThatTouchItAreComplete) {
    // Mirrored, it still covers the half pixel beyond the border that filters reach.
    Layer mirrored = layer("mirrored", wall_camera());
    const auto* row = camera::catalogue().find(StageKind::picture_arranger, "mirror");
    camera::Arguments arguments;
    arguments.set("axis", std::string("x"));
    mirrored.arrangers = {
        std::static_pointer_cast<const camera::PictureArranger>(*row->make(arguments))};
    const Rendered made = rendered({mirrored}, 16);
    EXPECT_EQ(made.summary.invalid_rays, 0U);
    EXPECT_EQ(made.film.pixel(0, 0).a, 1.0F);
    EXPECT_EQ(made.film.pixel(width - 1, height - 1).a, 1.0F);
}

// The textbook's formulas at one pair of colours, both opaque.
TEST(Blend, FollowsTheFormulas) {
    const float b = 0.3F;
    const float s = 0.8F;
    const std::array<std::pair<BlendMode, double>, 14> cases = {{
        {BlendMode::normal, s},
        {BlendMode::multiply, b * s},
        {BlendMode::screen, b + s - b * s},
        {BlendMode::overlay, 2 * b * s},
        {BlendMode::darken, b},
        {BlendMode::lighten, s},
        {BlendMode::color_dodge, 1.0},
        {BlendMode::color_burn, 1.0 - 0.7 / 0.8},
        {BlendMode::hard_light, b + 0.6 - b * 0.6},
        {BlendMode::soft_light, b + 0.6 * (std::sqrt(0.3) - b)},
        {BlendMode::difference, 0.5},
        {BlendMode::exclusion, b + s - 2 * b * s},
        {BlendMode::add, b + s},
        {BlendMode::subtract, 0.0},
    }};
    for (const auto& [mode, wanted] : cases) {
        const Color4f made = blended(mode, Color4f(b, b, b, 1.0F), Color4f(s, s, s, 1.0F));
        EXPECT_NEAR(made.r, wanted, 1e-6) << camera::blend_modes()[mode].name;
        EXPECT_EQ(made.a, 1.0F) << camera::blend_modes()[mode].name;
    }
}

struct BlendCase {
    BlendMode mode;
    float below, source;
    double wanted;
};

// Both sides of every case distinction, and light brighter than white.
TEST(Blend, FollowsTheFormulasInEveryPart) {
    const std::vector<BlendCase> cases = {
        {BlendMode::overlay, 0.8F, 0.3F, 0.6 + 0.3 - 0.6 * 0.3},
        {BlendMode::hard_light, 0.8F, 0.3F, 2 * 0.8 * 0.3},
        {BlendMode::darken, 0.8F, 0.3F, 0.3},
        {BlendMode::lighten, 0.8F, 0.3F, 0.8},
        {BlendMode::difference, 0.8F, 0.3F, 0.5},
        {BlendMode::subtract, 0.8F, 0.3F, 0.5},
        {BlendMode::soft_light, 0.7F, 0.2F, 0.7 - 0.6 * 0.7 * 0.3},
        {BlendMode::soft_light, 0.2F, 0.8F, 0.2 + 0.6 * (((16 * 0.2 - 12) * 0.2 + 4) * 0.2 - 0.2)},
        {BlendMode::color_dodge, 0.3F, 0.4F, 0.3 / 0.6},
        {BlendMode::color_dodge, 0.0F, 1.0F, 0.0},
        {BlendMode::color_dodge, 0.1F, 1.0F, 1.0},
        {BlendMode::color_burn, 1.0F, 0.0F, 1.0},
        {BlendMode::color_burn, 0.9F, 0.0F, 0.0},
        {BlendMode::color_burn, 0.1F, 0.5F, 0.0},
        {BlendMode::multiply, 3.0F, 0.5F, 1.5},
        {BlendMode::screen, 3.0F, 0.5F, 1.0},
        {BlendMode::exclusion, 3.0F, 0.25F, 0.75},
        {BlendMode::exclusion, 0.25F, 3.0F, 0.75},
    };
    for (const auto& [mode, b, s, wanted] : cases) {
        const Color4f made = blended(mode, Color4f(b, b, b, 1.0F), Color4f(s, s, s, 1.0F));
        EXPECT_NEAR(made.r, wanted, 1e-6)
            << camera::blend_modes()[mode].name << ' ' << b << ' ' << s;
    }
}

// W3C: premultiplied, co = cs (1 - ab) + cb (1 - as) + as ab B(Cb, Cs), channel by channel.
TEST(Blend, MixesByTheAlphasOfBoth) {
    const Color4f below(0.1F, 0.2F, 0.3F, 0.5F);
    const Color4f source(0.2F, 0.04F, 0.12F, 0.4F);
    const Color4f made = blended(BlendMode::multiply, below, source);
    for (int i = 0; i < 3; ++i) {
        // Of colours cb/ab and cs/as the last term is cb cs.
        EXPECT_NEAR(made[i], source[i] * 0.5 + below[i] * 0.6 + below[i] * source[i], 1e-6) << i;
    }
    EXPECT_NEAR(made.a, 1.0 - 0.5 * 0.6, 1e-6);
    // Light without a body, as behind glass, is covered as any other.
    const Color4f light(0.5F, 0.5F, 0.5F, 0.0F);
    EXPECT_NEAR(blended(BlendMode::multiply, light, source).r, 0.2 + 0.6 * 0.5, 1e-6);
}

// Light without display colours.
Drawn drawn(const Color4f& light, float presence) {
    Drawn made;
    made.light = light;
    made.presence = presence;
    return made;
}

TEST(Blend, TwoHalvesPresentAreThreeQuarters) {
    const Color4f color(0.2F, 0.2F, 0.2F, 1.0F);
    for (const BlendMode mode : {BlendMode::normal, BlendMode::multiply}) {
        EXPECT_NEAR(composed(drawn(color, 0.5F), drawn(color, 0.5F), 1.0F, mode).presence, 0.75,
                    1e-6);
        EXPECT_NEAR(composed(drawn(color, 0.5F), drawn(color, 1.0F), 0.5F, mode).presence, 0.75,
                    1e-6);
    }
}

TEST(Blend, TransparentSourcesChangeNothing) {
    const Color4f below(0.2F, 0.3F, 0.1F, 0.5F);
    const Color4f nothing(0.0F);
    for (const auto& [mode, name, meaning] : camera::blend_modes()) {
        if (mode != BlendMode::normal) {
            EXPECT_EQ(blended(mode, below, nothing), below) << name;
        }
        EXPECT_EQ(blended(mode, nothing, below), below) << name;
        EXPECT_EQ(composed(drawn(below, 1.0F), drawn(below, 1.0F), 0.0F, mode).light, below)
            << name;
    }
}

}  // namespace balcony::render::picture_test
