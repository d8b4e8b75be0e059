// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/options/command_rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace balcony::cli {

std::string scene_files_text() {
    return fmt::format("scene file ({})", fmt::join(scene::file_extensions(), ", "));
}

}  // namespace balcony::cli
