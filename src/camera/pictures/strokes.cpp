// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/pictures/strokes.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace balcony::camera {

Expr antialiased(Expr distance, const Emitter& emit) {
    return min(max(0.5 - distance, emit(0.0)), emit(1.0));
}

Expr in_device_pixels(Expr distance, const PicturePoint& layer, Emitter& emit) {
    Graph& graph = emit.graph();
    const std::array leaves{graph.picture_x(), graph.picture_y()};
    const std::array point{layer.point.x, layer.point.y};
    const std::vector<Expr> by_x = expr::differentiate(point, leaves[0]);
    const std::vector<Expr> by_y = expr::differentiate(point, leaves[1]);
    const auto dot_is = [](const std::vector<Expr>& a, const std::vector<Expr>& b, double wanted) {
        const Expr product = a[0] * b[0] + a[1] * b[1];
        return product.is_constant() && std::abs(product.node().value - wanted) < 1e-9;
    };
    if (dot_is(by_x, by_x, 1.0) && dot_is(by_y, by_y, 1.0) && dot_is(by_x, by_y, 0.0)) {
        return distance;
    }
    const Expr dx = expr::differentiate(distance, leaves[0]);
    const Expr dy = expr::differentiate(distance, leaves[1]);
    const Expr slope = sqrt(dx * dx + dy * dy);
    return select(is_finite(slope) && 1e-6 < slope, distance / slope, distance);
}

PictureExpressions::Element painted(Expr coverage, const Stroke& stroke, const Emitter& emit) {
    PictureExpressions::Element element;
    element.coverage = coverage;
    element.paint = std::array{emit(stroke.color[0]), emit(stroke.color[1]), emit(stroke.color[2])};
    return element;
}

Expr segment_distance(const DevicePoint& p, const DevicePoint& a, const DevicePoint& b,
                      const Emitter& emit) {
    const Expr to_x = b.x - a.x;
    const Expr to_y = b.y - a.y;
    const Expr x = p.x - a.x;
    const Expr y = p.y - a.y;
    const Expr squared_length = max(to_x * to_x + to_y * to_y, emit(1e-12));
    const Expr share = min(max((x * to_x + y * to_y) / squared_length, emit(0.0)), emit(1.0));
    const Expr dx = x - share * to_x;
    const Expr dy = y - share * to_y;
    return sqrt(dx * dx + dy * dy);
}

// Four parts, dark and light, in a light border, so that it is seen on any ground.
PictureExpressions::Element scale_bar(const ScaleBar& bar, double width,
                                      const PicturePoint& picture, Emitter& emit) {
    const auto& [point, size] = picture;
    const Expr length = emit(bar.length) * size.width / width;
    const Expr half_height = 0.5 * emit(bar.height) * size.height;
    const Expr from_left = point.x - emit(bar.at[0]) * size.width;
    const Expr from_middle = abs(point.y - emit(bar.at[1]) * size.height);
    // The distance of the part between two fractions of the bar.
    const auto part = [&](double first, double last) {
        const Expr along = abs(from_left - 0.5 * (first + last) * length);
        return max(along - 0.5 * (last - first) * length, from_middle - half_height);
    };
    const Expr border = part(0.0, 1.0) - 0.5 * half_height;
    const Expr dark = min(part(0.0, 0.25), part(0.5, 0.75));
    PictureExpressions::Element element;
    element.coverage = select(
        inside(picture), antialiased(in_device_pixels(border, picture, emit), emit), emit(0.0));
    const Expr shade = 1.0 - antialiased(in_device_pixels(dark, picture, emit), emit);
    element.paint = std::array{shade, shade, shade};
    return element;
}

}  // namespace balcony::camera
