// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include <Imath/ImathVec.h>

#include "balcony/povray.hpp"

namespace balcony::bridge::povray {

using Imath::V3d;

/// How a vector with y up, right-handed, is written in a scene.
struct AxesRow {
    PovrayAxes info;
    V3d (*from_y_up)(const V3d& v);
};

[[nodiscard]] const AxesRow* find_axes(std::string_view name);

}  // namespace balcony::bridge::povray
