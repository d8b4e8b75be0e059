// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A table of a function that is smooth between given places.

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "balcony/emitter.hpp"

namespace balcony::camera::maps {

/// Polynomials of degree 7 in equal cells of each piece.
class PiecewiseTable {
public:
    using Function = std::function<double(std::size_t piece, double place)>;
    /// By how much a value of the table is wrong at a place, in radii of the sphere on the map.
    using Error = std::function<double(std::size_t piece, double place, double value)>;

    /// The pieces lie between consecutive places, which increase. The number of cells is doubled
    /// until no error between the nodes exceeds the largest; nothing if one always does, or if the
    /// function has no value.
    [[nodiscard]] static std::optional<PiecewiseTable> make(std::span<const double> places,
                                                            const Function& function,
                                                            const Error& error, double largest);

    [[nodiscard]] Expr operator()(Expr place, Emitter& emit) const;

private:
    std::vector<double> places_;
    std::shared_ptr<const expr::Table> values_;  ///< By piece, from 0 to 1 in each.
    std::shared_ptr<const expr::Table> starts_;  ///< By piece: where it starts,
    std::shared_ptr<const expr::Table> scales_;  ///< and 1 divided by its length.
};

}  // namespace balcony::camera::maps
