// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Spots: where the light of a far point arrives on the sensor.

#include <algorithm>
#include <cmath>
#include <limits>

#include "balcony/prescription.hpp"
#include "camera/lenses/light_bundle.hpp"

namespace balcony::camera {

namespace {

struct Box {
    std::array<double, 2> low, high;
};

Box box_around(const std::array<double, 2>& middle, double half) {
    return {{middle[0] - half, middle[1] - half}, {middle[0] + half, middle[1] + half}};
}

/// Of the points of a grid over a box, what passes.
struct Passed {
    double count = 0.0;
    std::array<double, 2> sum{};
    double sum_of_squares = 0.0;
    Box bounds{};  ///< Of where it comes from, a cell more on each side.
};

Passed passed(const LightBundle& light, const Box& box, int side) {
    constexpr double far = std::numeric_limits<double>::infinity();
    Passed made{.bounds = {{far, far}, {-far, -far}}};
    const std::array cell{(box.high[0] - box.low[0]) / side, (box.high[1] - box.low[1]) / side};
    for (int i = 0; i < side * side; ++i) {
        const std::array from{box.low[0] + cell[0] * (i % side + 0.5),
                              box.low[1] + cell[1] * (i / side + 0.5)};
        const auto to = light.arrival(from);
        if (!to) {
            continue;
        }
        made.count += 1.0;
        for (std::size_t axis = 0; axis < 2; ++axis) {
            made.sum[axis] += (*to)[axis];
            made.sum_of_squares += (*to)[axis] * (*to)[axis];
            made.bounds.low[axis] = std::min(made.bounds.low[axis], from[axis] - cell[axis]);
            made.bounds.high[axis] = std::max(made.bounds.high[axis], from[axis] + cell[axis]);
        }
    }
    return made;
}

double area_of(const Box& box) { return (box.high[0] - box.low[0]) * (box.high[1] - box.low[1]); }

}  // namespace

std::optional<Spot> spot_of(const Prescription& lens, const SpotOptions& options) {
    constexpr int coarse = 48;
    constexpr int fine = 128;
    const ParaxialLens near_axis = paraxial(lens);
    LensOptics optics = optics_of(lens, options.wavelength, line_d);
    optics.defocus = options.defocus;
    if (options.f_number) {
        narrow_stop(optics, near_axis, *options.f_number);
    }
    const LightBundle light(optics, options.field);
    // Light through the first hole, whose rim is not in the plane of the vertex; or what is aimed
    // at the entrance pupil, if that is too small to be found there.
    const LensSurface& first = lens.surfaces.front();
    const double slope = std::hypot(options.field[0], options.field[1]);
    const double bulge =
        std::max(std::abs(first.sag(first.radius, 0.0)), std::abs(first.sag(0.0, first.radius)));
    const std::array toward{options.field[0] * near_axis.entrance_pupil,
                            options.field[1] * near_axis.entrance_pupil};
    Passed found = passed(light, box_around({0.0, 0.0}, first.radius + slope * bulge), coarse);
    if (found.count == 0.0) {
        found = passed(light, box_around(toward, 2.0 * near_axis.entrance_radius), coarse);
    }
    if (found.count == 0.0) {
        return std::nullopt;
    }
    found = passed(light, found.bounds, coarse);
    const Box box = found.bounds;
    found = passed(light, box, fine);
    const std::array middle{found.sum[0] / found.count, found.sum[1] / found.count};
    const double square =
        found.sum_of_squares / found.count - middle[0] * middle[0] - middle[1] * middle[1];
    return Spot{middle, std::sqrt(std::max(square, 0.0)),
                light.across(found.count * area_of(box) / (fine * fine))};
}

}  // namespace balcony::camera
