// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <stop_token>

#include "balcony/solving.hpp"

namespace balcony::app {

/// The file of the scene of marks that a file in a folder has; empty if there is none.
[[nodiscard]] std::filesystem::path scene_of(const Marks& marks,
                                             const std::filesystem::path& folder);

/// Gives the marks on objects of the scene their places, and the outlines of objects their points.
[[nodiscard]] Diagnostics place_on_objects(Marks& marks, const std::filesystem::path& scene,
                                           const std::stop_token& stop);

/// Gives the marks in the direction from one mark to another theirs, once those have places.
[[nodiscard]] Diagnostics place_directions(Marks& marks);

}  // namespace balcony::app
