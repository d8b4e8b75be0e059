// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/lenses/disc.hpp"

#include <numbers>

namespace balcony::camera {

PolarPoint on_disc(const AperturePoint& square, const Emitter& emit) {
    using std::numbers::pi;
    const auto& [x, y] = square;
    const Expr wide = abs(y) < abs(x);
    const Expr radius = select(wide, abs(x), abs(y));
    // From the axis that is nearest; the centre has the angle 0 from it.
    const Expr ratio = select(wide, y / x, select(0.0 < radius, -(x / y), emit(0.0)));
    const Expr axis = select(wide, select(x < 0.0, emit(pi), emit(0.0)),
                             select(y < 0.0, emit(1.5 * pi), emit(0.5 * pi)));
    const Expr angle = axis + pi / 4.0 * ratio;
    return {radius, select(angle < 0.0, angle + 2.0 * pi, angle)};
}

Diagnostic too_few_blades(std::size_t blades) {
    return error(
        blades == 1 ? "an aperture cannot have 1 blade" : "an aperture cannot have 2 blades", {},
        "write 3 or more for a polygon, or 0 for a round aperture");
}

}  // namespace balcony::camera
