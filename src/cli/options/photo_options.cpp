// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/options/photo_options.hpp"

#include <limits>
#include <memory>
#include <tuple>

#include "balcony/inverse.hpp"
#include "cli/options/command_rows.hpp"

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
std::optional<bridge::SourceCamera> make_source(const PhotoRequest& request,
                                                std::optional<std::array<std::size_t, 2>> photo,
                                                lang::Workspace& workspace, Diagnostics& found) {
    const auto own = taken(load_picture(request.from, request.from_set, workspace), found);
    if (!own) {
        return std::nullopt;
    }
    const camera::Picture picture = own->with_fit(camera::Fit::stretch);
    const auto [width, height] = app::SizeRequest{}.resolve(picture.aspect(), picture.parts().size);
    const auto [columns, rows] = photo.value_or(std::array{width, height});
    auto grid = taken(make_grid(picture, {columns, rows}, {}, request.time), found);
    auto locator =
        taken(analyse::Locator::make(picture, static_cast<double>(columns),
                                     static_cast<double>(rows), request.time, Axes::z_up),
              found);
    if (!grid || !locator) {
        return std::nullopt;
    }
    return bridge::SourceCamera{std::move(*grid),
                                std::make_shared<const analyse::Locator>(std::move(*locator))};
}

}  // namespace

app::Options<PhotoRequest> photo_options() {
    app::Options<PhotoRequest> made{
        {option({.name = "--from",
                 .placeholder = "FILE[:NAME]",
                 .meaning = "camera of the photo: panorama (equirectangular), fisheye, pinhole, or "
                            "a camera of a file, with a single viewpoint",
                 .required = true},
                text(OptionType::camera), &PhotoRequest::from),
         app::words({.name = "--from-set",
                     .placeholder = "NAME=VALUE",
                     .meaning = "value of a parameter of the photo's camera; may be repeated",
                     .type = OptionType::setting},
                    &PhotoRequest::from_set),
         flag({.name = "--allow-parallax",
               .meaning = "use a camera without a single viewpoint by the directions of its rays "
                          "alone"},
              true, &PhotoRequest::allow_parallax),
         app::set_option(&PhotoRequest::set), layer_option(&PhotoRequest::layer)}};
    made.add(&PhotoRequest::size, app::size_options("size of the picture in pixels"));
    made.add(&PhotoRequest::size, app::aspect_options());
    made.rows.push_back(app::time_option(std::numeric_limits<double>::max(), &PhotoRequest::time));
    return made;
}

Result<bridge::StMap> make_st_map(const PhotoRequest& request,
                                  std::optional<std::array<std::size_t, 2>> photo_size,
                                  lang::Workspace& workspace) {
    Diagnostics found;
    const auto picture = taken(load_picture(request.camera, request.set, workspace), found);
    const auto source = make_source(request, photo_size, workspace, found);
    if (!picture || !source) {
        return found;
    }
    std::array<std::size_t, 2> size{};
    std::tie(size[0], size[1]) = request.size.resolve(picture->aspect(), picture->parts().size);
    const auto grid = taken(
        make_grid(picture->with_fit(request.size.fit), size, request.layer, request.time), found);
    if (!grid) {
        return found;
    }
    auto map = taken(bridge::StMap::make(*grid, *source,
                                         request.allow_parallax ? bridge::Parallax::ignore
                                                                : bridge::Parallax::refuse),
                     found);
    return map ? Result<bridge::StMap>(std::move(*map), std::move(found))
               : Result<bridge::StMap>(std::move(found));
}

}  // namespace balcony::cli
