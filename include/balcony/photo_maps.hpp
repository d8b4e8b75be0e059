// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Photo maps: where the picture of one camera shows the photo of another.

#include <array>
#include <cstddef>
#include <optional>
#include <stop_token>
#include <string>

#include "balcony/picture.hpp"
#include "balcony/request.hpp"
#include "balcony/st_maps.hpp"

namespace balcony::app {

/// A camera whose picture is wanted, in a size, with its inverse. A stop is an error of
/// Kind::interrupted.
[[nodiscard]] Result<bridge::SourceCamera> wanted_camera(const camera::Picture& picture,
                                                         const SizeRequest& size, double time,
                                                         const std::stop_token& stop = {});
/// The same of the camera that took a photo of a size in pixels, or of its own. A photo of another
/// aspect is one that was scaled.
[[nodiscard]] Result<bridge::SourceCamera> camera_of_photo(
    const camera::Picture& picture, const std::optional<std::array<std::size_t, 2>>& size,
    double time, const std::stop_token& stop = {});

/// What a picture of a photo is to be.
struct PhotoMapRequest {
    SizeRequest size{};
    std::string layer{};  ///< As RaySettings::layer.
    double time = 0.0;
    std::optional<std::array<std::size_t, 2>> photo_size{};  ///< As of camera_of_photo().
    bridge::Parallax parallax = bridge::Parallax::refuse;
};

/// The map by which the picture of a camera shows the photos of another one. A stop is an error of
/// Kind::interrupted.
[[nodiscard]] Result<bridge::StMap> photo_map(const camera::Picture& wanted,
                                              const camera::Picture& photo,
                                              const PhotoMapRequest& request,
                                              const std::stop_token& stop = {});

}  // namespace balcony::app
