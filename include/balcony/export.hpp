// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Export: a camera as a text in another language, which computes the same rays without Balcony.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/camera.hpp"

namespace balcony::bridge {

/// A language that cameras are exported to.
struct ExportTarget {
    std::string_view name;     ///< As `balcony export --to` has it.
    std::string_view meaning;  ///< One line for documentation.
    std::string_view ending;   ///< Of its files, with the dot.
};

[[nodiscard]] std::span<const ExportTarget> export_targets();

}  // namespace balcony::bridge
