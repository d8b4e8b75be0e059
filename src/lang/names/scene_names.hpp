// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The names that `fit` statements use for the measures of a scene.

#include <span>
#include <string_view>

#include "balcony/lang.hpp"
#include "lang/names/scope.hpp"

namespace balcony::lang {

/// Defines scene_min, scene_max, scene_center, scene_size, scene_inside, scene_radius,
/// scene_profile and scene_profile_length, in some axes, and the same of its surface of revolution:
/// scene_axis, scene_axis_center and so on.
void define_scene_names(const SceneMeasures& scene, Axes axes, expr::Graph& graph, Scope& scope);

/// All these names.
[[nodiscard]] std::span<const std::string_view> scene_names();

/// Stores for all of these names why they cannot be used outside of `fit`.
void announce_scene_names(Scope& scope);

}  // namespace balcony::lang
