// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>

#include "balcony/base.hpp"

namespace balcony::bridge::povray {

/// The scene of a user and the copy that POV-Ray reads in its place.
struct ScenePlaces {
    std::shared_ptr<const SourceText> scene;
    std::filesystem::path copy;
    std::filesystem::path folder;  ///< Of the scene, where POV-Ray runs.
};

/// The errors and warnings in POV-Ray's output, in its own words, at the places in the user's
/// files. Those about the camera that Balcony adds are omitted.
[[nodiscard]] Diagnostics read_messages(std::string_view output, const ScenePlaces& places);

/// The part of the picture that is done, from 0 to 1, as the end of some output says.
[[nodiscard]] std::optional<double> read_progress(std::string_view output);

}  // namespace balcony::bridge::povray
