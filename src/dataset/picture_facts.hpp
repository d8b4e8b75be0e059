// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "balcony/picture_options.hpp"
#include "balcony/request.hpp"

namespace balcony::dataset {

/// The options of balcony render that frames have.
[[nodiscard]] app::Options<app::Request> frame_options();

/// Their values in a request, but for those that no pixel depends on.
[[nodiscard]] nlohmann::json picture_facts(const app::Request& picture);

/// What is prepared for the frames of a scene.
[[nodiscard]] app::Request scene_request(const app::Request& picture, std::string scene_file);

}  // namespace balcony::dataset
