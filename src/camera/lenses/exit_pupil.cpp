// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/lenses/exit_pupil.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace balcony::camera {

namespace {

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

/// The directions in which light reaches one point of the sensor. The lens is symmetric, so that
/// the point may be on the x axis; the directions are then the same for n and -n.
class PupilOfPoint {
public:
    PupilOfPoint(const LensOptics& lens, const FocusedOptics<double>& at, double p)
        : lens_(lens), at_(at), x_(p * at.depth()) {
        find_inside();
    }

    [[nodiscard]] bool passes(const Direction& d) const {
        const auto ray = trace(d);
        return ray && ray->passed;
    }
    [[nodiscard]] const std::optional<double>& inside() const { return inside_; }

    /// Points of its border, by bisection from a point inside: holes and their images are convex.
    [[nodiscard]] std::vector<Direction> border() const {
        constexpr int count = 48;
        constexpr double outside = 2.0;
        std::vector<Direction> found;
        for (int i = 0; i <= count && inside_; ++i) {
            const double angle = std::numbers::pi * i / count;
            const auto at = [&](double t) {
                return Direction{*inside_ + t * std::cos(angle), t * std::sin(angle)};
            };
            found.push_back(at(last_of(0.0, outside, [&](double t) { return passes(at(t)); })));
        }
        return found;
    }

private:
    [[nodiscard]] std::optional<LensPath<double>> trace(const Direction& d) const {
        const double square = d[0] * d[0] + d[1] * d[1];
        if (!(square < 1.0)) {
            return std::nullopt;
        }
        return traced(lens_, at_, {x_, 0.0}, {d[0], d[1], std::sqrt(1.0 - square)});
    }
    /// Where the ray crosses the plane of the stop, if it gets there.
    [[nodiscard]] std::optional<double> at_stop(double m) const {
        const auto ray = trace({m, 0.0});
        return ray && ray->refracted ? std::optional(ray->at_stop[0]) : std::nullopt;
    }

    // The ray through the middle of the stop, or any other that passes, among those to the hole of
    // the last surface; its rim is not in the plane of its vertex.
    void find_inside() {
        constexpr int count = 128;
        constexpr double around = 1.5;
        const double hole = around * lens_.surfaces.back().shape.radius;
        std::optional<std::array<double, 2>> last;  // m and where it crosses the stop
        for (int i = 0; i <= count; ++i) {
            const double across = hole * (2.0 * i / count - 1.0) - x_;
            const double m = across / std::hypot(across, at_.depth());
            const auto here = at_stop(m);
            if (here && last && std::signbit(*here) != std::signbit((*last)[1])) {
                const double middle = last_of((*last)[0], m, [&](double between) {
                    const auto there = at_stop(between);
                    return there && std::signbit(*there) == std::signbit((*last)[1]);
                });
                if (passes({middle, 0.0})) {
                    inside_ = middle;
                    return;
                }
            }
            if (passes({m, 0.0})) {
                inside_ = m;
            }
            last = here ? std::optional(std::array{m, *here}) : std::nullopt;
        }
    }

    const LensOptics& lens_;
    const FocusedOptics<double>& at_;
    double x_;
    std::optional<double> inside_;
};

/// sin θ of the direction from a point of the sensor to the middle of the last surface.
double sine_of(double p) { return p / std::hypot(1.0, p); }

/// The middle of a border, which is symmetric.
double middle_of(const std::vector<Direction>& border) {
    const auto [least, most] = std::minmax_element(border.begin(), border.end());
    return 0.5 * ((*least)[0] + (*most)[0]);
}

/// p of the farthest point that light reaches.
double farthest(const LensOptics& lens, const FocusedOptics<double>& at) {
    constexpr double step = 0.05;
    constexpr double limit = 20.0;
    const auto lit = [&](double p) { return PupilOfPoint(lens, at, p).inside().has_value(); };
    double p = step;
    while (p < limit && lit(p)) {
        p += step;
    }
    return last_of(p - step, p, lit);
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

}  // namespace

std::optional<ExitPupil> find_exit_pupil(const LensOptics& lens,
                                         const std::optional<FocusingGroup>& group,
                                         std::span<const double> vergences) {
    constexpr int cells = 12;
    constexpr double margin = 1.01;  // For corners of a border between two of its points.
    ExitPupil made;
    for (const double vergence : vergences) {
        const FocusedOptics<double> at = focused(lens, group, vergence);
        if (!at.valid || !(at.depth() > 0.0) || !PupilOfPoint(lens, at, 0.0).inside().has_value()) {
            return std::nullopt;
        }
        made.largest_square =
            std::max(made.largest_square, std::pow(sine_of(farthest(lens, at)), 2));
    }
    // At knots of the table, equal steps of sin² θ, and between them. In the middle itself h sin θ
    // is 0.
    const double step = made.largest_square / cells;
    const auto p_at = [&](double knot) {
        const double square = std::max(step * knot, 1e-6 * step);
        return std::sqrt(square / (1.0 - square));
    };
    const FocusedOptics<double> first = focused(lens, group, vergences.front());
    std::vector<double> values;
    for (int i = 0; i <= cells; ++i) {
        const double p = p_at(i == cells ? cells - 1e-3 : i);
        const auto border = PupilOfPoint(lens, first, p).border();
        values.push_back(border.empty() ? values.back() : -middle_of(border) / sine_of(p));
    }
    made.middle = expr::hermite_table(0.0, made.largest_square, values, slopes_of(values, step));
    for (const double vergence : vergences) {
        const FocusedOptics<double> at = focused(lens, group, vergence);
        for (int i = 0; i <= 2 * cells; ++i) {
            const double p = p_at(0.5 * i);
            const double sine = sine_of(p);
            const double middle = -sine * made.middle(sine * sine);
            for (const Direction& d : PupilOfPoint(lens, at, p).border()) {
                made.radius =
                    std::max(made.radius, margin * at.depth() * std::hypot(d[0] - middle, d[1]));
            }
        }
    }
    return made;
}

}  // namespace balcony::camera
