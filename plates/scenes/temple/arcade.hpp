// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the columns carry and what they stand on, made of blocks about the z axis.

#include "balcony/scene.hpp"

namespace balcony::plates::temple {

/// The wall with the arch from column `number` to the next one, with its mouldings.
[[nodiscard]] scene::Mesh arch(int number);

/// The entablature: architrave, frieze, dentils and cornice, closed on all sides.
[[nodiscard]] scene::Mesh ring();

/// Three steps.
[[nodiscard]] scene::Mesh steps();

/// The floor within the steps; its texture is seen from above, upright along y.
[[nodiscard]] scene::Mesh floor_disc();

}  // namespace balcony::plates::temple
