// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Options of the commands that bring photos into a camera's picture: which camera the photo was
// taken with, and which one is wanted.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "balcony/lang.hpp"
#include "balcony/picture_options.hpp"
#include "balcony/st_maps.hpp"

namespace balcony::cli {

/// Which picture is made of a photo.
struct PhotoRequest {
    std::string camera;
    std::vector<std::string> set;
    std::string layer;
    app::SizeRequest size;
    double time = 0.0;
    std::string from;  ///< The camera of the photo.
    std::vector<std::string> from_set;
    bool allow_parallax = false;
};

/// All but the camera and its layer.
[[nodiscard]] app::Options<PhotoRequest> photo_options();
/// The same with the layer.
[[nodiscard]] app::Options<PhotoRequest> photo_options_of_layers();

/// The wanted camera with its inverse, and that of the photo in its own size. The workspace makes
/// them.
[[nodiscard]] Result<bridge::SourceCamera> make_wanted(const PhotoRequest& request,
                                                       lang::Workspace& workspace);
[[nodiscard]] Result<bridge::SourceCamera> make_source(const PhotoRequest& request,
                                                       lang::Workspace& workspace);

/// The map of a camera for photos of a size in pixels; of their camera's own size if it is nothing.
/// The workspace makes both cameras.
[[nodiscard]] Result<bridge::StMap> make_st_map(
    const PhotoRequest& request, std::optional<std::array<std::size_t, 2>> photo_size,
    lang::Workspace& workspace);

}  // namespace balcony::cli
