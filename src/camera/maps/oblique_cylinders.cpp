// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Cylindrical maps along a meridian or along any other great circle.

#include <array>
#include <numbers>

#include "camera/maps/formula_maps.hpp"
#include "camera/maps/parallels.hpp"

namespace balcony::camera::maps {

namespace {

constexpr double quarter = 0.5 * pi;

InverseMapPointer along_meridian(const Definition&, const ForwardMap& map) {
    return oblique_cylinder(map, along_great_circle({}, 0.0));
}

InverseMapPointer swiss(const Definition& definition, const ForwardMap& map) {
    return oblique_cylinder(map,
                            along_great_circle({0.0, definition.angle("lat_0", 0.0)}, quarter));
}

// Through two points, or at an azimuth through one, which the projections count in different ways.
InverseMapPointer along_given_circle(const Definition& definition, const ForwardMap& map) {
    if (!definition.has("alpha") && !definition.has("gamma")) {
        return oblique_cylinder(
            map, through_points({definition.angle("lon_1", 0.0), definition.angle("lat_1", 0.0)},
                                {definition.angle("lon_2", 0.0), definition.angle("lat_2", 0.0)}));
    }
    const SpherePoint through{definition.angle("lonc", 0.0), definition.angle("lat_0", 0.0)};
    const double alpha = definition.angle(definition.has("alpha") ? "alpha" : "gamma", 0.0);
    for (const double azimuth : {alpha, alpha + quarter, quarter - alpha, -alpha}) {
        if (InverseMapPointer made = oblique_cylinder(map, along_great_circle(through, azimuth))) {
            return made;
        }
    }
    return nullptr;
}

}  // namespace

std::vector<FormulaMapRow> oblique_cylinders() {
    return {{"tmerc", along_meridian},   {"gstmerc", along_meridian}, {"cass", along_meridian},
            {"tcea", along_meridian},    {"somerc", swiss},           {"omerc", along_given_circle},
            {"ocea", along_given_circle}};
}

}  // namespace balcony::camera::maps
