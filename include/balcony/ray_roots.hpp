// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The formulas of a camera's ray, as a list of numbers to compute.

#include <cstddef>
#include <string_view>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/camera.hpp"

namespace balcony::rays {

/// Where the list has what; vectors have three entries.
struct RayRoots {
    static constexpr std::size_t origin = 0;
    static constexpr std::size_t direction = 3;
    static constexpr std::size_t valid = 6;
    /// What `valid` is where a lens lets no light through; otherwise it is 1 or 0.
    static constexpr double is_blocked = -1.0;
    static constexpr std::size_t end_of_ray = 7;
    // With footprints, the derivatives with respect to picture x and y follow.
    static constexpr std::size_t origin_by_x = 7;
    static constexpr std::size_t origin_by_y = 10;
    static constexpr std::size_t direction_by_x = 13;
    static constexpr std::size_t direction_by_y = 16;
    static constexpr std::size_t end_of_footprints = 19;
};

/// The formulas of a ray in the requested axes; `from` are those of its camera. `through_lens`, for
/// a camera with a lens, is the ray through a point of the lens instead of its middle. Throws
/// expr::GraphTooLarge if the derivatives do not fit into the graph.
[[nodiscard]] std::vector<expr::Expr> ray_roots(const camera::RayExpressions& ray,
                                                bool through_lens, bool footprints, Axes from,
                                                Axes to);

/// The error of those who take straight rays only, for a camera that bends its rays; its name may
/// be unknown.
[[nodiscard]] Diagnostic bent_rays_error(std::string_view camera = {}, const SourceSpan& bend = {});

/// The formulas of the rest of a bent ray, in the same way: its last direction, its knots, and with
/// footprints the derivatives of all these by picture x, and then by y.
[[nodiscard]] std::vector<expr::Expr> bend_roots(const camera::RayExpressions& ray, bool footprints,
                                                 Axes from, Axes to);

}  // namespace balcony::rays
