// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The reports of renders, as JSON and as sentences.

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "balcony/animation.hpp"
#include "balcony/app.hpp"

namespace balcony::cli {

[[nodiscard]] nlohmann::json report_json(const app::Report& report);
[[nodiscard]] std::string report_text(const app::Report& report, const app::Request& request);

[[nodiscard]] nlohmann::json report_json(const app::MergedPicture& merged);
[[nodiscard]] std::string report_text(const app::MergedPicture& merged);

[[nodiscard]] nlohmann::json report_json(const app::AnimationReport& report,
                                         const app::AnimationRequest& request);
[[nodiscard]] std::string report_text(const app::AnimationReport& report,
                                      const app::AnimationRequest& request);

[[nodiscard]] nlohmann::json report_json(const app::MergedAnimation& merged);
[[nodiscard]] std::string report_text(const app::MergedAnimation& merged);

}  // namespace balcony::cli
