// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A map over a picture as a smooth function: cubic convolution after R. G. Keys, "Cubic Convolution
// Interpolation for Digital Image Processing" (1981), which passes through the values at the
// centres of the pixels and has continuous derivatives.
//
// A valid pixel is valid as a whole square, up to the middle between it and its neighbours and up
// to the border of the map. The values that this takes outside the valid pixels continue these as
// polynomials.

#include <cstddef>
#include <memory>
#include <vector>

#include "balcony/catalogue.hpp"

namespace balcony::camera {

class CubicMap {
public:
    explicit CubicMap(const PixelMap& map);

    /// The channels at a point of the map, from (0, 0) at its bottom left to (1, 1) at its top
    /// right. No ray where there is no valid pixel.
    [[nodiscard]] std::vector<Expr> operator()(const ParameterPoint& p, Emitter& emit) const;

private:
    double width_;
    double height_;
    std::vector<std::shared_ptr<const expr::Table>> channels_;
    std::shared_ptr<const expr::Table> valid_;
};

}  // namespace balcony::camera
