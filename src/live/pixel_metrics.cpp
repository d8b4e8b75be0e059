// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "live/pixel_metrics.hpp"

#include <cmath>
#include <utility>

namespace balcony::live {

using Imath::V3d;

Result<PixelMetrics> PixelMetrics::make(const lang::OpenPicture& opened,
                                        const std::array<std::size_t, 2>& size,
                                        const std::stop_token& stop) {
    rays::CompileOptions options{
        .footprints = true, .parameters = false, .tiles = false, .points = true};
    for (const lang::OpenParameter& one : opened.open) {
        options.inputs.push_back({lang::parameter_input(one.name), program::Rate::uniform});
    }
    Result<rays::VisibleLayers> layers = rays::compile_layers(
        opened.picture, static_cast<double>(size[0]), static_cast<double>(size[1]), options, stop);
    if (!layers) {
        return std::move(layers.diagnostics);
    }
    return PixelMetrics(std::move(*layers));
}

std::optional<PixelMetrics::Metric> PixelMetrics::at(std::size_t layer, const Imath::V2d& point,
                                                     double distance, double time,
                                                     std::span<const camera::KnownInput> inputs) {
    std::vector<std::span<const double>> values;
    for (const camera::KnownInput& input : inputs) {
        values.emplace_back(&input.value, 1);
    }
    layers_.layers().at(layer).rays.run(rays::Points{{&point.x, 1}, {&point.y, 1}, time, values},
                                        scratch_, batch_);
    if (!batch_.valid(0)) {
        return std::nullopt;
    }
    const rays::Ray ray = batch_[0];
    const auto across = [&](const V3d& origin_by, const V3d& direction_by) {
        const V3d step = origin_by + distance * direction_by;
        return step - step.dot(ray.direction) * ray.direction;
    };
    const V3d by_x = across(ray.origin_by_x, ray.direction_by_x);
    const V3d by_y = across(ray.origin_by_y, ray.direction_by_y);
    const Metric made{by_x.length2(), by_x.dot(by_y), by_y.length2()};
    const double area = made.xx * made.yy - made.xy * made.xy;  // Of a pixel, squared.
    return std::isfinite(area) && area > 0.0 ? std::optional(made) : std::nullopt;
}

}  // namespace balcony::live
