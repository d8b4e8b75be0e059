// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What is painted on the vase. Lengths are in scene units: x around the vase where it is widest, y
// along its profile from the foot.

#include "common/drawing.hpp"

namespace balcony::plates {

/// The painter's four colours.
struct VaseColors {
    Color clay = from_srgb(0xc4713c);
    Color slip = from_srgb(0x17120f);  ///< Black.
    Color red = from_srgb(0x7a2c20);
    Color white = from_srgb(0xe6d6b4);
};
inline const VaseColors vase_colors;

// Bands of ornament that go round, between two heights.
void fill_band(Drawing& drawing, double low, double high, const Color& color);
void paint_rays(Drawing& drawing, double low, double high, int count);
void paint_meander(Drawing& drawing, double low, double high, int count);
void paint_waves(Drawing& drawing, double low, double high, int count);
void paint_tongues(Drawing& drawing, double low, double high, int count);
/// Fans of petals, upright and upside down by turns; wide where the vase is narrow.
void paint_palmettes(Drawing& drawing, double low, double high, int count, double stretch);

// Figures. Their offset is the middle of the water line, and they look to the right.
enum class SailEmblem { stripes, spiral, star };
void paint_ship(Drawing& drawing, const Placement& placement, SailEmblem emblem);
void paint_dolphin(Drawing& drawing, const Placement& placement);
void paint_octopus(Drawing& drawing, const Placement& placement);
void paint_gull(Drawing& drawing, const Placement& placement);

/// The whole vase: length and height of the painted surface.
[[nodiscard]] Drawing paint_vase(int pixels_round, double length, double height);

}  // namespace balcony::plates
