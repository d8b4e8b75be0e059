// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "balcony/dataset.hpp"

namespace balcony::dataset {

/// The files of a frame: those of its layers, in the order of the recipe, then those of its
/// layouts.
[[nodiscard]] std::vector<std::filesystem::path> files_of(const Plan& plan, const Frame& frame);

/// What differs between the recipes of two manifests that a frame depends on, in words; empty if
/// nothing does. Nothing if the first one is no manifest.
[[nodiscard]] std::optional<std::string> difference(const std::string& before,
                                                    const std::string& now);
/// The files of all frames of a manifest.
[[nodiscard]] std::vector<std::string> files_in(const std::string& manifest);

}  // namespace balcony::dataset
