// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>

#include "balcony/rays.hpp"

#include "rays/results.hpp"

namespace balcony::rays {

namespace {

using Elements = std::vector<camera::PictureExpressions::Element>;

void add_times(const Elements& elements, std::vector<expr::Expr>& times) {
    for (const camera::PictureExpressions::Element& element : elements) {
        if (element.ray && element.ray->time) {
            times.push_back(*element.ray->time);
        }
        add_times(element.group, times);
    }
}

}  // namespace

Result<RayTimes> ray_times(const camera::Picture& picture, const RayTimes& times) {
    constexpr double height = 256.0;
    const double width = std::clamp(std::round(height * picture.aspect()), 1.0, 4096.0);
    return within_limits<RayTimes>("picture", picture.name(), [&]() -> Result<RayTimes> {
        expr::Graph graph;
        std::vector<expr::Expr> roots;
        add_times(picture.emit(graph, width, height).elements, roots);
        if (roots.empty()) {
            return times;
        }
        const Result<program::Program> made = program::Program::make(roots);
        if (!made) {
            return made.diagnostics;
        }
        // With a point on each corner and border.
        Tile grid{0.0, 0.0, 1.0, static_cast<std::size_t>(width) + 1,
                  static_cast<std::size_t>(height) + 1};
        Scratch scratch;
        program::ResultArrays values;
        RayTimes all = times;
        for (const double time : {times.first, 0.5 * (times.first + times.last), times.last}) {
            grid.time = time;
            const std::size_t count = grid.width * grid.height;
            program::run(*made, grid, scratch, values.reserve(roots.size(), count));
            for (std::size_t root = 0; root < roots.size(); ++root) {
                for (std::size_t i = 0; i < count; ++i) {
                    if (const double found = values[root][i]; std::isfinite(found)) {
                        all.first = std::min(all.first, found);
                        all.last = std::max(all.last, found);
                    }
                }
            }
        }
        return all;
    });
}

}  // namespace balcony::rays
