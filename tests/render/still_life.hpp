// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A scene whose objects can each have a layer of their own.

#include <array>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "balcony/picture.hpp"
#include "support.hpp"

namespace balcony::render::test::still_life {

using camera::Compositing;
using camera::Layer;

inline scene::Material colored(const Color3f& color) {
    scene::Material material;
    material.base_color = color;
    material.roughness = 1.0F;
    return material;
}

inline scene::Material clear_glass() {
    scene::Material glass = white();
    glass.transmission = 1.0F;
    glass.roughness = 0.0F;
    glass.thin_walled = false;
    return glass;
}

// A ball in front of a wall, and a slanted board that cuts through the ball; in front of all, a
// small ball of another material. A lamp is on the left.
inline scene::Scene scene_of_parts(const scene::Material& small = clear_glass()) {
    scene::Scene scene;
    const auto place = [](double x, double y, double z) {
        return scene::M44d().translate(scene::V3d(x, y, z));
    };
    add(scene, wall(-3.0F, 8.0F), colored(Color3f(0.6F, 0.5F, 0.4F)));
    add(scene, coarse_sphere(0.8F, 32, 16), colored(Color3f(0.8F, 0.1F, 0.1F)),
        place(0.3, 0.1, -1.0));
    add(scene, parallelogram({-1.0F, -0.6F, -2.2F}, {2.0F, 0.0F, 1.6F}, {0.0F, 1.0F, 0.3F}),
        colored(Color3f(0.1F, 0.3F, 0.8F)));
    add(scene, coarse_sphere(0.3F, 24, 12), small, place(-0.4, 0.3, 0.2));
    const std::array<const char*, 4> names{"wall", "ball 1", "board", "ball 2"};
    for (std::size_t i = 0; i < names.size(); ++i) {
        scene.objects[i].name = names[i];
    }
    scene::Light lamp;
    lamp.position = scene::V3d(-3.0, 2.0, 1.0);
    lamp.intensity = Color3f(30.0F);
    scene.lights = {lamp};
    return scene;
}

inline camera::Camera eye() { return pinhole(view_down_z(0.0, 0.0, 2.0)); }

inline camera::ObjectFilter only(std::vector<std::string> names, bool shows = true) {
    camera::ObjectChoice choice{shows, {}};
    for (std::string& name : names) {
        choice.patterns.push_back({std::move(name)});
    }
    return {choice};
}

inline Layer layer(std::string name, camera::Camera camera, camera::ObjectFilter objects,
                   Compositing compositing = Compositing::order) {
    Layer made{std::move(name), std::move(camera)};
    made.objects = std::move(objects);
    made.compositing = compositing;
    return made;
}

inline camera::Picture picture_of(std::vector<Layer> layers) {
    camera::Picture::Parts parts;
    parts.name = "still life";
    parts.layers = std::move(layers);
    Result<camera::Picture> made = camera::Picture::make(std::move(parts));
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return *made;
}

// The wall, and all else in front of it by depth, each in a layer of its own.
inline camera::Picture in_parts(const camera::Camera& master, const camera::Camera& others) {
    return picture_of({layer("rest", master, only({"ball*", "board"}, false)),
                       layer("ball", others, only({"ball 1"}), Compositing::depth),
                       layer("board", others, only({"board"}), Compositing::depth),
                       layer("glass", others, only({"ball 2"}), Compositing::depth)});
}

template <class Value>
bool are_same(const std::vector<Value>& a, const std::vector<Value>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0;
}

inline Request asked(const std::string& integrator, std::size_t samples = 2) {
    Request made = request(96, 72, integrator, samples);
    made.layout.layers = {LayerId::crypto_object, LayerId::direct, LayerId::emission,
                          LayerId::mean_position};
    made.light.sky_beside_suns = false;
    return made;
}

}  // namespace balcony::render::test::still_life
