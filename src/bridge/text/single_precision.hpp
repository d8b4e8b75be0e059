// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "bridge/text/camera_formulas.hpp"

namespace balcony::bridge {

/// Compares the rays of formulas with footprints in single precision, as a processor computes
/// them, with the exact ones, in a picture of a size in pixels. The parameters have their values,
/// and a lens is a point.
[[nodiscard]] SinglePrecision measure_single_precision(
    const CameraFormulas& formulas, const std::vector<ExportParameter>& parameters,
    const std::array<std::size_t, 2>& size);

}  // namespace balcony::bridge
