// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "balcony/picture.hpp"

namespace balcony::camera {

/// The picture that a layer shows; null if it shows a camera.
[[nodiscard]] const Picture* nested(const Layer& layer);

/// Width and height in scene units of what a layer shows, if it has a scale.
[[nodiscard]] std::optional<std::array<double, 2>> sides_of(const Layer& layer);

/// What is wrong with the layers of a picture, each by itself and all together.
[[nodiscard]] Diagnostics check_layers(const Picture::Parts& parts);

}  // namespace balcony::camera
