// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/sampling/pass_offset.hpp"

#include <cmath>

namespace balcony::render {

namespace {

// The inverse of the distribution function of a tent on [-1, 1].
double tent(double uniform) {
    return uniform < 0.5 ? std::sqrt(2.0 * uniform) - 1.0 : 1.0 - std::sqrt(2.0 - 2.0 * uniform);
}

}  // namespace

Imath::V2d pass_offset(std::size_t pass) {
    // Roberts' R2 sequence: steps by the powers of the plastic number's inverse.
    constexpr double plastic = 1.32471795724474602596;
    const auto at = [pass](double step) {
        const double value = 0.5 + static_cast<double>(pass) * step;
        return std::nearbyint(tent(value - std::floor(value)) * 0x1p30) * 0x1p-30;
    };
    return {at(1.0 / plastic), at(1.0 / (plastic * plastic))};
}

}  // namespace balcony::render
