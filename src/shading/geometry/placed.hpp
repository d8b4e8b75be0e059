// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Imath/ImathMatrix.h>

#include "shading/lanes/scalar.hpp"

namespace balcony::render {

#include "shading/geometry/placed.inl"

}  // namespace balcony::render
