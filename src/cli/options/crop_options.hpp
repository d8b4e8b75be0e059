// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A part of a picture, and a smaller version of it.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "balcony/request.hpp"
#include "cli/command_line.hpp"

namespace balcony::cli {

/// The words of --crop and --scale.
struct CropWords {
    std::string crop;
    std::string scale = "100%";
};

using app::Crop;

void add_crop_options(CLI::App& command, CropWords& words);
[[nodiscard]] Crop read_crop(const CropWords& words, Diagnostics& diagnostics);

}  // namespace balcony::cli
