// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The columns, in the Corinthian order, and broken pieces of them.

#include "balcony/scene.hpp"

namespace balcony::plates::temple {

/// A column about the z axis: base, fluted shaft of five drums, and capital, with the block from
/// which the arches spring. Each number has another weathering. Its sides look along x and y.
[[nodiscard]] scene::Mesh column(int number);

/// A capital about the z axis from z = 0, 1 high.
[[nodiscard]] scene::Mesh capital();

/// A drum of a fallen column about the z axis from z = 0, with both its faces.
[[nodiscard]] scene::Mesh fallen_drum(int number, double length);

}  // namespace balcony::plates::temple
