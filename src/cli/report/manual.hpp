// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "balcony/base.hpp"
#include "cli/command_line.hpp"

namespace balcony::cli {

/// Writes the manual pages balcony.1, balcony-render.1, ... into a folder: the texts of --help in
/// the format of man.
[[nodiscard]] Diagnostics write_manual(const CLI::App& app, const std::filesystem::path& folder);

}  // namespace balcony::cli
