// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "balcony/camera.hpp"
#include "balcony/lang.hpp"
#include "lang/session.hpp"

namespace balcony::lang {

/// Makes a camera from its syntax and reports what is wrong with it; nothing if there is an error.
[[nodiscard]] std::optional<camera::Camera> build_camera(const CameraPlace& place,
                                                         const std::vector<Override>& overrides,
                                                         Session& session);

}  // namespace balcony::lang
