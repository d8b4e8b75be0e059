// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Names and descriptions of the blend modes, for colours from 0 (black) to 1.

#include "balcony/picture.hpp"

namespace balcony::camera {

namespace {

constexpr std::array blend_mode_rows = {
    Named{BlendMode::normal, "normal", "the layer covers the backdrop"},
    Named{BlendMode::multiply, "multiply",
          "the product of layer and backdrop, never lighter than either"},
    Named{BlendMode::screen, "screen",
          "the inverse of the product of the inverses, never darker than either"},
    Named{BlendMode::overlay, "overlay",
          "multiplies where the backdrop is dark, screens where it is light"},
    Named{BlendMode::darken, "darken", "the darker of the two, channel by channel"},
    Named{BlendMode::lighten, "lighten", "the lighter of the two, channel by channel"},
    Named{BlendMode::color_dodge, "color_dodge",
          "brightens the backdrop, more strongly for a lighter layer"},
    Named{BlendMode::color_burn, "color_burn",
          "darkens the backdrop, more strongly for a darker layer"},
    Named{BlendMode::hard_light, "hard_light",
          "multiplies where the layer is dark, screens where it is light"},
    Named{BlendMode::soft_light, "soft_light",
          "slightly darkens or lightens the backdrop, depending on the layer"},
    Named{BlendMode::difference, "difference",
          "the absolute difference of the two, channel by channel"},
    Named{BlendMode::exclusion, "exclusion", "like difference, with less contrast"},
    Named{BlendMode::add, "add", "the sum of the two"},
    Named{BlendMode::subtract, "subtract", "the backdrop minus the layer"},
};

}  // namespace

Names<BlendMode> blend_modes() { return Names<BlendMode>(blend_mode_rows); }

}  // namespace balcony::camera
