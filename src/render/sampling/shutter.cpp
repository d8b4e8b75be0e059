// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/shutter.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace balcony::render {

namespace {

double moment_of_box(double random) { return random; }

// The inverse of the distribution whose density rises to 4/3 in the first quarter, stays there, and
// falls in the last quarter: each of the slopes has a sixth of the area.
double moment_of_trapezoid(double random) {
    constexpr double slope = 1.0 / 6.0;
    if (random > 0.5) {
        return 1.0 - moment_of_trapezoid(1.0 - random);
    }
    return random < slope ? std::sqrt(0.375 * random) : 0.25 + 0.75 * (random - slope);
}

struct ShutterRow : Named<ShutterShape> {
    double (*part)(double random);
};

// In the order of the enumerators.
constexpr std::array shutter_rows{
    ShutterRow{{ShutterShape::box, "box", "opens and closes at once"}, moment_of_box},
    ShutterRow{{ShutterShape::trapezoid, "trapezoid",
                "opens and closes during a quarter of the duration each"},
               moment_of_trapezoid},
};

constexpr auto shutter_names = names_in<ShutterShape>(shutter_rows);

const ShutterRow& row_of(ShutterShape shape) {
    return shutter_rows[static_cast<std::size_t>(shape)];
}

}  // namespace

Names<ShutterShape> shutter_shapes() { return Names<ShutterShape>(shutter_names); }

scene::TimeInterval Shutter::exposure(double time) const {
    return {time - 0.5 * duration, time + 0.5 * duration};
}

double Shutter::moment(double time, double random) const {
    return duration > 0.0 ? exposure(time).at(row_of(shape).part(random)) : time;
}

}  // namespace balcony::render
