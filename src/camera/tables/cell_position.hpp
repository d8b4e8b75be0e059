// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>

#include "balcony/emitter.hpp"

namespace balcony::camera {

/// Maps a parameter in [0, 1] to the position among cells of any widths: the number of the cell and
/// the fraction of it. Tables have equal cells; this map allows a spline with unequal knots in
/// them. It is piecewise linear and exact, and so are its derivatives. Its cost is a table look-up,
/// the same for any number of cells.
class CellPosition {
public:
    /// The breaks increase from 0 to 1. Unless they are equally spaced, no cell may be narrower
    /// than narrowest_cell.
    CellPosition(std::span<const double> breaks, bool closed);
    static constexpr double narrowest_cell = 1.0 / 16384.0;

    /// Wraps a periodic parameter; outside an open range there is no ray.
    [[nodiscard]] Expr operator()(Expr parameter, Emitter& emit) const;

    /// Whether the breaks are equal up to rounding.
    [[nodiscard]] static bool equally_spaced(std::span<const double> breaks);
    [[nodiscard]] static double narrowest(std::span<const double> breaks);

private:
    using TablePointer = std::shared_ptr<const expr::Table>;

    double cells_;
    bool closed_;
    // For unequal cells, over buckets so narrow that none contains two breaks: the break in the
    // bucket, and the position on either side of it. Null for equal cells.
    TablePointer break_, before_, behind_;
};

/// `parameter` minus its integer part if closed; otherwise itself, with no ray outside [0, 1].
[[nodiscard]] Expr within_unit_range(Expr parameter, bool closed, Emitter& emit);

}  // namespace balcony::camera
