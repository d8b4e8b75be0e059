// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A part of a picture, and a smaller version of it.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "balcony/film.hpp"
#include "cli/command_line.hpp"

namespace balcony::cli {

/// The words of --crop and --scale.
struct CropWords {
    std::string crop;
    std::string scale = "100%";
};

/// A part of a picture at a scale.
class Crop {
public:
    /// Width and height of a picture after scaling; at least 1.
    [[nodiscard]] std::pair<std::size_t, std::size_t> scaled(std::size_t width,
                                                             std::size_t height) const;
    /// The region of the scaled picture; nothing for all of it.
    [[nodiscard]] std::optional<render::Region> region(std::size_t width, std::size_t height) const;

private:
    friend Crop read_crop(const CropWords& words, Diagnostics& diagnostics);

    double scale_ = 1.0;
    /// Left, top, right and bottom: in pixels before scaling, or as fractions of the picture.
    std::optional<std::array<double, 4>> corners_;
    bool in_pixels_ = false;
};

void add_crop_options(CLI::App& command, CropWords& words);
[[nodiscard]] Crop read_crop(const CropWords& words, Diagnostics& diagnostics);

}  // namespace balcony::cli
