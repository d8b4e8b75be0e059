// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "balcony/render.hpp"

namespace balcony::cli {

/// The arguments of `balcony render`.
struct RenderOptions {
    std::string scene;
    std::string camera;
    std::optional<std::string> output;
    std::string size;
    std::vector<std::string> set;
    std::string integrator = "direct";
    std::string background = "transparent";
    std::string samples = "16";
    std::string threads = "0";
    std::string time = "0";
    std::string exposure = "auto";
    std::string ambient = "auto";
    std::string view = std::string(render::name_of(render::ViewTransform::neutral));
    bool quiet = false;
    bool json = false;
};

/// The settings that the options ask for; what cannot be read is added to
/// `diagnostics`, each with its option.
[[nodiscard]] render::Settings read_settings(const RenderOptions& options,
                                             Diagnostics& diagnostics);

/// The requested exposure in stops; nothing if it depends on the picture.
[[nodiscard]] std::optional<double> read_exposure(const RenderOptions& options,
                                                  Diagnostics& diagnostics);

/// The requested view transform.
[[nodiscard]] render::ViewTransform read_view(const RenderOptions& options,
                                              Diagnostics& diagnostics);

/// A requested picture size: width and height in pixels, only the width, or neither.
struct PictureSize {
    std::optional<std::size_t> width;
    std::optional<std::size_t> height;

    /// Width and height. The default is the picture's own size, if it has one, otherwise about a
    /// million pixels. A missing height follows from the picture's aspect ratio.
    [[nodiscard]] std::pair<std::size_t, std::size_t> resolve(
        double aspect, std::optional<std::array<std::size_t, 2>> own = {}) const;
};

/// WIDTHxHEIGHT, WIDTH or nothing.
[[nodiscard]] PictureSize read_size(const std::string& text, Diagnostics& diagnostics);

}  // namespace balcony::cli
