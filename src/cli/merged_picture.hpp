// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/report/render_report.hpp"

namespace balcony::cli {

/// Joins all shards of a picture, and writes it where the first one says, or to another file if a
/// name is given.
[[nodiscard]] RenderReport merge_picture(const std::vector<std::filesystem::path>& shards,
                                         const std::string& other_output);

}  // namespace balcony::cli
