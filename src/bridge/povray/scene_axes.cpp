// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "bridge/povray/scene_axes.hpp"

#include <algorithm>
#include <array>

namespace balcony::bridge {

namespace {

using Imath::V3d;
using povray::AxesRow;

// POV-Ray's own axes are left-handed. A scene is right-handed if its camera has a negative `right`.
constexpr std::array axes_rows{
    AxesRow{{"y_up",
             "y up, left-handed, as in most scenes of POV-Ray: Balcony's (x, y, z), z up, "
             "is <x, z, y>"},
            [](const V3d& v) { return V3d(v.x, v.y, -v.z); }},
    AxesRow{{"z_up", "z up, left-handed, for cameras with sky z: (x, y, z) is <x, -y, z>"},
            [](const V3d& v) { return V3d(v.x, v.z, v.y); }},
    AxesRow{{"y_up_right",
             "y up, right-handed, for cameras with a negative right vector: (x, y, z) "
             "is <x, z, -y>"},
            [](const V3d& v) { return v; }},
    AxesRow{{"z_up_right", "z up, right-handed: (x, y, z) is <x, y, z>"},
            [](const V3d& v) { return V3d(v.x, -v.z, v.y); }},
};

constexpr auto axes_infos = [] {
    std::array<PovrayAxes, axes_rows.size()> made;
    std::transform(axes_rows.begin(), axes_rows.end(), made.begin(),
                   [](const AxesRow& row) { return row.info; });
    return made;
}();

}  // namespace

std::span<const PovrayAxes> povray_axes() { return axes_infos; }

const AxesRow* povray::find_axes(std::string_view name) {
    const auto row = std::find_if(axes_rows.begin(), axes_rows.end(),
                                  [&](const AxesRow& one) { return one.info.name == name; });
    return row != axes_rows.end() ? &*row : nullptr;
}

}  // namespace balcony::bridge
