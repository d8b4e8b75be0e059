// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "balcony/prescription.hpp"

namespace balcony::cli {

/// The spots of a lens for light from some directions, in several colours.
struct LensSpots {
    struct Field {
        std::array<double, 2> degrees{};    ///< To the right of the axis and above it.
        std::vector<camera::Spot> spots{};  ///< By wavelength.
    };
    std::vector<double> wavelengths{};
    std::vector<Field> fields{};
};

/// Of the lines F, d and C: above the axis, and of an anamorphic lens also beside it, as far as
/// light passes, up to 60 degrees.
[[nodiscard]] LensSpots find_spots(const camera::Prescription& lens);

/// A table of its optics near the axis and of its spots.
[[nodiscard]] std::string to_text(const camera::Prescription& lens, const LensSpots& spots);
[[nodiscard]] nlohmann::json to_json(const camera::Prescription& lens, const LensSpots& spots);

}  // namespace balcony::cli
