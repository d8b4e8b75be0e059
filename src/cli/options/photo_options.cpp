// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/options/photo_options.hpp"

#include <limits>
#include <memory>
#include <tuple>

#include <CLI/CLI.hpp>

#include "balcony/inverse.hpp"
#include "cli/options/camera_argument.hpp"
#include "cli/options/option_values.hpp"

namespace balcony::cli {

namespace {

template <class Value>
std::optional<Value> taken(Result<Value> result, Diagnostics& diagnostics) {
    diagnostics.insert(diagnostics.end(), result.diagnostics.begin(), result.diagnostics.end());
    return std::move(result.value);
}

Result<bridge::RayGrid> make_grid(const camera::Picture& picture, std::array<std::size_t, 2> size,
                                  const std::string& layer, double time) {
    return bridge::RayGrid::make(picture, {.width = size[0],
                                           .height = size[1],
                                           .layer = layer,
                                           .axes = Axes::z_up,
                                           .time = time,
                                           .footprints = true});
}

// A photo of another aspect is one that was scaled.
std::optional<bridge::SourceCamera> make_source(const PhotoOptions& options, double time,
                                                std::optional<std::array<std::size_t, 2>> photo,
                                                Diagnostics& found) {
    const auto own = taken(load_picture(options.from, options.from_set), found);
    if (!own) {
        return std::nullopt;
    }
    const camera::Picture picture = own->with_fit(camera::Fit::stretch);
    const auto [width, height] = PictureSize{}.resolve(picture.aspect(), picture.parts().size);
    const auto [columns, rows] = photo.value_or(std::array{width, height});
    auto grid = taken(make_grid(picture, {columns, rows}, {}, time), found);
    auto locator = taken(analyse::Locator::make(picture, static_cast<double>(columns),
                                                static_cast<double>(rows), time, Axes::z_up),
                         found);
    if (!grid || !locator) {
        return std::nullopt;
    }
    return bridge::SourceCamera{std::move(*grid),
                                std::make_shared<const analyse::Locator>(std::move(*locator))};
}

}  // namespace

void add_photo_options(CLI::App& command, PhotoOptions& options) {
    command
        .add_option("--from", options.from,
                    "camera of the photo: panorama (equirectangular), fisheye, pinhole, or a "
                    "camera of a file, with a single viewpoint")
        ->type_name("FILE[:NAME]")
        ->required();
    command
        .add_option("--from-set", options.from_set,
                    "value of a parameter of the photo's camera; may be repeated")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false)
        ->take_all();
    command.add_flag("--allow-parallax", options.allow_parallax,
                     "use a camera without a single viewpoint by the directions of its rays alone");
    add_set_option(command, options.set);
    command
        .add_option("--layer", options.layer,
                    "the camera layer of a picture: its name or its number, counted from 1 at the "
                    "back")
        ->type_name("LAYER");
    add_size_options(command, options.size, "size of the picture in pixels");
    add_aspect_option(command, options.size);
    add_time_option(command, options.time);
}

PhotoRequest read_photo_request(const PhotoOptions& options, Diagnostics& diagnostics) {
    constexpr double any = std::numeric_limits<double>::max();
    return {read_size(options.size, diagnostics),
            read_number("--time", options.time, -any, any, "give a number", diagnostics)};
}

Result<bridge::StMap> make_st_map(const PhotoOptions& options, const PhotoRequest& request,
                                  std::optional<std::array<std::size_t, 2>> photo_size) {
    Diagnostics found;
    const auto picture = taken(load_picture(options.camera, options.set), found);
    const auto source = make_source(options, request.time, photo_size, found);
    if (!picture || !source) {
        return found;
    }
    std::array<std::size_t, 2> size{};
    std::tie(size[0], size[1]) = request.size.resolve(picture->aspect(), picture->parts().size);
    const auto grid = taken(
        make_grid(picture->with_fit(request.size.fit), size, options.layer, request.time), found);
    if (!grid) {
        return found;
    }
    auto map = taken(bridge::StMap::make(*grid, *source,
                                         options.allow_parallax ? bridge::Parallax::ignore
                                                                : bridge::Parallax::refuse),
                     found);
    return map ? Result<bridge::StMap>(std::move(*map), std::move(found))
               : Result<bridge::StMap>(std::move(found));
}

}  // namespace balcony::cli
