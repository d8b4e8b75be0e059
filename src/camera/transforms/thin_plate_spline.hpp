// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace balcony::camera {

/// The radial function of a thin plate at the squared distance r2 > 0: r^2 log r^2 in the plane, -r
/// in space. Both are conditionally positive definite, and at distance 0 they are 0.
[[nodiscard]] double thin_plate_kernel(double squared_distance, std::size_t dimension);

/// A smooth function that interpolates or approximates values at scattered sites: the sum of
/// weights times kernels, and an affine map. Of all functions it minimises
///     mean squared distance from the values + smoothing * bending energy,
/// up to a factor of the energy (J. Duchon 1977; G. Wahba, Spline Models for Observational Data).
struct ThinPlateSpline {
    std::size_t dimension = 2;
    std::size_t results = 2;
    std::vector<double> weights;  ///< Site by site, result by result.
    std::vector<double> affine;   ///< The constant, then a coordinate each, result by result.
};

/// Sites and values in sequence, by coordinate and by result. Nothing if
/// two sites are the same and smoothing is 0, or if all lie on one line (in space on one plane).
/// The time grows with the cube of the number of sites: 1000 take some tenths of a second.
[[nodiscard]] std::optional<ThinPlateSpline> fit_thin_plate(std::span<const double> sites,
                                                            std::size_t dimension,
                                                            std::span<const double> values,
                                                            std::size_t results, double smoothing);

}  // namespace balcony::camera
