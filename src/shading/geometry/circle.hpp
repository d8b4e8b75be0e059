// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

#include "shading/lanes/scalar.hpp"

namespace balcony::render {

#include "shading/geometry/circle.inl"

}  // namespace balcony::render
