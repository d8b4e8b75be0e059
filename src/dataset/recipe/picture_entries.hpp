// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "balcony/request.hpp"
#include "dataset/recipe/entries.hpp"

namespace balcony::dataset {

/// The table [render]: options of balcony render by their names. What is wrong is reported.
void read_picture(const toml::node& node, const RecipeText& text,
                  const std::filesystem::path& folder, app::Request& picture);

/// A file that a recipe names: in its folder if it is there, otherwise as it is written.
[[nodiscard]] std::string found_in(const std::filesystem::path& folder, const std::string& file);

}  // namespace balcony::dataset
