// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "balcony/picture.hpp"
#include "balcony/request.hpp"
#include "balcony/scene.hpp"

namespace balcony::app {

/// The unit that a request gives a scene, if it gives one.
void set_unit(scene::Scene& scene, const std::optional<double>& meters_per_unit);

/// That a picture or camera has no scale, which an option needs.
[[nodiscard]] Diagnostic no_scale(std::string_view option, const std::string& name);

/// A picture in the size that Request::mm_per_pixel says, if it says one. It is an error if the
/// picture has no scale, or the scene no unit.
[[nodiscard]] Result<camera::Picture> at_true_scale(const Request& request,
                                                    const scene::Scene& scene,
                                                    camera::Picture picture);

}  // namespace balcony::app
