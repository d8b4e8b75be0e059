// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The motion of a scene whose parts are edited. A scene without motion is left alone.

#include <cstddef>
#include <functional>
#include <optional>

#include "balcony/motion.hpp"

namespace balcony::scene {

/// A number after an edit; nothing if the part is gone.
using NewNumber = std::function<std::optional<std::size_t>(std::size_t)>;

void renumber_instances(Scene& scene, const NewNumber& number);
void renumber_meshes(Scene& scene, const NewNumber& number);
void renumber_lights(Scene& scene, const NewNumber& number);

/// The instances of an object stand still from now on.
void stop_object(Scene& scene, std::size_t object);
void stop_light(Scene& scene, std::size_t light);

/// Transforms the paths of the instances of an object that move, and of nothing else. They stand
/// where their paths have them at the time of the scene.
void transform_paths(Scene& scene, std::size_t object, const M44d& change);

}  // namespace balcony::scene
