// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/plant/leaf.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "common/solids.hpp"
#include "common/surfaces.hpp"

namespace balcony::plates {

namespace {

// How far a line comes whose pitch changes evenly from one value to another: (outwards, upwards),
// per unit of its length.
V2d bent_line(double pitch, double turn, double length) {
    return V2d(std::sin(pitch) - std::sin(pitch - turn * length),
               std::cos(pitch - turn * length) - std::cos(pitch)) /
           turn;
}

// Stalks bend outwards a little under the weight of their blades.
constexpr double stalk_bend = 0.35;

struct Frame {
    V3d origin, along, side, up;
};

// At the end of the stalk.
Frame blade_frame(const Leaf& leaf, double part) {
    const V3d outward(std::cos(leaf.azimuth), std::sin(leaf.azimuth), 0.0);
    const V3d z(0, 0, 1);
    const auto in_space = [&](const V2d& p) { return outward * p.x + z * p.y; };
    const V2d stalk = bent_line(leaf.pitch, stalk_bend / leaf.stalk_length, leaf.stalk_length);
    const double pitch = leaf.pitch - stalk_bend;
    const V2d midrib = bent_line(pitch, leaf.droop / leaf.length, leaf.length * part);
    const double here = pitch - leaf.droop * part;
    const V3d along = in_space(V2d(std::cos(here), std::sin(here)));
    const V3d level = z.cross(outward);
    const V3d above = along.cross(level) * -1.0;
    return {in_space(stalk + midrib) + outward * 0.06, along,
            level * std::cos(leaf.roll) + above * std::sin(leaf.roll),
            above * std::cos(leaf.roll) - level * std::sin(leaf.roll)};
}

// Half the width of a blade along its midrib, at most 1: round at the stalk, pointed at the tip.
double outline(double part) {
    return 1.85 * std::pow(part, 0.62) * std::pow(1.0 - part, 0.9) * (1.0 + 0.12 * part);
}

}  // namespace

Leaf leaf_of_plant(int number, int count) {
    constexpr double degrees = std::numbers::pi / 180.0;
    const auto random = [number](std::uint32_t what) { return lattice_noise(number, 3, what); };
    const double age = 1.0 - (number + 0.5) / count;
    const double golden_angle = std::numbers::pi * (3.0 - std::sqrt(5.0));
    return {.azimuth = number * golden_angle + 0.5 * random(1),
            .pitch = (88.0 - 44.0 * age - 12.0 * random(2)) * degrees,
            .stalk_length = 1.75 - 0.75 * age + 0.65 * random(3),
            .length = 1.15 + 0.45 * std::sqrt(age) + 0.3 * random(4),
            .width = 0.62 + 0.24 * age + 0.14 * random(5),
            .droop = (35.0 + 55.0 * age + 30.0 * random(6)) * degrees,
            .roll = (random(7) - 0.5) * 50.0 * degrees,
            .wave = 0.02 + 0.035 * random(8),
            .phase = 6.0 * random(9)};
}

scene::Mesh leaf_blade(const Leaf& leaf) {
    return smooth_surface(12, 28, [&](double u, double v) {
        const Frame frame = blade_frame(leaf, v);
        const double across = 1.0 - 2.0 * u;  // From the left edge, seen from above, to the right.
        const double edge = across * across;
        const double half = 0.5 * leaf.width * outline(v);
        const double wave =
            leaf.wave * leaf.width * edge * outline(v) *
            std::sin(5.0 * std::numbers::pi * v + leaf.phase + (across > 0.0 ? 0.0 : 1.9));
        // The two halves rise from the midrib and bend outwards.
        const double fold = half * (0.42 * std::abs(across) - 0.2 * edge) + 0.03 * half;
        return frame.origin + frame.side * (half * across) + frame.up * (fold + wave);
    });
}

scene::Mesh leaf_stalk(const Leaf& leaf) {
    std::vector<V3d> path;
    const V3d outward(std::cos(leaf.azimuth), std::sin(leaf.azimuth), 0.0);
    constexpr int pieces = 10;
    for (int k = 0; k <= pieces; ++k) {
        const V2d at =
            bent_line(leaf.pitch, stalk_bend / leaf.stalk_length, leaf.stalk_length * k / pieces);
        path.push_back(outward * (at.x + 0.06) + V3d(0, 0, at.y));
    }
    // The end, under the blade.
    for (const double part : {0.06, 0.16, 0.28}) {
        const Frame frame = blade_frame(leaf, part);
        path.push_back(frame.origin - frame.up * (0.02 + 0.05 * part));
    }
    return tube(path, 0.024, false, 8);
}

Color leaf_color(const Sample& sample) {
    static const Gradient greens({0x1d3d20, 0x2f6330, 0x4c8638, 0x86b04f});
    // The picture is twice as high as wide.
    const double across = 2.0 * sample.point.x;
    const double along = 0.5 + 0.5 * sample.point.y;
    const double off = std::abs(across);
    // Side veins leave the midrib and bend towards the tip.
    const double vein = 11.0 * along - 2.6 * std::pow(off, 1.4) + (across > 0.0 ? 0.5 : 0.0);
    const double to_vein = std::abs(vein - std::floor(vein) - 0.5);
    const double band = smooth_step(0.12, 0.46, to_vein);
    const double grain = fractal_noise(V2d(across * 9.0, along * 26.0), 4, 71);
    const double pale = 0.34 + 0.42 * band * smooth_step(1.05, 0.25, off) + 0.28 * grain;
    const Color blade = greens(pale);
    const Color rib = from_srgb(0xa9bf6c);
    const double on_vein = smooth_step(0.06, 0.02, to_vein) * 0.22 * smooth_step(1.0, 0.6, off);
    const double on_midrib = smooth_step(0.055, 0.025, off) * 0.9;
    return mix(blade, rib, std::max(on_vein, on_midrib));
}

}  // namespace balcony::plates
