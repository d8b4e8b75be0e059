// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Layers that show some of the objects: what their rays meet, and how they are composited.

#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "balcony/picture_samples.hpp"
#include "still_life.hpp"
#include "support.hpp"

namespace balcony::render::test::objects_test {
namespace {

using namespace still_life;

// ------------------------------------------------------------------------------------- by depth

TEST(ObjectsByDepth, PartsWithTheMastersCameraAreThePlainPicture) {
    for (const std::string integrator : {"preview", "direct", "path"}) {
        Request wanted = asked(integrator);
        // Paths of a layer share nothing with those of others. Where light is looked for, and which
        // pixels take more samples because of glass, is found from all layers.
        wanted.path.reuse = false;
        wanted.path.probes_patches = false;
        wanted.path.probes_windows = false;
        const scene::Scene scene =
            integrator == "path" ? scene_of_parts(white()) : scene_of_parts();
        const Film plain = render(scene, eye(), wanted).film;
        const Film parts = render(scene, in_parts(eye(), eye()), wanted).film;
        EXPECT_TRUE(are_same(plain.sum, parts.sum)) << integrator;
        EXPECT_TRUE(are_same(plain.layers->object, parts.layers->object)) << integrator;
        EXPECT_TRUE(are_same(plain.layers->position, parts.layers->position)) << integrator;
        EXPECT_TRUE(are_same(plain.layers->ray_length, parts.layers->ray_length)) << integrator;
        EXPECT_TRUE(are_same(plain.means.direct, parts.means.direct)) << integrator;
        EXPECT_TRUE(are_same(plain.means.objects, parts.means.objects)) << integrator;
        std::set<std::uint32_t> seen(plain.layers->object.begin(), plain.layers->object.end());
        EXPECT_EQ(seen, (std::set<std::uint32_t>{1, 2, 3, 4})) << "each object is in the picture";
    }
}

TEST(ObjectsByDepth, OrderOfLayersDoesNotMatter) {
    const auto with = [](std::vector<std::string> order) {
        std::vector<Layer> layers{layer("rest", eye(), only({"ball*", "board"}, false))};
        for (std::string& name : order) {
            layers.push_back(layer(name, orthographic(view_down_z(0.1, 0.0, 2.0)), only({name}),
                                   Compositing::depth));
        }
        return render(scene_of_parts(), picture_of(std::move(layers)), asked("direct")).film;
    };
    EXPECT_TRUE(are_same(with({"ball 1", "board"}).sum, with({"board", "ball 1"}).sum));
}

// From the side, the board at the same distance from the wall is elsewhere in the picture, but as
// near to the master: the depth is along the master's ray and not along the layer's own.
TEST(ObjectsByDepth, DepthIsAlongTheRaysOfTheMaster) {
    scene::Scene scene;
    add(scene, wall(-2.0F, 20.0F), colored(Color3f(1.0F, 0.0F, 0.0F)));
    add(scene, wall(-4.0F, 20.0F), colored(Color3f(0.0F, 0.0F, 1.0F)));
    // The layer of the far wall stands before the near one, and so close to the far one that its
    // own distances are the smaller ones.
    const auto with = [&](double z, Compositing compositing) {
        const camera::Camera master = orthographic(view_down_z(0.0, 0.0, 0.0));
        const camera::Camera close = orthographic(view_down_z(0.0, 0.0, z));
        return render(scene,
                      picture_of({layer("near", master, only({"object 0"})),
                                  layer("far", close, only({"object 1"}), compositing)}),
                      asked("preview", 1))
            .film;
    };
    EXPECT_EQ(with(-3.5, Compositing::depth).layers->object[0], 1U);
    EXPECT_EQ(with(-3.5, Compositing::order).layers->object[0], 2U);
    EXPECT_EQ(with(-3.5, Compositing::depth).pixel(3, 3).b, 0.0F);
    EXPECT_EQ(with(-3.5, Compositing::order).pixel(3, 3).r, 0.0F);
}

TEST(ObjectsByDepth, WhatIsBehindTheMasterIsNotDrawn) {
    scene::Scene scene;
    add(scene, wall(-2.0F, 20.0F), colored(Color3f(1.0F, 0.0F, 0.0F)));
    add(scene, wall(1.0F, 20.0F), colored(Color3f(0.0F, 0.0F, 1.0F)));
    const Film film =
        render(scene,
               picture_of({layer("front", orthographic(view_down_z(0.0, 0.0, 0.0)), {}),
                           layer("behind", orthographic(view_down_z(0.0, 0.0, 2.0)),
                                 only({"object 1"}), Compositing::depth)}),
               asked("preview", 1))
            .film;
    EXPECT_EQ(film.layers->object[0], 1U);
    EXPECT_EQ(film.pixel(3, 3).b, 0.0F);
    EXPECT_GT(film.pixel(3, 3).r, 0.9F);
}

// A board of half opacity in front of the ball: paths pass it by chance, and meet in each layer
// what they would meet in the whole scene.
TEST(ObjectsByDepth, HalfTransparentObjectsKeepTheirMean) {
    scene::Scene scene = scene_of_parts();
    scene::Material veil = colored(Color3f(0.1F, 0.7F, 0.2F));
    veil.alpha_mode = scene::AlphaMode::blend;
    veil.alpha = 0.4F;
    add(scene, wall(0.9F, 0.5F), veil);
    scene.objects.back().name = "veil";
    Request wanted = asked("path", 256);
    wanted.layout.width = 12;
    wanted.layout.height = 9;
    wanted.path.bounces = {0, 0, 0, 0};
    const Film plain = render(scene, eye(), wanted).film;
    const Film parts =
        render(scene,
               picture_of({layer("rest", eye(), only({"ball 1", "veil"}, false)),
                           layer("ball", eye(), only({"ball 1"}), Compositing::depth),
                           layer("veil", eye(), only({"veil"}), Compositing::depth)}),
               wanted)
            .film;
    double difference = 0.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < plain.sum.size(); ++i) {
        difference += (plain.sum[i].r - parts.sum[i].r) / 256.0;
        sum += plain.sum[i].r / 256.0;
    }
    // 108 pixels of 256 samples, of which each is as large as the mean or nothing, have a standard
    // error of at most 0.6 % of the mean; three times the one of a difference is 2.6 %.
    EXPECT_LT(std::abs(difference), 0.026 * sum);
}

// ------------------------------------------------------------------------------- what is shown

TEST(Objects, HiddenOnesStillCastShadowsAndShowInMirrors) {
    scene::Scene scene;
    scene::Material mirror = white();
    mirror.metallic = 1.0F;
    mirror.roughness = 0.0F;
    add(scene, wall(-3.0F, 4.0F), colored(Color3f(1.0F)));
    // A mirror on the left turns rays to the right, where the post is.
    add(scene, parallelogram({-2.0F, -2.0F, -1.0F}, {0.0F, 0.0F, -2.0F}, {0.0F, 4.0F, 0.0F}),
        mirror);
    add(scene, parallelogram({0.8F, -0.5F, -2.0F}, {0.4F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}),
        colored(Color3f(0.0F, 1.0F, 0.0F)));
    scene::Light sun;
    sun.kind = scene::LightKind::directional;
    sun.direction = V3d(-0.3, 0.0, -1.0);
    scene.lights = {sun};
    const auto with = [&](camera::ObjectFilter objects, const std::string& integrator) {
        return render(scene, picture_of({layer("all", eye(), std::move(objects))}),
                      asked(integrator, 1))
            .film;
    };
    for (const std::string integrator : {"direct", "path"}) {
        const Film plain = with({}, integrator);
        const Film hidden = with(only({"object 2"}, false), integrator);
        std::size_t same = 0;
        std::size_t shadow = 0;
        for (std::size_t i = 0; i < plain.sum.size(); ++i) {
            if (plain.layers->object[i] == 3) {
                EXPECT_NE(hidden.layers->object[i], 3U);
                continue;
            }
            EXPECT_EQ(plain.sum[i], hidden.sum[i]) << integrator << ' ' << i;
            ++same;
            shadow += plain.layers->object[i] == 1 && plain.sum[i].r == 0.0 ? 1 : 0;
        }
        EXPECT_GT(same, 6000U);
        EXPECT_GT(shadow, 20U) << "part of the post's shadow is beside it";
    }
}

TEST(Objects, ALayerOfSomeLeavesTheRestToThoseBehind) {
    const scene::Scene scene = scene_of_parts();
    const Film ball =
        render(scene, picture_of({layer("ball", eye(), only({"ball 1"}))}), asked("path")).film;
    const Film over = render(scene,
                             picture_of({layer("rest", eye(), only({"ball*"}, false)),
                                         layer("ball", eye(), only({"ball 1"}))}),
                             asked("path"))
                          .film;
    std::size_t covered = 0;
    for (std::size_t i = 0; i < ball.sum.size(); ++i) {
        const bool meets = ball.layers->object[i] == 2;
        EXPECT_EQ(ball.layers->valid[i] != 0, meets);
        EXPECT_EQ(over.layers->object[i] == 2, meets);
        EXPECT_EQ(over.layers->layer[i], meets ? 2 : 1);
        covered += meets ? 1 : 0;
    }
    EXPECT_GT(covered, 300U);
    EXPECT_EQ(ball.sum[0], Color4d(0.0)) << "nothing is there, not even the sky";
    EXPECT_EQ(over.pixel(0, 0).a, 1.0F);
}

TEST(Objects, OnlyALayerOfAllOthersShowsTheEnvironment) {
    scene::Scene scene = scene_of_parts();
    scene.lights.clear();
    Request wanted = asked("path", 1);
    wanted.light.environment = Environment::dome();
    scene.objects[0].name = "far wall";
    const auto corner = [&](camera::ObjectFilter objects) {
        return render(scene, picture_of({layer("all", eye(), std::move(objects))}), wanted)
            .film.pixel(0, 0);
    };
    EXPECT_GT(corner(only({"far wall"}, false)).b, 0.1F);
    EXPECT_EQ(corner(only({"ball*"})), Color4f(0.0F));
}

TEST(Objects, FiltersOfNestedPicturesApplyTogether) {
    auto inner = std::make_shared<const camera::Picture>(
        picture_of({layer("round", eye(), only({"ball*"}))}));
    Layer outer{"outer", inner};
    outer.objects = only({"ball 2"}, false);
    const Film film =
        render(scene_of_parts(), picture_of({std::move(outer)}), asked("direct", 1)).film;
    const Film ball = render(scene_of_parts(), picture_of({layer("ball", eye(), only({"ball 1"}))}),
                             asked("direct", 1))
                          .film;
    EXPECT_TRUE(are_same(film.sum, ball.sum));
}

// ------------------------------------------------------------------------------------ parts of it

TEST(Objects, RegionsAreThoseOfTheWhole) {
    const camera::Picture picture = in_parts(eye(), orthographic(view_down_z(0.1, 0.0, 2.0)));
    Request wanted = asked("path");
    wanted.layout.width = 150;
    wanted.path.exact = false;
    const Film whole = render(scene_of_parts(), picture, wanted).film;
    wanted.layout.window = Region{61, 20, 40, 33};
    const Film part = render(scene_of_parts(), picture, wanted).film;
    for (std::size_t y = 20; y < 53; ++y) {
        for (std::size_t x = 61; x < 101; ++x) {
            ASSERT_EQ(part.sum[part.index(x, y)], whole.sum[whole.index(x, y)]) << x << ' ' << y;
            ASSERT_EQ(part.layers->object[part.index(x, y)],
                      whole.layers->object[whole.index(x, y)]);
        }
    }
}

// ---------------------------------------------------------------------------------- bad pictures

TEST(Objects, UnknownNamesAreErrors) {
    const Renderer renderer = renderer_of(scene_of_parts());
    Result<Film> film = make_film(asked("direct").layout);
    const camera::Picture picture = picture_of(
        {layer("rest", eye(), only({"ball*"}, false)), layer("board", eye(), only({"bord"}))});
    const Result<Summary> summary = render::render(renderer, picture, asked("direct"), *film);
    ASSERT_FALSE(summary);
    const std::string text = to_text(summary.diagnostics);
    EXPECT_NE(text.find("layer 2 shows 'bord'"), std::string::npos) << text;
    EXPECT_NE(text.find("did you mean 'board'"), std::string::npos) << text;
}

TEST(Objects, SomeHaveNoTriangles) {
    scene::Scene scene = scene_of_parts();
    add(scene, scene::Mesh{}, white());
    scene.objects.back().name = "nothing";
    const auto with = [&](camera::ObjectFilter objects) {
        return render(scene, picture_of({layer("a", eye(), std::move(objects))}),
                      asked("direct", 1))
            .film.sum;
    };
    EXPECT_EQ(with(only({"nothing"})), std::vector<Color4d>(96 * 72, Color4d(0.0)));
    EXPECT_EQ(with(only({"nothing"}, false)), with(only({"ball*", "board", "wall"})));
}

TEST(Objects, OtherRenderersRefuseThem) {
    const SampleSettings settings{.width = 8, .height = 8};
    const auto said = [&](std::vector<Layer> layers) {
        return to_text(PictureSamples::make(picture_of(std::move(layers)), settings).diagnostics);
    };
    EXPECT_EQ(said({layer("all", eye(), {})}), "");
    EXPECT_NE(said({layer("all", eye(), {}), layer("ball", eye(), only({"ball*"}))})
                  .find("layer 'ball' shows some objects"),
              std::string::npos);
    EXPECT_NE(
        said({layer("a", eye(), {}), layer("b", eye(), {}, Compositing::depth)}).find("by depth"),
        std::string::npos);
}

TEST(ObjectsByDepth, NeedAMasterAndCameras) {
    const auto errors = [](std::vector<Layer> layers) {
        camera::Picture::Parts parts;
        parts.name = "p";
        parts.layers = std::move(layers);
        return to_text(camera::Picture::make(std::move(parts)).diagnostics);
    };
    EXPECT_NE(errors({layer("a", eye(), {}, Compositing::depth)}).find("no layer is behind it"),
              std::string::npos);
    Layer nested{"n", std::make_shared<const camera::Picture>(picture_of({layer("a", eye(), {})}))};
    EXPECT_NE(errors({nested, layer("b", eye(), {}, Compositing::depth)}).find("'n' is a picture"),
              std::string::npos);
    Layer blended = layer("b", eye(), {}, Compositing::depth);
    blended.blend = camera::BlendMode::add;
    EXPECT_NE(errors({layer("a", eye(), {}), blended}).find("remove the blend mode add"),
              std::string::npos);
}

}  // namespace
}  // namespace balcony::render::test::objects_test
