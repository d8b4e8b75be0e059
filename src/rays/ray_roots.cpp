// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/ray_roots.hpp"

namespace balcony::rays {

std::vector<expr::Expr> ray_roots(const camera::RayExpressions& central, bool through_lens,
                                  bool footprints, Axes from, Axes to) {
    const camera::RayExpressions ray = through_lens ? camera::through_lens(central) : central;
    std::vector<expr::Expr> roots;
    const auto add = [&](const auto& vector) {
        const auto v = turned(vector, from, to);
        roots.insert(roots.end(), {v.x, v.y, v.z});
    };
    add(ray.origin);
    add(ray.direction);
    roots.push_back(ray.valid);
    if (footprints) {
        const camera::RayFootprint slopes =
            through_lens ? camera::footprint_through_lens(central) : camera::footprint(ray);
        add(slopes.origin_by_x);
        add(slopes.origin_by_y);
        add(slopes.direction_by_x);
        add(slopes.direction_by_y);
    }
    return roots;
}

}  // namespace balcony::rays
