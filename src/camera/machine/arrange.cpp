// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/machine/arrange.hpp"

namespace balcony::camera {

PicturePoint whole_picture(Graph& graph, double width, double height) {
    return {{graph.picture_x(), graph.picture_y()},
            {graph.constant(width), graph.constant(height)}};
}

PicturePoint arranged(PicturePoint whole, std::span<const PictureArrangerPointer> arrangers,
                      Emitter& emit) {
    for (const PictureArrangerPointer& arranger : arrangers) {
        whole = arranger->arrange(whole, emit);
    }
    return whole;
}

std::array<double, 2> arranged_size(std::span<const PictureArrangerPointer> arrangers, double width,
                                    double height, double time) {
    Graph graph;
    Emitter emit(graph);
    const PictureSize size = arranged(whole_picture(graph, width, height), arrangers, emit).size;
    const std::vector<double> sides = expr::evaluate(
        std::array{size.width, size.height}, {.x = 0.5 * width, .y = 0.5 * height, .time = time});
    return {sides[0], sides[1]};
}

Expr inside(const PicturePoint& picture) {
    const auto& [point, size] = picture;
    return 0.0 <= point.x && point.x <= size.width && 0.0 <= point.y && point.y <= size.height;
}

PicturePoint clamped(const PicturePoint& picture) {
    const auto& [point, size] = picture;
    const Expr zero = size.width.graph().constant(0.0);
    return {{min(max(point.x, zero), size.width), min(max(point.y, zero), size.height)}, size};
}

DevicePoint find_arranged(const PictureSize& whole,
                          std::span<const PictureArrangerPointer> arrangers,
                          const DevicePoint& fraction, Emitter& emit) {
    constexpr int steps = 6;
    Graph& graph = emit.graph();
    const Expr x = graph.fresh_variable();
    const Expr y = graph.fresh_variable();
    Emitter unused(graph);
    const PicturePoint there = arranged({{x, y}, whole}, arrangers, unused);
    const std::array miss{there.point.x - fraction.x * there.size.width,
                          there.point.y - fraction.y * there.size.height};
    const std::vector<Expr> by_x = expr::differentiate(miss, x);
    const std::vector<Expr> by_y = expr::differentiate(miss, y);
    const Expr determinant = by_x[0] * by_y[1] - by_x[1] * by_y[0];
    const std::array next{x - (miss[0] * by_y[1] - miss[1] * by_y[0]) / determinant,
                          y - (by_x[0] * miss[1] - by_x[1] * miss[0]) / determinant};

    DevicePoint found{0.5 * whole.width, 0.5 * whole.height};
    for (int step = 0; step < steps; ++step) {
        const std::array put{expr::Substitution{x, found.x}, expr::Substitution{y, found.y}};
        const std::vector<Expr> nearer = expr::substitute(graph, next, put);
        found = {nearer[0], nearer[1]};
    }
    return found;
}

}  // namespace balcony::camera
