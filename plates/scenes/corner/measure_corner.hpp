// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "balcony/film.hpp"
#include "measure/property.hpp"

namespace balcony::plates {

/// How a picture shows the four pictures of the corner.
struct CornerView {
    std::array<std::size_t, 4> pixels{};
    int wholly_visible = 0;  ///< Those that are one region without missing parts.
    double median_anisotropy = 0.0;
};

[[nodiscard]] CornerView view_corner(const scene::Scene& corner, const render::Film& film);

/// A small picture of the corner through a plate's camera.
[[nodiscard]] render::Film look_at_corner(Studio& studio, const char* camera,
                                          const Overrides& overrides, std::size_t scale = 1);

}  // namespace balcony::plates
