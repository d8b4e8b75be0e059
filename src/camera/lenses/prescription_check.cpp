// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/lenses/prescription_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "camera/lenses/light_bundle.hpp"

namespace balcony::camera {

namespace {

/// Directions from the axis, to the side and up, in which surfaces are compared; toroidal ones are
/// the same in the other quarters.
constexpr std::array<std::array<double, 2>, 3> around{
    {{1.0, 0.0}, {std::numbers::sqrt2 / 2.0, std::numbers::sqrt2 / 2.0}, {0.0, 1.0}}};

}  // namespace

std::optional<Diagnostic> wrong_index(const LensSurface& s, double wavelength) {
    const double n = s.behind.index(wavelength);
    if (n >= 1.0 && n < 10.0) {
        return std::nullopt;
    }
    const std::string at =
        wavelength == line_d ? "" : fmt::format(" for light of {:.4g} nm", 1000.0 * wavelength);
    return error(std::isfinite(n)
                     ? fmt::format("the index of what is behind this surface is {:.6g}{}", n, at)
                     : fmt::format("what is behind this surface has no index{}", at),
                 s.written, "an index is 1 for air, about 1.5 for glass");
}

std::optional<Diagnostic> crossing_of(const LensSurface& s, const LensSurface& next, double gap) {
    constexpr int steps = 16;
    const double edge = std::min(s.radius, next.radius);
    for (int i = 0; i <= steps; ++i) {
        const double h = edge * i / steps;
        for (const auto& [x, y] : around) {
            // Rounding of the table's own numbers may let surfaces touch.
            if (gap + next.sag(h * x, h * y) - s.sag(h * x, h * y) < -1e-3) {
                return error(fmt::format("this surface crosses the one in front of it at the "
                                         "distance {:.4g} mm from the axis",
                                         h),
                             next.written,
                             "make the gap between them larger, or a diameter smaller");
            }
        }
    }
    return std::nullopt;
}

namespace {

bool is_finite(const LensSurface& s) {
    double sum = s.curvature + s.curvature_x.value_or(0.0) + s.conic + s.radius + s.gap;
    for (const double a : s.aspheric) {
        sum += a;
    }
    return std::isfinite(sum);
}

std::optional<Diagnostic> fault_of(const LensSurface& s) {
    if (!is_finite(s)) {
        return error("a number of this surface is not finite", s.written, "correct it");
    }
    if (!(s.radius > 0.0)) {
        return error(
            s.stop ? "this stop lets nothing through" : "no light passes through this surface",
            s.written, "give it a diameter above 0");
    }
    if (auto fault = wrong_index(s, line_d)) {
        return fault;
    }
    for (const auto& [x, y] : around) {
        if (!std::isfinite(s.sag(s.radius * x, s.radius * y))) {
            const double curvature = x == 1.0 ? s.curvature_x.value_or(s.curvature) : s.curvature;
            return error(fmt::format("this surface ends before its hole does: its radius of "
                                     "curvature is {:.6g} mm, that of its hole {:.6g} mm",
                                     1.0 / curvature, s.radius),
                         s.written, "make the diameter smaller, or check the curvature");
        }
    }
    return std::nullopt;
}

// A surface that light of the axis does not get through, but that next to it.
std::optional<Diagnostic> closed_surface(const Prescription& lens) {
    constexpr int steps = 64;
    constexpr int open = 6;  // A hundredth of the area.
    using Kind = Obstacle::Kind;
    const LightBundle light(optics_of(lens, line_d, line_d), {0.0, 0.0});
    const double widest =
        std::min(paraxial(lens).entrance_radius, lens.surfaces.front().radius) / steps;
    int passed = 0;
    std::map<std::pair<std::size_t, Kind>, int> stopped;
    for (int i = 1; i <= steps; ++i) {
        for (const auto& [x, y] : {around.front(), around.back()}) {
            if (const auto by = light.obstacle({x * widest * i, y * widest * i})) {
                ++stopped[{by->surface, by->kind}];
            } else {
                passed = i;
            }
        }
    }
    const auto most =
        std::max_element(stopped.begin(), stopped.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    if (passed > open || most->first.second == Kind::hole) {
        return std::nullopt;
    }
    const bool reflected = most->first.second == Kind::reflection;
    return error(fmt::format("light of the axis {} this surface if it is more than {:.3g} mm away "
                             "from it",
                             reflected ? "is totally reflected by" : "misses", widest * passed),
                 lens.surfaces[most->first.first].written,
                 "check the radii, aspheric terms and glasses of this surface and those in front "
                 "of it, or make the stop smaller");
}

std::optional<Diagnostic> without_image(const Prescription& lens) {
    const bool upright = paraxial(lens).focal_length > 0.0;
    if (upright && paraxial(horizontal_section(lens)).focal_length > 0.0) {
        return std::nullopt;
    }
    const std::string_view plane = !lens.is_anamorphic() ? ""
                                   : upright             ? " in the horizontal plane"
                                                         : " in the vertical plane";
    return error(
        fmt::format("'{}' has no real image of what is far away{}", lens.name, plane), {},
        "check the signs of the radii: one is positive if the centre of curvature is on the side "
        "of the sensor");
}

Diagnostic wrong_stops(const Prescription& lens, std::ptrdiff_t count) {
    if (count == 0) {
        return error(fmt::format("'{}' has no stop", lens.name), {},
                     "write stop at the end of the line of the surface that limits the light; in "
                     "Zemax's files, STOP is a line of its own");
    }
    const auto last = std::find_if(lens.surfaces.rbegin(), lens.surfaces.rend(),
                                   [](const LensSurface& s) { return s.stop; });
    return error(fmt::format("'{}' has {} stops", lens.name, count), last->written,
                 "mark one surface as the stop");
}

}  // namespace

Diagnostics check(const Prescription& lens) {
    Diagnostics found;
    const auto stops = std::count_if(lens.surfaces.begin(), lens.surfaces.end(),
                                     [](const LensSurface& s) { return s.stop; });
    if (stops != 1) {
        found.push_back(wrong_stops(lens, stops));
    }
    for (const LensSurface& s : lens.surfaces) {
        if (auto fault = fault_of(s)) {
            found.push_back(*std::move(fault));
        }
    }
    if (!found.empty()) {
        return found;
    }
    for (std::size_t i = 0; i + 1 < lens.surfaces.size(); ++i) {
        if (auto fault =
                crossing_of(lens.surfaces[i], lens.surfaces[i + 1], lens.surfaces[i].gap)) {
            found.push_back(*std::move(fault));
        }
    }
    if (const Medium& last = lens.surfaces.back().behind; last.index(line_d) != 1.0) {
        found.push_back(error("the last medium is not air", lens.surfaces.back().written,
                              "add the surface behind it"));
    } else if (auto blind = without_image(lens)) {
        found.push_back(*std::move(blind));
    } else if (auto closed = found.empty() ? closed_surface(lens) : std::nullopt) {
        found.push_back(*std::move(closed));
    }
    return found;
}

}  // namespace balcony::camera
