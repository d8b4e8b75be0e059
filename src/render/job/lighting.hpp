// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "balcony/film.hpp"
#include "balcony/render.hpp"
#include "render/job/picture_rays.hpp"
#include "render/tracing/scene_tracer.hpp"

namespace balcony::render {

/// The lights of a path-traced picture.
struct Lighting {
    LightSet lights;
    std::string description;  ///< As Summary::light.
    std::optional<SubstituteLight> substitute{};
};

/// The lights of the scene with the environment of the settings, or the light that replaces them
/// where there are none: a sky if one can be seen from the surfaces that the picture shows, and
/// otherwise a light at the eye. Beside suns alone, such a sky too if the settings say so.
[[nodiscard]] Lighting lighting_of(const TracedScene& traced, PictureRays& rays, const Film& film,
                                   const Settings& settings);

/// The ambient radiance that follows the light of the scene, by the rule of Settings::ambient. It
/// depends on the whole picture, not on the film's window.
[[nodiscard]] Color3f ambient_of(const TracedScene& traced, PictureRays& rays, const Film& film,
                                 double time);

}  // namespace balcony::render
