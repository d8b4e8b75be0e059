// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <system_error>

#include <fmt/format.h>

#include "balcony/inputs.hpp"

namespace balcony::app {

Diagnostics check_overwrites(const std::filesystem::path& output,
                             std::span<const std::filesystem::path> inputs,
                             std::string_view option) {
    for (const std::filesystem::path& input : inputs) {
        std::error_code failed;
        if (std::filesystem::equivalent(input, output, failed) && !failed) {
            return {
                error(Kind::usage,
                      fmt::format("'{}' is read here and would be overwritten", output.string()),
                      fmt::format("name another file with {}", option))};
        }
    }
    return {};
}

}  // namespace balcony::app
