// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "balcony/camera.hpp"

namespace balcony::camera {

/// A stage of a camera that needs another object than it gets.
struct Misfit {
    enum class Of : std::uint8_t { eye_move, toward_move, look, missing_toward };
    Of of = Of::look;
    std::size_t move = 0;     ///< Which of the path's object transformers.
    Diagnostic diagnostic{};  ///< Without a place.
};

/// What does not fit together of the parts that are there.
[[nodiscard]] std::vector<Misfit> misfits(const Camera::Parts& parts);

}  // namespace balcony::camera
