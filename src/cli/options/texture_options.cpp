// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/options/texture_options.hpp"

#include <array>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "balcony/render.hpp"
#include "cli/options/job_options.hpp"
#include "cli/options/option_values.hpp"

namespace balcony::cli {

namespace {

// A number of MiB, or with a unit.
std::optional<double> texture_bytes_of(std::string_view text) {
    const auto mebibytes = number_of<double>(text);
    return mebibytes ? std::optional(*mebibytes * 0x1p20) : bytes_of(text);
}

}  // namespace

void add_texture_options(CLI::App& command, TextureWords& words) {
    command
        .add_option("--texture-memory", words.memory,
                    "limit for the textures in memory, in MiB or with a unit (MiB, GiB, MB, GB)")
        ->type_name("SIZE")
        ->capture_default_str();
}

std::size_t read_texture_memory(const TextureWords& words, Diagnostics& diagnostics) {
    constexpr double largest = 0x1p50;
    const auto bytes = texture_bytes_of(words.memory);
    if (!bytes || *bytes < static_cast<double>(render::min_texture_memory) || *bytes > largest) {
        refuse(diagnostics, "--texture-memory", words.memory,
               fmt::format("give at least {} MiB, such as 512 or 4GiB",
                           render::min_texture_memory >> 20U));
        return render::default_texture_memory;
    }
    return static_cast<std::size_t>(*bytes);
}

}  // namespace balcony::cli
