// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The names of the blend modes.

#include <algorithm>

#include "balcony/picture.hpp"

namespace balcony::camera {

namespace {

struct BlendModeName {
    BlendMode mode;
    std::string_view name;
};

constexpr std::array names = {
    BlendModeName{BlendMode::normal, "normal"},
    BlendModeName{BlendMode::multiply, "multiply"},
    BlendModeName{BlendMode::screen, "screen"},
    BlendModeName{BlendMode::overlay, "overlay"},
    BlendModeName{BlendMode::darken, "darken"},
    BlendModeName{BlendMode::lighten, "lighten"},
    BlendModeName{BlendMode::color_dodge, "color_dodge"},
    BlendModeName{BlendMode::color_burn, "color_burn"},
    BlendModeName{BlendMode::hard_light, "hard_light"},
    BlendModeName{BlendMode::soft_light, "soft_light"},
    BlendModeName{BlendMode::difference, "difference"},
    BlendModeName{BlendMode::exclusion, "exclusion"},
    BlendModeName{BlendMode::add, "add"},
    BlendModeName{BlendMode::subtract, "subtract"},
};

}  // namespace

std::string_view name_of(BlendMode mode) { return names[static_cast<std::size_t>(mode)].name; }

std::optional<BlendMode> find_blend_mode(std::string_view name) {
    const auto row = std::find_if(names.begin(), names.end(),
                                  [name](const BlendModeName& one) { return one.name == name; });
    return row != names.end() ? std::optional(row->mode) : std::nullopt;
}

std::vector<std::string> blend_mode_names() {
    std::vector<std::string> all;
    for (const BlendModeName& row : names) {
        all.emplace_back(row.name);
    }
    return all;
}

}  // namespace balcony::camera
