// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Values of requests that only a program can give: errors of Kind::internal, which name the member.
// check_request() looks at those of a picture.

#include "balcony/animation.hpp"
#include "balcony/request.hpp"

namespace balcony::app {

[[nodiscard]] Diagnostics check_size(const SizeRequest& size);
[[nodiscard]] Diagnostics check_unit(const std::optional<double>& meters_per_unit);
/// Those of an animation besides its picture's.
[[nodiscard]] Diagnostics check_frames(const AnimationRequest& request);

}  // namespace balcony::app
