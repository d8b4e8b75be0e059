// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/options/photo_options.hpp"

#include <limits>
#include <memory>
#include <utility>

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

// A picture with its inverse.
Result<bridge::SourceCamera> with_inverse(const camera::Picture& picture,
                                          std::array<std::size_t, 2> size, double time) {
    Diagnostics found;
    auto grid = taken(make_grid(picture, size, {}, time), found);
    auto locator = taken(analyse::Locator::make(picture, static_cast<double>(size[0]),
                                                static_cast<double>(size[1]), time, Axes::z_up),
                         found);
    if (!grid || !locator) {
        return found;
    }
    return {bridge::SourceCamera{std::move(*grid),
                                 std::make_shared<const analyse::Locator>(std::move(*locator))},
            std::move(found)};
}

std::array<std::size_t, 2> size_of(const PhotoRequest& request, const camera::Picture& picture) {
    const auto [width, height] = request.size.resolve(picture.aspect(), picture.parts().size);
    return {width, height};
}

}  // namespace

Result<bridge::SourceCamera> make_wanted(const PhotoRequest& request, lang::Workspace& workspace) {
    const auto own = load_picture(request.camera, request.set, workspace);
    if (!own) {
        return own.diagnostics;
    }
    auto made = with_inverse(own->with_fit(request.size.fit), size_of(request, *own), request.time);
    made.diagnostics.insert(made.diagnostics.begin(), own.diagnostics.begin(),
                            own.diagnostics.end());
    return made;
}

// A photo of another aspect is one that was scaled.
Result<bridge::SourceCamera> make_source(const PhotoRequest& request,
                                         std::optional<std::array<std::size_t, 2>> photo,
                                         lang::Workspace& workspace) {
    const auto own = load_picture(request.from, request.from_set, workspace);
    if (!own) {
        return own.diagnostics;
    }
    auto made = with_inverse(own->with_fit(camera::Fit::stretch), photo.value_or(size_of({}, *own)),
                             request.time);
    made.diagnostics.insert(made.diagnostics.begin(), own.diagnostics.begin(),
                            own.diagnostics.end());
    return made;
}

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
         app::set_option(&PhotoRequest::set)}};
    made.add(&PhotoRequest::size, app::size_options("size of the picture in pixels"));
    made.add(&PhotoRequest::size, app::aspect_options());
    made.rows.push_back(app::time_option(std::numeric_limits<double>::max(), &PhotoRequest::time));
    return made;
}

app::Options<PhotoRequest> photo_options_of_layers() {
    app::Options<PhotoRequest> made = photo_options();
    made.rows.push_back(layer_option(&PhotoRequest::layer));
    return made;
}

Result<bridge::StMap> make_st_map(const PhotoRequest& request,
                                  std::optional<std::array<std::size_t, 2>> photo_size,
                                  lang::Workspace& workspace) {
    Diagnostics found;
    const auto picture = taken(load_picture(request.camera, request.set, workspace), found);
    const auto source = taken(make_source(request, photo_size, workspace), found);
    if (!picture || !source) {
        return found;
    }
    const auto grid = taken(make_grid(picture->with_fit(request.size.fit),
                                      size_of(request, *picture), request.layer, request.time),
                            found);
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
