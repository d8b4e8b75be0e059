// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "measure/studio.hpp"

#include <stdexcept>

#include "balcony/motion.hpp"
#include "balcony/rays.hpp"
#include "scenes/catalogue.hpp"

namespace balcony::plates {

namespace {

constexpr double texture_scale = 0.02;  // colours do not matter here

template <class T>
T checked(Result<T> result) {
    if (!result) {
        throw std::runtime_error(to_text(result.diagnostics));
    }
    return std::move(*result);
}

}  // namespace

const Studio::Set& Studio::set(const std::string& name, bool pictures_and_walls) {
    Set& set = sets_[{name, pictures_and_walls}];
    if (!set.scene) {
        set.scene = std::make_shared<const scene::Scene>(
            checked(make_scene(name, {pictures_and_walls, texture_scale})));
        set.renderer =
            std::make_shared<const render::Renderer>(checked(render::Renderer::make(set.scene)));
    }
    return set;
}

const scene::Scene& Studio::scene(const std::string& name, bool pictures_and_walls) {
    return *set(name, pictures_and_walls).scene;
}

// What moves is where it stands at the times of the picture's rays.
render::Renderer Studio::renderer_for(const Set& set, const camera::Picture& picture) {
    if (!set.scene->motion) {
        return *set.renderer;
    }
    const rays::RayTimes times = checked(rays::ray_times(picture, {}));
    return checked(render::Renderer::make(
        set.scene, {.interval = scene::TimeInterval{times.first, times.last}}));
}

render::Film Studio::look(const Look& look, const Overrides& overrides) {
    const camera::Picture picture = checked(
        lang::make_picture(std::string(BALCONY_PLATES) + "/" + look.camera, look.name, overrides));
    render::Settings settings;
    settings.samples = 1;
    settings.integrator = "preview";
    render::Film film = checked(render::make_film({.width = look.width, .height = look.height}));
    checked(render::render(renderer_for(set(look.scene, look.pictures_and_walls), picture), picture,
                           settings, film));
    return film;
}

}  // namespace balcony::plates
