// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "balcony/camera.hpp"

namespace balcony::bridge {

/// The camera with the rays through the middle of its lens alone, with a warning that says why and
/// what to do; itself if it has no lens.
[[nodiscard]] Result<camera::Camera> with_middle_of_lens(const camera::Camera& camera,
                                                         const std::string& why,
                                                         const std::string& remedy);

}  // namespace balcony::bridge
