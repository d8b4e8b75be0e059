// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Grey images in formulas.

#include <memory>

#include "balcony/catalogue.hpp"
#include "balcony/expr.hpp"

namespace balcony::camera {

/// A table over the pixel centres, counted from 0 at the top left. A side of one pixel becomes two
/// equal pixels.
[[nodiscard]] std::shared_ptr<const expr::Table> grey_table(const GreyImage& image,
                                                            bool invert = false);

/// The grey value at fractions from the top left corner of the image: bilinear between the pixel
/// centres, and constant beyond the outermost ones.
[[nodiscard]] expr::Expr grey_at(const std::shared_ptr<const expr::Table>& grey, expr::Expr x,
                                 expr::Expr y);

}  // namespace balcony::camera
