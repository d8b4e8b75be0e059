// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <array>

#include "balcony/export.hpp"

namespace balcony::bridge {

std::span<const ExportTarget> export_targets() {
    static constexpr std::array targets{
        ExportTarget{"c", "one C99 function, in double or single precision", ".c"},
        ExportTarget{"numpy", "one vectorised Python function", ".py"},
    };
    return targets;
}

}  // namespace balcony::bridge
