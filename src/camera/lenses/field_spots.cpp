// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "balcony/prescription.hpp"

namespace balcony::camera {

namespace {

constexpr std::size_t middle_color = 1;  // Of the line d.

double tangent_of(double degrees) { return std::tan(degrees * std::numbers::pi / 180.0); }

/// By wavelength; none where no light of one of the colours passes.
std::vector<Spot> spots_at(const Prescription& lens, const std::array<double, 2>& degrees) {
    std::vector<Spot> made;
    for (const double wavelength : spot_wavelengths) {
        const auto spot = spot_of(lens, {.field = {tangent_of(degrees[0]), tangent_of(degrees[1])},
                                         .wavelength = wavelength});
        if (!spot) {
            return {};
        }
        made.push_back(*spot);
    }
    return made;
}

}  // namespace

std::vector<FieldSpots> field_spots(const Prescription& lens) {
    constexpr std::array angles{5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 40.0, 50.0, 60.0};
    std::vector<FieldSpots> made{{.spots = spots_at(lens, {0.0, 0.0})}};
    if (made.front().spots.empty()) {
        return {};
    }
    const double area = made.front().spots[middle_color].area;
    const std::array lengths{paraxial(horizontal_section(lens)).focal_length,
                             paraxial(lens).focal_length};
    for (std::size_t axis = 2; axis-- > (lens.is_anamorphic() ? 0U : 1U);) {
        for (const double angle : angles) {
            FieldSpots field;
            field.degrees[axis] = angle;
            field.spots = spots_at(lens, field.degrees);
            if (field.spots.empty()) {
                break;
            }
            const Spot& middle = field.spots[middle_color];
            field.light = middle.area / area;
            field.distortion = -middle.middle[axis] / (lengths[axis] * tangent_of(angle)) - 1.0;
            made.push_back(std::move(field));
        }
    }
    return made;
}

}  // namespace balcony::camera
