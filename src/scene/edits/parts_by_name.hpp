// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "balcony/scene_edits.hpp"

namespace balcony::scene {

/// An error of a name that a new part cannot have: it is empty, or a part of its kind has it.
[[nodiscard]] Diagnostics refuse_object_name(const Scene& scene, const std::string& name);
[[nodiscard]] Diagnostics refuse_material_name(const Scene& scene, const std::string& name);
[[nodiscard]] Diagnostics refuse_light_name(const Scene& scene, const std::string& name);

}  // namespace balcony::scene
