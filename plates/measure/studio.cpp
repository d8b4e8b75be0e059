// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "measure/studio.hpp"

#include <stdexcept>

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

render::Film Studio::look(const Look& look, const Overrides& overrides) {
    const camera::Picture picture = checked(
        lang::make_picture(std::string(BALCONY_PLATES) + "/" + look.camera, look.name, overrides));
    render::Settings settings;
    settings.samples = 1;
    settings.integrator = "preview";
    render::Film film = checked(render::make_film({.width = look.width, .height = look.height}));
    checked(render::render(*set(look.scene, look.pictures_and_walls).renderer, picture, settings,
                           film));
    return film;
}

}  // namespace balcony::plates
