// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "balcony/inspect.hpp"
#include "balcony/studies.hpp"

namespace balcony::live {

/// Adds what is known of a camera, with its places if the picture is the camera.
void add_remarks(const app::CameraCheck& check, std::vector<Remark>& remarks);

}  // namespace balcony::live
