// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "bridge/text/targets.hpp"

#include <algorithm>
#include <array>

namespace balcony::bridge {

std::span<const ExportTarget> export_targets() {
    static const std::array targets{osl_target(), glsl_target(), c_target(), numpy_target(),
                                    pov_target()};
    return targets;
}

const ExportTarget* find_export_target(std::string_view name) {
    const std::span<const ExportTarget> all = export_targets();
    const auto found = std::find_if(
        all.begin(), all.end(), [name](const ExportTarget& target) { return target.name == name; });
    return found == all.end() ? nullptr : &*found;
}

}  // namespace balcony::bridge
