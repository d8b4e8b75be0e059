// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "film/denoise/planes.hpp"

namespace balcony::render {

/// Of the first surface in each pixel, means over the samples.
struct Surfaces {
    std::array<Plane, 3> normal;
    std::array<Plane, 3> position;
    std::array<Plane, 3> albedo;
};

/// Images that are filtered alike, such as the colour of one half of the samples and of the other.
using Stack = std::array<Plane, 6>;

/// A value that tells pixels apart as far as its noise does not explain the difference.
struct Guide {
    Plane value;
    Plane variance;
    float tolerance = 1.0F;  ///< In standard deviations.
};

/// Means over pixels nearby that show the same surface: steps of an edge-avoiding wavelet transform
/// (Dammertz et al., "Edge-Avoiding À-Trous Wavelet Transform for fast Global Illumination
/// Filtering", 2010).
class SurfaceFilter {
public:
    SurfaceFilter(Surfaces surfaces, const Canvas& canvas);

    [[nodiscard]] const Canvas& canvas() const { return canvas_; }
    [[nodiscard]] const Surfaces& surfaces() const { return surfaces_; }

    /// Weighted means over 5 x 5 pixels that are `spacing` apart.
    [[nodiscard]] Stack filtered(const Stack& images, std::size_t spacing,
                                 const Guide* guide) const;

private:
    struct Row;
    void add_distances(const Row& row, float* distances) const;
    void find_sensitivities();
    void find_importances();

    Surfaces surfaces_;
    Canvas canvas_;
    Plane sensitivity_;  ///< What the distances from a pixel are multiplied by.
    Plane importance_;   ///< What the weight of a pixel is multiplied by.
};

}  // namespace balcony::render
