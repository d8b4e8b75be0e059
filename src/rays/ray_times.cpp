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

// With the values that the cameras know for their further inputs.
std::vector<expr::Expr> with_known_inputs(const camera::Picture& picture, expr::Graph& graph,
                                          const std::vector<expr::Expr>& times) {
    std::vector<expr::Substitution> known;
    for (const camera::ShownCamera& shown : camera::shown_cameras(picture)) {
        for (const camera::KnownInput& input : shown.camera.parts().inputs) {
            known.push_back({graph.input(input.name), graph.constant(input.value)});
        }
    }
    return expr::substitute(graph, times, known);
}

}  // namespace

Result<RayTimes> ray_times(const camera::Picture& picture, const RayTimes& times,
                           const std::stop_token& stop) {
    constexpr double height = 256.0;
    const double width = std::clamp(std::round(height * picture.aspect()), 1.0, 4096.0);
    const auto find = [&](expr::Graph& graph) -> Result<RayTimes> {
        std::vector<expr::Expr> roots;
        add_times(picture.emit(graph, width, height).elements, roots);
        if (roots.empty()) {
            return times;
        }
        const Result<program::Program> made =
            program::Program::make(with_known_inputs(picture, graph, roots));
        if (!made) {
            return made.diagnostics;
        }
        // With a point on each corner and border, row by row.
        Tile row{0.0, 0.0, 1.0, static_cast<std::size_t>(width) + 1, 1};
        Scratch scratch;
        program::ResultArrays values;
        RayTimes all = times;
        for (const double time : {times.first, 0.5 * (times.first + times.last), times.last}) {
            row.time = time;
            for (row.y = 0.0; row.y <= height; row.y += 1.0) {
                if (stop.stop_requested()) {
                    return stopped();
                }
                program::run(*made, row, scratch, values.reserve(roots.size(), row.width));
                for (std::size_t root = 0; root < roots.size(); ++root) {
                    for (std::size_t i = 0; i < row.width; ++i) {
                        if (const double found = values[root][i]; std::isfinite(found)) {
                            all.first = std::min(all.first, found);
                            all.last = std::max(all.last, found);
                        }
                    }
                }
            }
        }
        return all;
    };
    return within_limits<RayTimes>("picture", picture.name(), {width, height}, stop, find);
}

}  // namespace balcony::rays
