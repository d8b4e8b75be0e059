// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/ray_roots.hpp"

#include <fmt/format.h>

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

Diagnostic bent_rays_error(std::string_view camera, const SourceSpan& bend) {
    return error(fmt::format("the rays of {} are bent, but only straight rays are taken here",
                             camera.empty() ? "this camera" : fmt::format("camera '{}'", camera)),
                 bend, "remove its bend");
}

std::vector<expr::Expr> bend_roots(const camera::RayExpressions& ray, bool footprints, Axes from,
                                   Axes to) {
    std::vector<expr::Expr> roots;
    const auto add = [&](const auto& direction, const auto& knots) {
        const auto add_one = [&](const auto& vector) {
            const auto v = turned(vector, from, to);
            roots.insert(roots.end(), {v.x, v.y, v.z});
        };
        add_one(direction);
        for (const auto& knot : knots) {
            add_one(knot);
        }
    };
    add(ray.bend->direction, ray.bend->knots);
    if (footprints) {
        const camera::BendFootprint slopes = camera::footprint_of_bend(ray);
        add(slopes.direction_by_x, slopes.knots_by_x);
        add(slopes.direction_by_y, slopes.knots_by_y);
    }
    return roots;
}

}  // namespace balcony::rays
