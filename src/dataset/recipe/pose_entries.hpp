// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "balcony/dataset.hpp"
#include "dataset/recipe/entries.hpp"

namespace balcony::dataset {

/// A table of [[poses]]. What is wrong is reported.
[[nodiscard]] std::optional<PoseGroup> pose_group_in(const toml::node& node,
                                                     const RecipeText& text);

}  // namespace balcony::dataset
