// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Names and descriptions of the blend modes, for colours from 0 (black) to 1.

#include <algorithm>

#include "balcony/picture.hpp"

namespace balcony::camera {

namespace {

struct BlendModeRow {
    BlendMode mode;
    std::string_view name;
    std::string_view meaning;
};

constexpr std::array blend_mode_rows = {
    BlendModeRow{BlendMode::normal, "normal", "the layer covers the backdrop"},
    BlendModeRow{BlendMode::multiply, "multiply",
                 "the product of layer and backdrop, never lighter than either"},
    BlendModeRow{BlendMode::screen, "screen",
                 "the inverse of the product of the inverses, never darker than either"},
    BlendModeRow{BlendMode::overlay, "overlay",
                 "multiplies where the backdrop is dark, screens where it is light"},
    BlendModeRow{BlendMode::darken, "darken", "the darker of the two, channel by channel"},
    BlendModeRow{BlendMode::lighten, "lighten", "the lighter of the two, channel by channel"},
    BlendModeRow{BlendMode::color_dodge, "color_dodge",
                 "brightens the backdrop, more strongly for a lighter layer"},
    BlendModeRow{BlendMode::color_burn, "color_burn",
                 "darkens the backdrop, more strongly for a darker layer"},
    BlendModeRow{BlendMode::hard_light, "hard_light",
                 "multiplies where the layer is dark, screens where it is light"},
    BlendModeRow{BlendMode::soft_light, "soft_light",
                 "slightly darkens or lightens the backdrop, depending on the layer"},
    BlendModeRow{BlendMode::difference, "difference",
                 "the absolute difference of the two, channel by channel"},
    BlendModeRow{BlendMode::exclusion, "exclusion", "like difference, with less contrast"},
    BlendModeRow{BlendMode::add, "add", "the sum of the two"},
    BlendModeRow{BlendMode::subtract, "subtract", "the backdrop minus the layer"},
};

}  // namespace

std::string_view name_of(BlendMode mode) {
    return blend_mode_rows[static_cast<std::size_t>(mode)].name;
}

std::string_view meaning_of(BlendMode mode) {
    return blend_mode_rows[static_cast<std::size_t>(mode)].meaning;
}

std::optional<BlendMode> find_blend_mode(std::string_view name) {
    const auto row = std::find_if(blend_mode_rows.begin(), blend_mode_rows.end(),
                                  [name](const BlendModeRow& one) { return one.name == name; });
    return row != blend_mode_rows.end() ? std::optional(row->mode) : std::nullopt;
}

std::vector<std::string> blend_mode_names() {
    std::vector<std::string> all;
    for (const BlendModeRow& row : blend_mode_rows) {
        all.emplace_back(row.name);
    }
    return all;
}

}  // namespace balcony::camera
