// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/lang.hpp"
#include "lang/session.hpp"

namespace balcony::lang {

/// Says what a camera without errors does.
[[nodiscard]] Explanation explain_camera(const CameraPlace& place, const camera::Camera& camera,
                                         const std::vector<Override>& overrides, Session& session);

}  // namespace balcony::lang
