// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "balcony/base.hpp"

namespace balcony::render {

/// The error for a file whose extension is none of the formats that are written.
[[nodiscard]] Diagnostic not_a_picture_format(const std::filesystem::path& file);

}  // namespace balcony::render
