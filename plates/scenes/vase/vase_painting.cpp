// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/vase/vase_painting.hpp"

namespace balcony::plates {

Drawing paint_vase(int pixels_round, double length, double height) {
    Drawing drawing(pixels_round, length, height, vase_colors.clay);
    const auto line_at = [&](double y, double width) {
        fill_band(drawing, y - width / 2.0, y + width / 2.0, vase_colors.slip);
    };
    // From the foot upwards.
    fill_band(drawing, 0.0, 0.2, vase_colors.slip);
    paint_rays(drawing, 0.26, 1.02, 30);
    fill_band(drawing, 1.1, 1.2, vase_colors.slip);
    paint_meander(drawing, 1.26, 1.47, 36);
    line_at(1.53, 0.035);
    // The sea.
    paint_waves(drawing, 1.6, 1.84, 34);
    constexpr double water = 1.86;
    const double front = length / 2.0;  // What the visitor sees of it.
    const double ship = 0.82;
    const V2d size(ship, ship);
    paint_ship(drawing, {.scale = size, .offset = V2d(front - 2.42, water + 0.04)},
               SailEmblem::spiral);
    paint_ship(drawing, {.scale = size, .offset = V2d(front, water + 0.06)}, SailEmblem::stripes);
    paint_ship(drawing, {.scale = size, .offset = V2d(front + 2.42, water + 0.03)},
               SailEmblem::star);
    // Between the ships, but where the painting is cut open when it is unrolled.
    const double gap = front - 1.21;
    paint_dolphin(drawing,
                  {.scale = V2d(0.5), .angle = 0.35, .offset = V2d(gap + 0.05, water + 0.36)});
    paint_dolphin(drawing,
                  {.scale = V2d(0.42), .angle = -0.3, .offset = V2d(gap - 0.1, water + 0.1)});
    paint_gull(drawing, {.scale = V2d(0.55), .offset = V2d(gap - 0.08, water + 0.86)});
    paint_gull(drawing, {.scale = V2d(0.42), .angle = 0.2, .offset = V2d(gap + 0.2, water + 0.72)});
    paint_gull(drawing,
               {.scale = V2d(0.5), .angle = -0.1, .offset = V2d(front + 3.62, water + 0.92)});
    // Behind the vase.
    paint_octopus(drawing, {.scale = V2d(0.86), .offset = V2d(0.0, water - 0.02)});
    // Shoulder and neck.
    line_at(3.0, 0.035);
    line_at(3.07, 0.02);
    paint_tongues(drawing, 3.12, 3.48, 72);
    fill_band(drawing, 3.48, 3.56, vase_colors.slip);
    line_at(3.62, 0.03);
    fill_band(drawing, 3.68, 4.22, vase_colors.slip);
    paint_palmettes(drawing, 4.32, 4.8, 8, 2.0);
    line_at(4.86, 0.03);
    fill_band(drawing, 4.92, height, vase_colors.slip);
    return drawing;
}

}  // namespace balcony::plates
