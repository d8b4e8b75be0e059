// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Options that several commands have.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "balcony/base.hpp"
#include "balcony/picture.hpp"
#include "balcony/request.hpp"
#include "cli/command_line.hpp"

namespace balcony::cli {

/// The words of --size, --width, --height and --aspect.
struct SizeWords {
    std::string size;
    std::string width;
    std::string height;
    std::string fit = std::string(camera::fits()[camera::Fit::fit].name);
};

using app::PictureSize;

/// Adds --size, --width and --height.
void add_size_options(CLI::App& command, SizeWords& words, const std::string& meaning);
[[nodiscard]] PictureSize read_size(const SizeWords& words, Diagnostics& diagnostics);

/// Adds --aspect.
void add_aspect_option(CLI::App& command, SizeWords& words);

/// Adds --time.
void add_time_option(CLI::App& command, std::string& time);
/// The value of --axes; nothing if it was not given.
[[nodiscard]] std::optional<Axes> read_axes(const std::string& text, Diagnostics& diagnostics);
/// Adds -q and --quiet.
void add_quiet_option(CLI::App& command, bool& quiet);

}  // namespace balcony::cli
