// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/lenses/exit_pupil.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace balcony::camera {

namespace {

constexpr double half_turn = std::numbers::pi;
using Direction = std::array<double, 2>;  // (m, n)

/// Halves of a unit, to about 1e-8.
constexpr int bisections = 28;

/// The last number for which something holds, between one for which it does and one for which it
/// does not.
template <class Holds>
double last_of(double good, double bad, const Holds& holds) {
    for (int i = 0; i < bisections; ++i) {
        const double middle = 0.5 * (good + bad);
        (holds(middle) ? good : bad) = middle;
    }
    return good;
}

/// The directions in which light reaches one point of the sensor.
class PupilOfPoint {
public:
    PupilOfPoint(const LensOptics& lens, const FocusedOptics<double>& at, double x, double y)
        : lens_(lens), at_(at), point_{x * at.depth(), y * at.depth()} {}

    [[nodiscard]] bool passes(const Direction& d) const {
        const auto ray = trace(d);
        return ray && ray->passed;
    }

    /// Of a point beside the axis, or above it, where the lens is symmetric: the direction through
    /// the middle of the stop, or any other that passes, among those to the hole of the last
    /// surface; its rim is not in the plane of its vertex.
    [[nodiscard]] std::optional<Direction> inside(std::size_t axis) const {
        constexpr int count = 128;
        constexpr double around = 1.5;
        const double hole = around * lens_.surfaces.back().shape.radius;
        std::optional<Direction> found;
        std::optional<std::array<double, 2>> last;  // The slope, and where it crosses the stop.
        for (int i = 0; i <= count; ++i) {
            const double across = hole * (2.0 * i / count - 1.0) - point_[axis];
            const double slope = across / std::hypot(across, at_.depth());
            const auto here = at_stop(axis, slope);
            if (here && last && std::signbit(*here) != std::signbit((*last)[1])) {
                const double middle = last_of((*last)[0], slope, [&](double between) {
                    const auto there = at_stop(axis, between);
                    return there && std::signbit(*there) == std::signbit((*last)[1]);
                });
                if (passes(along(axis, middle))) {
                    return along(axis, middle);
                }
            }
            if (passes(along(axis, slope))) {
                found = along(axis, slope);
            }
            last = here ? std::optional(std::array{slope, *here}) : std::nullopt;
        }
        return found;
    }

    /// The end of the pupil in a direction from a point inside, by bisection: holes and their
    /// images are convex.
    [[nodiscard]] Direction border(const Direction& inside, double angle) const {
        constexpr double outside = 2.0;
        const auto at = [&](double t) {
            return Direction{inside[0] + t * std::cos(angle), inside[1] + t * std::sin(angle)};
        };
        return at(last_of(0.0, outside, [&](double t) { return passes(at(t)); }));
    }
    /// Such ends all round; or, from an axis that the point is on, half round, which is symmetric.
    [[nodiscard]] std::vector<Direction> border(const Direction& inside,
                                                std::optional<std::size_t> axis, int count) const {
        std::vector<Direction> found;
        for (int i = 0; i <= (axis ? count / 2 : count - 1); ++i) {
            found.push_back(
                border(inside, 2.0 * half_turn * i / count + (axis == 1 ? 0.5 * half_turn : 0.0)));
        }
        return found;
    }
    /// The extent along an axis that the point is on: the ends of the convex pupil are on it.
    [[nodiscard]] std::array<double, 2> extent(const Direction& inside, std::size_t axis) const {
        const double angle = axis == 1 ? 0.5 * half_turn : 0.0;
        return {border(inside, angle + half_turn)[axis], border(inside, angle)[axis]};
    }

private:
    [[nodiscard]] static Direction along(std::size_t axis, double slope) {
        return axis == 0 ? Direction{slope, 0.0} : Direction{0.0, slope};
    }
    [[nodiscard]] std::optional<LensPath<double>> trace(const Direction& d) const {
        const double square = d[0] * d[0] + d[1] * d[1];
        if (!(square < 1.0)) {
            return std::nullopt;
        }
        return traced(lens_, at_, point_, {d[0], d[1], std::sqrt(1.0 - square)});
    }
    /// Where the ray crosses the plane of the stop, if it gets there.
    [[nodiscard]] std::optional<double> at_stop(std::size_t axis, double slope) const {
        const auto ray = trace(along(axis, slope));
        return ray && ray->refracted ? std::optional(ray->at_stop[axis]) : std::nullopt;
    }

    const LensOptics& lens_;
    const FocusedOptics<double>& at_;
    std::array<double, 2> point_;
};

/// The pupil of a point in the direction (x, y) from the axis, from where the direction to the
/// middle of the last surface has the slope s.
PupilOfPoint pupil_at(const LensOptics& lens, const FocusedOptics<double>& at,
                      const Direction& toward, double s) {
    const double p = s / std::sqrt(1.0 - s * s);
    return {lens, at, p * toward[0], p * toward[1]};
}

constexpr std::array<Direction, 2> axes{{{1.0, 0.0}, {0.0, 1.0}}};

std::optional<std::size_t> axis_of(const Direction& toward) {
    return toward == axes[0]   ? std::optional<std::size_t>(0)
           : toward == axes[1] ? std::optional<std::size_t>(1)
                               : std::nullopt;
}

/// The slope of the farthest point on an axis that light reaches, up to 87 degrees.
double farthest(const LensOptics& lens, const FocusedOptics<double>& at, std::size_t axis) {
    constexpr double step = 0.05;
    constexpr double limit = 0.9986;
    const auto lit = [&](double s) {
        return pupil_at(lens, at, axes[axis], s).inside(axis).has_value();
    };
    double s = step;
    while (s < limit && lit(s)) {
        s = std::min(s + step, limit);
    }
    return last_of(std::max(s - step, 0.0), s, lit);
}

/// Slopes of a table's values at equal steps, by differences.
std::vector<double> slopes_of(const std::vector<double>& values, double step) {
    std::vector<double> slopes;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::size_t before = i == 0 ? 0 : i - 1;
        const std::size_t after = std::min(i + 1, values.size() - 1);
        slopes.push_back((values[after] - values[before]) /
                         (step * static_cast<double>(after - before)));
    }
    return slopes;
}

/// Many, as the middle moves abruptly where another hole begins to limit the pupil.
constexpr int cells = 48;

/// Knots at which the size is found: some of the tables', and between the last ones, where the
/// middle moves most.
std::vector<double> knots_of_sizes() {
    constexpr int step = 2;
    std::vector<double> made;
    for (int i = 0; i < cells - step; i += step) {
        made.push_back(i);
    }
    for (double knot = cells - step; knot <= cells; knot += 0.5) {
        made.push_back(knot);
    }
    return made;
}

/// The slopes at knots of the tables, equal steps of their square, and between them. In the middle
/// itself h s is 0.
double slope_at(double largest_square, double knot) {
    const double step = largest_square / cells;
    return std::sqrt(std::max(step * knot, 1e-6 * step));
}

/// Of the circle around a border that is the smallest with its middle on an axis and well inside.
/// It is hardly larger than the stop's image where another hole takes a part of that.
double middle_of(const std::vector<Direction>& border, std::size_t axis, double ratio) {
    constexpr double inset = 0.1;
    constexpr int steps = 40;
    const auto [least, most] = std::minmax_element(
        border.begin(), border.end(),
        [axis](const Direction& a, const Direction& b) { return a[axis] < b[axis]; });
    const double width = (*most)[axis] - (*least)[axis];
    double low = (*least)[axis] + inset * width;
    double high = (*most)[axis] - inset * width;
    const std::array<double, 2> scale{1.0, ratio};
    const auto reach = [&](double middle) {
        double farthest = 0.0;
        for (const Direction& d : border) {
            farthest = std::max(farthest, std::hypot((d[axis] - middle) / scale[axis],
                                                     d[1 - axis] / scale[1 - axis]));
        }
        return farthest;
    };
    for (int i = 0; i < steps; ++i) {
        const double step = (high - low) / 3.0;
        if (reach(low + step) < reach(high - step)) {
            high -= step;
        } else {
            low += step;
        }
    }
    return 0.5 * (low + high);
}

expr::Table middles(const LensOptics& lens, const FocusedOptics<double>& at, std::size_t axis,
                    double ratio, double largest_square) {
    constexpr int directions = 24;
    std::vector<double> values;
    for (int i = 0; i <= cells; ++i) {
        const double s = slope_at(largest_square, i == cells ? cells - 1e-3 : i);
        const PupilOfPoint pupil = pupil_at(lens, at, axes[axis], s);
        const auto inside = pupil.inside(axis);
        if (!inside) {
            values.push_back(values.back());
            continue;
        }
        values.push_back(-middle_of(pupil.border(*inside, axis, directions), axis, ratio) / s);
    }
    return expr::hermite_table(0.0, largest_square, values,
                               slopes_of(values, largest_square / cells));
}

/// The first half axis of ellipses that are as wide as the pupils of all points in one direction
/// from the axis; the second one is it times the ratio.
double half_axis(const ExitPupil& pupils, double ratio, const LensOptics& lens,
                 const FocusedOptics<double>& at, const Direction& toward) {
    constexpr double margin = 1.01;  // For corners of a border between two of its points.
    constexpr int directions = 96;
    double widest = 0.0;
    for (const double knot : knots_of_sizes()) {
        const double s = slope_at(pupils.largest_square, knot);
        const Direction middle{-s * toward[0] * pupils.middle[0](s * s),
                               -s * toward[1] * pupils.middle[1](s * s)};
        const PupilOfPoint pupil = pupil_at(lens, at, toward, s);
        const auto axis = axis_of(toward);
        const auto inside = axis                   ? pupil.inside(*axis)
                            : pupil.passes(middle) ? std::optional(middle)
                                                   : std::nullopt;
        if (!inside) {
            continue;
        }
        for (const Direction& d : pupil.border(*inside, axis, directions)) {
            widest = std::max(widest, std::hypot(d[0] - middle[0], (d[1] - middle[1]) / ratio));
        }
    }
    return margin * at.depth() * widest;
}

/// How much higher than wide the pupil of the middle of the sensor is.
double ratio_of(const LensOptics& lens, const FocusedOptics<double>& at) {
    const PupilOfPoint middle = pupil_at(lens, at, axes[0], 0.0);
    const Direction inside = *middle.inside(0);
    const auto [left, right] = middle.extent(inside, 0);
    const auto [low, high] = middle.extent(inside, 1);
    return (high - low) / (right - left);
}

/// The directions from the axis in which pupils are found: all are the same unless the lens is
/// anamorphic, and then those in a quarter.
std::vector<Direction> directions_of(bool anamorphic) {
    constexpr int count = 4;
    std::vector<Direction> made{axes[0]};
    for (int i = 1; anamorphic && i < count; ++i) {
        const double angle = 0.5 * half_turn * i / count;
        made.push_back({std::cos(angle), std::sin(angle)});
    }
    if (anamorphic) {
        made.push_back(axes[1]);
    }
    return made;
}

}  // namespace

std::optional<ExitPupil> find_exit_pupil(const LensOptics& with_blades,
                                         const std::optional<FocusingGroup>& group,
                                         std::span<const double> vergences) {
    LensOptics lens = with_blades;
    lens.blades = {};  // They are inside of a circle, which is symmetric.
    const bool anamorphic =
        std::any_of(lens.surfaces.begin(), lens.surfaces.end(),
                    [](const RefractingSurface& s) { return s.shape.curvature_x.has_value(); });
    const std::size_t axis_count = anamorphic ? 2 : 1;
    ExitPupil made;
    for (const double vergence : vergences) {
        const FocusedOptics<double> at = focused(lens, group, vergence);
        if (!at.valid || !(at.depth() > 0.0) || !pupil_at(lens, at, axes[0], 0.0).inside(0)) {
            return std::nullopt;
        }
        for (std::size_t axis = 0; axis < axis_count; ++axis) {
            made.largest_square =
                std::max(made.largest_square, std::pow(farthest(lens, at, axis), 2));
        }
    }
    const FocusedOptics<double> first = focused(lens, group, vergences.front());
    const double ratio = anamorphic ? ratio_of(lens, first) : 1.0;
    made.middle[0] = middles(lens, first, 0, ratio, made.largest_square);
    made.middle[1] =
        anamorphic ? middles(lens, first, 1, ratio, made.largest_square) : made.middle[0];
    for (const double vergence : vergences) {
        const FocusedOptics<double> at = focused(lens, group, vergence);
        for (const Direction& toward : directions_of(anamorphic)) {
            made.radius[0] = std::max(made.radius[0], half_axis(made, ratio, lens, at, toward));
        }
    }
    made.radius[1] = ratio * made.radius[0];
    return made;
}

}  // namespace balcony::camera
