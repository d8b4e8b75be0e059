// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/maps/profile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "camera/maps/inverse_map.hpp"
#include "camera/maps/piecewise_table.hpp"

namespace balcony::camera::maps {

namespace {

double middle(const Interval& interval) { return 0.5 * (interval.first + interval.last); }
double half_length(const Interval& interval) { return 0.5 * (interval.last - interval.first); }

// The root of an increasing or decreasing function between two places (Chandrupatla, "A new hybrid
// quadratic/bisection algorithm for finding the zero of a nonlinear function", 1997).
double solved(const AngleFunctions::Function& function, double target, const Interval& between) {
    struct Sample {
        double at, value;
    };
    const auto sample = [&](double at) { return Sample{at, function(at) - target}; };
    Sample a = sample(between.last);
    Sample b = sample(between.first);
    double fraction = 0.5;
    for (int step = 0; step < 100 && a.value != 0.0 && b.value != 0.0; ++step) {
        const Sample next = sample(a.at + fraction * (b.at - a.at));
        Sample c = a;
        if ((next.value < 0.0) != (a.value < 0.0)) {
            c = b;
            b = a;
        }
        a = next;
        const double least = 2.0 * std::numeric_limits<double>::epsilon() / std::fabs(b.at - a.at);
        if (least > 0.5) {
            break;
        }
        // Inverse quadratic interpolation where it is sure to help.
        const double xi = (a.at - b.at) / (c.at - b.at);
        const double phi = (a.value - b.value) / (c.value - b.value);
        const bool helps = phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi;
        fraction = helps ? a.value / (b.value - a.value) * c.value / (b.value - c.value) +
                               (c.at - a.at) / (b.at - a.at) * a.value / (c.value - a.value) *
                                   b.value / (c.value - b.value)
                         : 0.5;
        fraction = std::clamp(fraction, least, 1.0 - least);
    }
    return std::fabs(a.value) < std::fabs(b.value) ? a.at : b.at;
}

}  // namespace

struct Profile::ClosedForm {
    using Function = double (*)(double);
    using Formula = Expr (*)(Expr);
    Function outer;
    Function inner;
    Formula outer_formula;
    Formula inverse_of_inner;
};

struct Profile::Tables {
    /// The variable of the tables is 0 in the middle of an interval of the coordinate, or of the
    /// angle where that has a closed form, and -1 and 1 at its ends. There it changes so fast that
    /// powers of the distance from the end become smooth: the coordinate is
    /// middle + half sin(pi/2 sin(pi/2 s)).
    Interval interval;
    PiecewiseTable second;
    std::optional<PiecewiseTable> angle;

    /// Null if the coordinate is infinite at an end, or if no table is close enough.
    [[nodiscard]] static std::shared_ptr<const Tables> make(const AngleFunctions& functions,
                                                            bool by_angle);
    [[nodiscard]] static double place_of(double s) {
        return std::sin(0.5 * pi * std::sin(0.5 * pi * s));
    }
    template <class Number>
    [[nodiscard]] static Number variable_of(const Number& place) {
        using std::asin;
        return (2.0 / pi) * asin((2.0 / pi) * asin(place));
    }
};

const Profile::ClosedForm* Profile::closed_form(const AngleFunctions& functions, Profile& profile) {
    static constexpr auto same = [](double a) { return a; };
    static constexpr auto same_formula = [](Expr a) { return a; };
    static const std::array forms{
        ClosedForm{same, same, same_formula, same_formula},
        ClosedForm{same, std::sin, same_formula, [](Expr a) { return asin(a); }},
        ClosedForm{same, [](double a) { return std::asinh(std::tan(a)); }, same_formula,
                   [](Expr a) { return atan(sinh(a)); }},
        ClosedForm{same, std::tan, same_formula, [](Expr a) { return atan(a); }},
        ClosedForm{same, [](double a) { return std::tan(0.5 * a); }, same_formula,
                   [](Expr a) { return 2.0 * atan(a); }},
        ClosedForm{same, [](double a) { return std::sin(0.5 * a); }, same_formula,
                   [](Expr a) { return 2.0 * asin(a); }},
        ClosedForm{[](double a) { return a * a; }, std::sin, [](Expr a) { return a * a; },
                   [](Expr a) { return asin(a); }},
        ClosedForm{std::log, [](double a) { return std::asinh(std::tan(a)); },
                   [](Expr a) { return log(a); }, [](Expr a) { return atan(sinh(a)); }},
    };
    for (const ClosedForm& form : forms) {
        for (const double shift : {0.0, functions.shift}) {
            const auto pair_at = [&](double fraction) {
                const double angle =
                    std::lerp(functions.parameters.first, functions.parameters.last, fraction);
                return std::array{form.inner(angle - shift),
                                  form.outer(functions.coordinate(angle))};
            };
            const auto [a, at_a] = pair_at(0.31);
            const auto [b, at_b] = pair_at(0.62);
            const double scale = (at_b - at_a) / (b - a);
            const double offset = at_a - scale * a;
            bool fits = std::isfinite(scale);
            for (const double fraction : {0.21, 0.35, 0.48, 0.57, 0.71, 0.79}) {
                const auto [inner, outer] = pair_at(fraction);
                fits = fits && std::fabs(scale * inner + offset - outer) <=
                                   1e-13 * (1.0 + std::fabs(outer) + std::fabs(scale * inner));
            }
            if (fits) {
                profile.shift_ = shift;
                profile.scale_ = scale;
                profile.offset_ = offset;
                return &form;
            }
        }
    }
    return nullptr;
}

std::optional<Profile> Profile::make(const AngleFunctions& functions) {
    Profile made;
    made.angles_ = functions.parameters;
    if (!functions.angle) {
        made.form_ = closed_form(functions, made);
    }
    if (made.second_by_cosine(functions) && made.form_ != nullptr) {
        return made;
    }
    made.tables_ = Tables::make(functions, made.form_ != nullptr);
    return made.tables_ ? std::optional(made) : std::nullopt;
}

bool Profile::second_by_cosine(const AngleFunctions& functions) {
    const auto at = [&](double fraction) {
        return std::lerp(functions.parameters.first, functions.parameters.last, fraction);
    };
    const double a = at(0.3);
    const double b = at(0.45);
    by_cosine_ = (functions.second(a) - functions.second(b)) / (std::cos(a) - std::cos(b));
    by_cosine_ = std::fabs(by_cosine_) < 1e-13 ? 0.0 : by_cosine_;
    constant_ = functions.second(a) - by_cosine_ * std::cos(a);
    constexpr std::array fractions{0.03, 0.2, 0.5, 0.75, 0.97};
    return std::all_of(fractions.begin(), fractions.end(), [&](double fraction) {
        const double angle = at(fraction);
        return std::fabs(constant_ + by_cosine_ * std::cos(angle) - functions.second(angle)) <=
               1e-13;
    });
}

std::shared_ptr<const Profile::Tables> Profile::Tables::make(const AngleFunctions& functions,
                                                             bool by_angle) {
    // The pieces of the tables, in the order of their variable.
    std::vector<double> ends{functions.parameters.first};
    ends.insert(ends.end(), functions.breaks.begin(), functions.breaks.end());
    ends.push_back(functions.parameters.last);
    const auto coordinate = [&](double parameter) {
        return by_angle ? parameter : functions.coordinate(parameter);
    };
    if (coordinate(ends.front()) > coordinate(ends.back())) {
        std::reverse(ends.begin(), ends.end());
    }
    const Interval whole{coordinate(ends.front()), coordinate(ends.back())};
    constexpr double largest = 8.0;  // a coordinate that is infinite at an end may be less there
    if (!(std::fabs(whole.first) < largest && std::fabs(whole.last) < largest)) {
        return nullptr;
    }
    std::vector<double> places;
    for (const double end : ends) {
        const double place = (coordinate(end) - middle(whole)) / half_length(whole);
        places.push_back(variable_of(std::clamp(place, -1.0, 1.0)));
    }
    const auto value_at = [&](double s) {
        return middle(whole) + half_length(whole) * place_of(s);
    };
    const auto parameter_of = [&](std::size_t piece, double value) {
        return by_angle ? value
                        : solved(functions.coordinate, value,
                                 {std::min(ends[piece], ends[piece + 1]),
                                  std::max(ends[piece], ends[piece + 1])});
    };
    const auto angle_of = [&](std::size_t piece, double value) {
        const double parameter = parameter_of(piece, value);
        return functions.angle ? functions.angle(parameter) : parameter;
    };
    const auto second_of = [&](std::size_t piece, double value) {
        return functions.second(parameter_of(piece, value));
    };
    // A function of the coordinate as a table. A value is right if a coordinate nearby has it.
    const auto table = [&](const auto& function, double nearby) {
        const auto error = [&, nearby](std::size_t piece, double s, double value) {
            const double a = function(piece, std::max(value_at(s) - nearby, whole.first));
            const double b = function(piece, std::min(value_at(s) + nearby, whole.last));
            return value - std::clamp(value, std::min(a, b), std::max(a, b));
        };
        return PiecewiseTable::make(
            places, [&](std::size_t piece, double s) { return function(piece, value_at(s)); },
            error, table_error);
    };
    std::optional<PiecewiseTable> angle;
    if (!by_angle) {
        constexpr double much_less = 0.01 * table_error;
        angle = table(angle_of, much_less);
    }
    constexpr double rounding = 1e-15;
    std::optional<PiecewiseTable> second = table(second_of, rounding);
    if (!second || (!by_angle && !angle)) {
        return nullptr;
    }
    return std::make_shared<const Tables>(Tables{whole, std::move(*second), std::move(angle)});
}

Profile::Values Profile::operator()(Expr coordinate, Emitter& emit) const {
    Expr angle;
    if (form_ != nullptr) {
        angle =
            form_->inverse_of_inner((form_->outer_formula(coordinate) - offset_) / scale_) + shift_;
        emit.require(angles_.first <= angle && angle <= emit(angles_.last));
    }
    if (!tables_) {
        return {angle, constant_ + by_cosine_ * cos(angle)};
    }
    const Expr place = ((form_ != nullptr ? angle : coordinate) - middle(tables_->interval)) /
                       half_length(tables_->interval);
    emit.require(abs(place) <= emit(1.0));
    const Expr s = Tables::variable_of(place);
    if (tables_->angle) {
        angle = (*tables_->angle)(s, emit);
    }
    return {angle, tables_->second(s, emit)};
}

}  // namespace balcony::camera::maps
