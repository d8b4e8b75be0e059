// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The scenes of the plates.

#include <span>
#include <string_view>

#include "balcony/base.hpp"
#include "balcony/scene.hpp"
#include "common/scene_options.hpp"

namespace balcony::plates {

struct SceneRow {
    std::string_view name;
    std::string_view meaning;  ///< One line.
    Result<scene::Scene> (*make)(const SceneOptions&);
};

[[nodiscard]] std::span<const SceneRow> scene_catalogue();

/// The scene of that name; an unknown name is an error that suggests the nearest one.
[[nodiscard]] Result<scene::Scene> make_scene(std::string_view name, const SceneOptions& options);

}  // namespace balcony::plates
