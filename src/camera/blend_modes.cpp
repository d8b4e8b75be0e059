// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The names of the blend modes, and what they do. The meanings take colours from 0, black, to 1.

#include <algorithm>

#include "balcony/picture.hpp"

namespace balcony::camera {

namespace {

struct BlendModeRow {
    BlendMode mode;
    std::string_view name;
    std::string_view meaning;
};

constexpr std::array rows = {
    BlendModeRow{BlendMode::normal, "normal", "the layer covers what is below"},
    BlendModeRow{BlendMode::multiply, "multiply",
                 "the product with what is below, never lighter than either"},
    BlendModeRow{BlendMode::screen, "screen",
                 "the two as lights on one screen, never darker than either"},
    BlendModeRow{BlendMode::overlay, "overlay",
                 "multiplies where it is dark below, screens where it is light"},
    BlendModeRow{BlendMode::darken, "darken", "the darker of the two, channel by channel"},
    BlendModeRow{BlendMode::lighten, "lighten", "the lighter of the two, channel by channel"},
    BlendModeRow{BlendMode::color_dodge, "color_dodge",
                 "what is below made brighter, the more so the lighter the layer"},
    BlendModeRow{BlendMode::color_burn, "color_burn",
                 "what is below made darker, the more so the darker the layer"},
    BlendModeRow{BlendMode::hard_light, "hard_light",
                 "multiplies where the layer is dark, screens where it is light"},
    BlendModeRow{BlendMode::soft_light, "soft_light",
                 "makes what is below a little darker or lighter, as the layer is dark or light"},
    BlendModeRow{BlendMode::difference, "difference",
                 "how far the two lie apart, channel by channel"},
    BlendModeRow{BlendMode::exclusion, "exclusion", "as difference, with less contrast"},
    BlendModeRow{BlendMode::add, "add", "the sum of the two"},
    BlendModeRow{BlendMode::subtract, "subtract", "what is below less the layer"},
};

}  // namespace

std::string_view name_of(BlendMode mode) { return rows[static_cast<std::size_t>(mode)].name; }

std::string_view meaning_of(BlendMode mode) { return rows[static_cast<std::size_t>(mode)].meaning; }

std::optional<BlendMode> find_blend_mode(std::string_view name) {
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [name](const BlendModeRow& one) { return one.name == name; });
    return row != rows.end() ? std::optional(row->mode) : std::nullopt;
}

std::vector<std::string> blend_mode_names() {
    std::vector<std::string> all;
    for (const BlendModeRow& row : rows) {
        all.emplace_back(row.name);
    }
    return all;
}

}  // namespace balcony::camera
