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

/// What the user wrote after `balcony render`.
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
    std::string ambient = "0.1";
    bool quiet = false;
    bool json = false;
};

/// The settings that the options ask for; what cannot be read is added to
/// `said`, each with its option.
[[nodiscard]] render::Settings read_settings(const RenderOptions& options, Diagnostics& said);

/// Stops of exposure, as asked for; nothing if the picture is to say.
[[nodiscard]] std::optional<double> read_exposure(const RenderOptions& options, Diagnostics& said);

/// A picture's size as the user wants it: in pixels, or only its width, or nothing said.
struct PictureSize {
    std::optional<std::size_t> width;
    std::optional<std::size_t> height;

    /// Width and height. Where nothing is said they are the picture's own, if it has a size, else
    /// about a million pixels; what else is not said follows from the picture's proportion.
    [[nodiscard]] std::pair<std::size_t, std::size_t> resolve(
        double aspect, std::optional<std::array<std::size_t, 2>> own = {}) const;
};

/// WIDTHxHEIGHT, WIDTH or nothing.
[[nodiscard]] PictureSize read_size(const std::string& text, Diagnostics& said);

}  // namespace balcony::cli
