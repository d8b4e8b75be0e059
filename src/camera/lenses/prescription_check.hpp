// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What is wrong with surfaces of a lens, besides what check() finds: it depends on light and focus.

#include <optional>

#include "balcony/prescription.hpp"

namespace balcony::camera {

/// If the medium behind a surface has no index for a wavelength.
[[nodiscard]] std::optional<Diagnostic> wrong_index(const LensSurface& s, double wavelength);

/// If two neighbours with this gap on the axis cross within both holes.
[[nodiscard]] std::optional<Diagnostic> crossing_of(const LensSurface& s, const LensSurface& next,
                                                    double gap);

}  // namespace balcony::camera
