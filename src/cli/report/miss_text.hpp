// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "balcony/probe.hpp"

namespace balcony::cli {

/// Why the rays of a camera meet nothing, as far as it can be known, and what may help.
struct MissText {
    std::string reason;
    std::string remedy;
};

[[nodiscard]] MissText miss_text(const render::Miss& miss, const camera::Camera& camera);

}  // namespace balcony::cli
