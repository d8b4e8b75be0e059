// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Options of the commands that bring photos into a camera's picture: which camera the photo was
// taken with, and which one is wanted.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "balcony/st_maps.hpp"
#include "cli/command_line.hpp"
#include "cli/options/common_options.hpp"

namespace balcony::cli {

struct PhotoOptions {
    std::string camera;
    std::vector<std::string> set;
    std::string layer;
    SizeWords size;
    std::string time = "0";
    std::string from;
    std::vector<std::string> from_set;
    bool allow_parallax = false;
};

/// Adds all but the camera.
void add_photo_options(CLI::App& command, PhotoOptions& options);

/// What the options ask for, read and checked.
struct PhotoRequest {
    PictureSize size;
    double time = 0.0;
};

[[nodiscard]] PhotoRequest read_photo_request(const PhotoOptions& options,
                                              Diagnostics& diagnostics);

/// The map of a camera for photos of a size in pixels; of their camera's own size if it is nothing.
[[nodiscard]] Result<bridge::StMap> make_st_map(
    const PhotoOptions& options, const PhotoRequest& request,
    std::optional<std::array<std::size_t, 2>> photo_size);

}  // namespace balcony::cli
