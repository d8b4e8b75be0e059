// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The reports of renders, as JSON and as sentences.

#include "balcony/animation.hpp"
#include "balcony/app.hpp"
#include "cli/report/answer.hpp"

namespace balcony::cli {

[[nodiscard]] Answer answer_of(const app::Report& report, const app::Request& request);
[[nodiscard]] Answer answer_of(const app::MergedPicture& merged);
[[nodiscard]] Answer answer_of(const app::AnimationReport& report,
                               const app::AnimationRequest& request);
[[nodiscard]] Answer answer_of(const app::MergedAnimation& merged);

}  // namespace balcony::cli
