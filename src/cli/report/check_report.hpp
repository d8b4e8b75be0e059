// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "balcony/studies.hpp"

namespace balcony::cli {

/// What is known of a camera, as text.
[[nodiscard]] std::string check_text(const app::CameraCheck& check);
[[nodiscard]] nlohmann::json check_json(const app::CameraCheck& check);

}  // namespace balcony::cli
