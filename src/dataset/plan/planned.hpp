// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <stop_token>

#include "balcony/dataset.hpp"
#include "balcony/prepared_scene.hpp"

namespace balcony::dataset {

/// A plan, and scenes that are still loaded: the last one, and those before it while the program
/// had held fewer bytes than `scene_memory`.
struct Planned {
    Plan plan;
    std::map<std::size_t, app::PreparedScene> scenes{};  ///< By their index.
};

[[nodiscard]] Result<Planned> plan_dataset(const Recipe& recipe, double scene_memory,
                                           const app::Observer& observer,
                                           const std::stop_token& stop);

}  // namespace balcony::dataset
