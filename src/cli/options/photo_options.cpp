// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/options/photo_options.hpp"

#include <limits>
#include <utility>

#include "balcony/inputs.hpp"
#include "balcony/photo_maps.hpp"
#include "cli/options/command_rows.hpp"

namespace balcony::cli {

namespace {

template <class Value>
std::optional<Value> taken(Result<Value> result, Diagnostics& diagnostics) {
    diagnostics.insert(diagnostics.end(), result.diagnostics.begin(), result.diagnostics.end());
    return std::move(result.value);
}

// What make(picture) makes of the picture of a camera.
template <class Make>
Result<bridge::SourceCamera> of_picture(const std::string& camera,
                                        const std::vector<std::string>& set,
                                        lang::Workspace& workspace, const Make& make) {
    Diagnostics found;
    const auto picture = taken(load_picture(camera, set, workspace), found);
    if (!picture) {
        return found;
    }
    Result<bridge::SourceCamera> made = make(*picture);
    made.diagnostics.insert(made.diagnostics.begin(), found.begin(), found.end());
    return made;
}

}  // namespace

Result<bridge::SourceCamera> make_wanted(const PhotoRequest& request, lang::Workspace& workspace) {
    return of_picture(request.camera, request.set, workspace, [&](const camera::Picture& picture) {
        return app::wanted_camera(picture, request.size, request.time);
    });
}

Result<bridge::SourceCamera> make_source(const PhotoRequest& request, lang::Workspace& workspace) {
    return of_picture(request.from, request.from_set, workspace,
                      [&](const camera::Picture& picture) {
                          return app::camera_of_photo(picture, {}, request.time);
                      });
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
    const auto photo = taken(load_picture(request.from, request.from_set, workspace), found);
    if (!picture || !photo) {
        return found;
    }
    auto map = app::photo_map(
        *picture, *photo,
        {.size = request.size,
         .layer = request.layer,
         .time = request.time,
         .photo_size = photo_size,
         .parallax = request.allow_parallax ? bridge::Parallax::ignore : bridge::Parallax::refuse});
    map.diagnostics.insert(map.diagnostics.begin(), found.begin(), found.end());
    return map;
}

}  // namespace balcony::cli
