// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "balcony/base.hpp"
#include "cli/command_line.hpp"

namespace balcony::cli {

struct TextureWords {
    std::string memory = "1GiB";
};

void add_texture_options(CLI::App& command, TextureWords& words);

/// The memory for textures in bytes. What cannot be read is added to `diagnostics`.
[[nodiscard]] std::size_t read_texture_memory(const TextureWords& words, Diagnostics& diagnostics);

}  // namespace balcony::cli
