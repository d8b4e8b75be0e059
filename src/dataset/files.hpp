// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Names of files and their texts, for the manifest and the layouts.

#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "balcony/dataset.hpp"

namespace balcony::dataset {

/// A file of a frame in the folder of the data set: SCENE/LAYER/CAMERA-POSE.png.
[[nodiscard]] std::string layer_file(const Plan& plan, const Frame& frame, std::string_view layer);
/// The same in the folder of its scene: LAYER/CAMERA-POSE.png.
[[nodiscard]] std::string layer_file_in_scene(const Frame& frame, std::string_view layer);

/// The rows of a pose with a fourth one, in axes of cameras and of the world.
[[nodiscard]] nlohmann::json matrix_json(const camera::Pose& pose, const std::string& axes,
                                         Axes world);

/// An object of JSON as a text with a line for each entry, and for each element of its lists.
[[nodiscard]] std::string dumped(const nlohmann::json& json);

}  // namespace balcony::dataset
