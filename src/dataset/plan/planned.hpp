// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>

#include "balcony/dataset.hpp"
#include "balcony/prepared_scene.hpp"

namespace balcony::dataset {

/// A plan, and the scene that was loaded last for it.
struct Planned {
    Plan plan;
    std::optional<app::PreparedScene> prepared{};
    std::size_t scene = 0;
};

[[nodiscard]] Result<Planned> plan_dataset(const Recipe& recipe, const app::Observer& observer,
                                           const std::stop_token& stop);

}  // namespace balcony::dataset
