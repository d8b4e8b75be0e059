// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "balcony/names.hpp"
#include "balcony/ray_maps.hpp"

namespace balcony::bridge {

namespace {

using rays::RayBatch;
using rays::V3d;
using rays::VisibleLayer;

// By index: "2", or "3.1" in the picture of layer 3.
std::vector<std::string> layer_numbers(const camera::Picture& picture, std::size_t count) {
    std::vector<std::string> numbers(count);
    for (const camera::ShownCamera& shown : shown_cameras(picture)) {
        for (const camera::ShownCamera::LayerUse& use : shown.uses) {
            numbers[use.index] = use.layer;
        }
    }
    return numbers;
}

// The index of the only layer that a word means.
Result<std::size_t> find_layer(const camera::Picture& picture,
                               const std::vector<VisibleLayer>& layers, const std::string& wanted) {
    const std::vector<std::string> numbers = layer_numbers(picture, layers.size());
    std::vector<std::string> listed;
    std::vector<std::string> names;
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        listed.push_back(fmt::format("{} {}", numbers[i], layers[i].name));
        names.push_back(layers[i].name);
        if (wanted.empty() || wanted == numbers[i] || wanted == layers[i].name) {
            found.push_back(i);
        }
    }
    if (found.size() == 1) {
        return found.front();
    }
    std::string list = fmt::format("its layers are {}", fmt::join(listed, ", "));
    if (wanted.empty()) {
        return error(fmt::format("'{}' has {} camera layers, and a ray map has one", picture.name(),
                                 layers.size()),
                     {}, fmt::format("give one as the layer, by its name or its number; {}", list));
    }
    if (found.empty()) {
        return error(fmt::format("'{}' has no camera layer '{}'", picture.name(), wanted), {},
                     did_you_mean(wanted, names, std::move(list)));
    }
    return error(
        fmt::format("'{}' has {} camera layers '{}'", picture.name(), found.size(), wanted), {},
        fmt::format("give its number; {}", list));
}

// The layer shows some objects of a scene, and a map knows no objects.
Diagnostics warn_of_objects(const camera::Picture& picture, std::size_t layer) {
    for (const camera::ShownCamera& shown : shown_cameras(picture)) {
        for (const camera::ShownCamera::LayerUse& use : shown.uses) {
            if (use.index == layer && !use.objects.empty()) {
                return {warning(
                    fmt::format("layer {} of '{}' shows some objects of the scene, but a map has "
                                "all rays of its camera",
                                use.layer, picture.name()),
                    use.objects.front().patterns.front().written,
                    "give the program that traces the map the same objects")};
            }
        }
    }
    return {};
}

template <V3d (RayBatch::*vector)(std::size_t) const, int axis>
double coordinate(const RayBatch& rays, std::size_t i) {
    return (rays.*vector)(i)[axis];
}

template <V3d (RayBatch::*vector)(std::size_t) const>
void add_vector(std::vector<RayColumn>& columns, std::array<std::string_view, 3> names) {
    columns.push_back({names[0], coordinate<vector, 0>});
    columns.push_back({names[1], coordinate<vector, 1>});
    columns.push_back({names[2], coordinate<vector, 2>});
}

}  // namespace

Result<RayGrid> RayGrid::make(const camera::Picture& picture, const RaySettings& settings) {
    constexpr double max_rays = 0x1p34;  // As in a picture: hundreds of gigabytes.
    if (static_cast<double>(settings.width) * static_cast<double>(settings.height) > max_rays) {
        return error(
            fmt::format("a map of {} x {} rays is too large", settings.width, settings.height), {},
            fmt::format("a map has at most {:.0f} rays", max_rays));
    }
    auto layers = rays::compile_layers(
        picture, static_cast<double>(settings.width), static_cast<double>(settings.height),
        {.axes = settings.axes, .footprints = settings.footprints, .points = true});
    if (!layers) {
        return std::move(layers.diagnostics);
    }
    const Result<std::size_t> chosen = find_layer(picture, layers->layers(), settings.layer);
    if (!chosen) {
        return chosen.diagnostics;
    }
    Diagnostics said = warn_of_objects(picture, *chosen);
    said.insert(said.begin(), layers.diagnostics.begin(), layers.diagnostics.end());
    return {RayGrid(layers->layers()[*chosen], settings), std::move(said)};
}

void RayGrid::run(std::size_t x, std::size_t y, std::size_t width, std::size_t height,
                  rays::Scratch& scratch, RayBatch& rays) const {
    layer_.rays.run({.x = static_cast<double>(x) + 0.5,
                     .y = static_cast<double>(y) + 0.5,
                     .width = width,
                     .height = height,
                     .time = time_},
                    scratch, rays);
}

void RayGrid::run_at(std::span<const double> x, std::span<const double> y, rays::Scratch& scratch,
                     RayBatch& rays) const {
    layer_.rays.run(rays::Points{x, y, time_}, scratch, rays);
}

std::vector<RayColumn> ray_columns(const RayGrid& grid) {
    std::vector<RayColumn> columns;
    add_vector<&RayBatch::origin>(columns, {"origin.X", "origin.Y", "origin.Z"});
    add_vector<&RayBatch::direction>(columns, {"direction.X", "direction.Y", "direction.Z"});
    columns.push_back({"valid.A", [](const RayBatch&, std::size_t) { return 1.0; }});
    columns.push_back(
        {"parameters.U", [](const RayBatch& rays, std::size_t i) { return rays.parameters(i).x; }});
    columns.push_back(
        {"parameters.V", [](const RayBatch& rays, std::size_t i) { return rays.parameters(i).y; }});
    if (grid.has_footprints()) {
        add_vector<&RayBatch::origin_by_x>(columns,
                                           {"origin_by_x.X", "origin_by_x.Y", "origin_by_x.Z"});
        add_vector<&RayBatch::origin_by_y>(columns,
                                           {"origin_by_y.X", "origin_by_y.Y", "origin_by_y.Z"});
        add_vector<&RayBatch::direction_by_x>(
            columns, {"direction_by_x.X", "direction_by_x.Y", "direction_by_x.Z"});
        add_vector<&RayBatch::direction_by_y>(
            columns, {"direction_by_y.X", "direction_by_y.Y", "direction_by_y.Z"});
    }
    if (grid.has_times()) {
        columns.push_back(
            {"time.Z", [](const RayBatch& rays, std::size_t i) { return rays.time(i); }});
    }
    return columns;
}

}  // namespace balcony::bridge
