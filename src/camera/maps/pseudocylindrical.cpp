// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/maps/pseudocylindrical.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "camera/maps/parallels.hpp"

namespace balcony::camera::maps {

namespace {

constexpr double sqrt3 = std::numbers::sqrt3;

double root_of_one_plus_square(double a) { return std::hypot(1.0, a); }

/// A map that is defined through another parameter than latitude (Snyder, "Flattening the Earth",
/// 1993). y, the width of a radian and the derivative of the sine of latitude are these functions
/// of it, except for constant factors.
struct ParametricMap {
    using Part = double (*)(double);

    std::string_view name;
    Interval parameters;  ///< From the south pole to the north pole.
    Part y;
    Part width;
    Part sine_slope;  ///< Accurate near its zeros.

    /// Accurate near the poles, where the sine is flat.
    [[nodiscard]] double latitude(double a) const {
        const double to_north = integral(a, parameters.last);
        const double to_south = integral(parameters.first, a);
        const double to_pole = std::min(to_north, to_south) / (to_north + to_south);
        return std::copysign(0.5 * pi - 2.0 * std::asin(std::sqrt(to_pole)), to_south - to_north);
    }

private:
    // Of the slope, by Gauss-Legendre quadrature with five points in each of several steps.
    [[nodiscard]] double integral(double from, double to) const {
        constexpr std::array nodes{0.0, 0.5384693101056831, 0.9061798459386640};
        constexpr std::array weights{0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
        constexpr int steps = 4;
        const double half = 0.5 * (to - from) / steps;
        double sum = 0.0;
        for (int i = 0; i < steps; ++i) {
            const double middle = from + (2 * i + 1) * half;
            sum += weights[0] * sine_slope(middle);
            for (std::size_t k = 1; k < nodes.size(); ++k) {
                sum += weights[k] * (sine_slope(middle - nodes[k] * half) +
                                     sine_slope(middle + nodes[k] * half));
            }
        }
        return half * sum;
    }
};

double square(double a) { return a * a; }

const ParametricMap mollweide{"moll", {-0.5 * pi, 0.5 * pi}, std::sin, std::cos, [](double a) {
                                  return square(std::cos(a));
                              }};

const std::array parametric_maps{
    mollweide,
    ParametricMap{"eck4",
                  {-0.5 * pi, 0.5 * pi},
                  std::sin,
                  [](double a) { return 1.0 + std::cos(a); },
                  [](double a) { return std::cos(a) * (1.0 + std::cos(a)); }},
    ParametricMap{"putp2",
                  {-pi / 3.0, pi / 3.0},
                  std::sin,
                  [](double a) { return std::cos(a) - 0.5; },
                  // cos a (2 cos a - 1)
                  [](double a) {
                      return std::cos(a) * std::sin(0.5 * (pi / 3.0 + a)) *
                             std::sin(0.5 * (pi / 3.0 - a));
                  }},
    ParametricMap{
        "putp6",
        {-sqrt3, sqrt3},
        [](double a) { return a; },
        [](double a) { return 2.0 - root_of_one_plus_square(a); },
        // 2 - sqrt(1 + a^2)
        [](double a) { return (sqrt3 - a) * (sqrt3 + a) / (2.0 + root_of_one_plus_square(a)); }},
    ParametricMap{"collg",
                  {1.0 - std::numbers::sqrt2, 1.0},
                  [](double a) { return a; },
                  [](double a) { return 1.0 - a; },
                  [](double a) { return 1.0 - a; }},
};

// With the factors of PROJ, which are rounded for some maps.
AngleFunctions scaled(const ParametricMap& parametric, const ForwardMap& map, double meridian) {
    const double parameter = 0.6 * parametric.parameters.last;
    const double latitude = parametric.latitude(parameter);
    const MapPoint middle = map({meridian, latitude}).value_or(MapPoint{});
    const MapPoint side = map({meridian + 0.5, latitude}).value_or(MapPoint{});
    const double height = middle.y / parametric.y(parameter);
    const double width = 2.0 * (side.x - middle.x) / parametric.width(parameter);
    return {.coordinate = [=](double a) { return height * parametric.y(a); },
            .second = [=](double a) { return width * parametric.width(a); },
            .parameters = parametric.parameters,
            .angle = [=](double a) { return parametric.latitude(a); }};
}

// Winkel's second map: half of Mollweide's and half of the equirectangular one.
AngleFunctions winkel_2(const Definition& definition) {
    const double cosine = std::cos(definition.angle("lat_1", 0.0));
    // Near the poles, powers of 1/3 of the distance from them meet the table's powers of 1/4.
    std::vector<double> breaks;
    for (double distance = 0.4; distance > 1e-7; distance *= 0.04) {
        breaks.push_back(distance - 0.5 * pi);
        breaks.push_back(0.5 * pi - distance);
    }
    std::sort(breaks.begin(), breaks.end());
    return {.coordinate =
                [](double a) { return 0.25 * pi * std::sin(a) + 0.5 * mollweide.latitude(a); },
            .second = [cosine](double a) { return 0.5 * (std::cos(a) + cosine); },
            .parameters = {-0.5 * pi, 0.5 * pi},
            .angle = [](double a) { return mollweide.latitude(a); },
            .breaks = std::move(breaks)};
}

/// Goode's homolosine: the sinusoidal map up to a latitude, Mollweide's beyond it.
AngleFunctions homolosine(double limit, const ForwardMap& map, double meridian) {
    // Mollweide's parameter at the limit, by Newton's method.
    double at_limit = 0.8 * limit;
    for (int step = 0; step < 20; ++step) {
        at_limit -= (2.0 * at_limit + std::sin(2.0 * at_limit) - pi * std::sin(limit)) /
                    (2.0 + 2.0 * std::cos(2.0 * at_limit));
    }
    // The parameter is latitude up to the limit and continues with Mollweide's.
    const double beyond = at_limit - limit;
    const auto mollweide_parameter = [=](double a) -> std::optional<double> {
        return std::fabs(a) <= limit ? std::nullopt
                                     : std::optional(a < 0.0 ? a - beyond : a + beyond);
    };
    const AngleFunctions outer = scaled(mollweide, map, meridian);
    const double offset = map({meridian, mollweide.latitude(1.0)}).value_or(MapPoint{}).y -
                          std::numbers::sqrt2 * std::sin(1.0);
    const double last = 0.5 * pi - beyond;
    return {.coordinate =
                [=](double a) {
                    const auto m = mollweide_parameter(a);
                    const double shift = a < 0.0 ? -offset : offset;
                    return m ? std::numbers::sqrt2 * std::sin(*m) + shift : a;
                },
            .second =
                [=](double a) {
                    const auto m = mollweide_parameter(a);
                    return m ? outer.second(*m) : std::cos(a);
                },
            .parameters = {-last, last},
            .angle =
                [=](double a) {
                    const auto m = mollweide_parameter(a);
                    return m ? mollweide.latitude(*m) : a;
                },
            .breaks = {-limit, limit}};
}

// PROJ's own numbers for the latitude where the two maps are equally wide.
constexpr double goode_limit = 0.71093078197902358062;
constexpr double interrupted_goode_limit = (40.0 + 44.0 / 60.0 + 11.8 / 3600.0) * degree;

AngleFunctions from_samples(const ForwardMap& map, std::vector<double> breaks) {
    return {.coordinate =
                [&map](double a) {
                    return map({0.0, a}).value_or(MapPoint{}).y;
                },
            .second =
                [&map](double a) {
                    return map({1.0, a}).value_or(MapPoint{}).x;
                },
            .parameters = {-0.5 * pi, 0.5 * pi},
            .breaks = std::move(breaks)};
}

// Robinson's table has a row for every 5 degrees, between which PROJ has cubic polynomials.
std::vector<double> robinson_breaks() {
    std::vector<double> breaks;
    for (int latitude = -85; latitude <= 85; latitude += 5) {
        breaks.push_back(latitude * degree);
    }
    return breaks;
}

Lobe lobe(bool north, double west, double east, double meridian) {
    return {north, west * degree, east * degree, meridian * degree};
}

// The lobes that keep the continents, and those that keep the oceans.
std::vector<Lobe> continents() {
    return {lobe(true, -180, -40, -100), lobe(true, -40, 180, 30), lobe(false, -180, -100, -160),
            lobe(false, -100, -20, -60), lobe(false, -20, 80, 20), lobe(false, 80, 180, 140)};
}
std::vector<Lobe> oceans() {
    return {lobe(true, -180, -90, -140),  lobe(true, -90, 60, -10), lobe(true, 60, 180, 130),
            lobe(false, -180, -60, -110), lobe(false, -60, 90, 20), lobe(false, 90, 180, 150)};
}

/// The loximuthal map (Siemon 1935, Tobler 1966): straight rhumb lines from the middle latitude,
/// true in length and azimuth: y = phi - phi_1, x = lambda y/(q(phi) - q(phi_1)) with Mercator's
/// q = asinh tan(phi).
class Loximuthal final : public InverseMap {
public:
    explicit Loximuthal(double middle) : middle_(middle) {}
    ObjectPoint direction(const ParameterPoint& p, Emitter& emit) const override {
        // Near the middle latitude the quotient of differences is a derivative, to second order.
        constexpr double small = 1e-5;
        const Expr latitude = p.v + middle_;
        emit.require(abs(latitude) < 0.5 * pi);
        const Expr is_small = abs(p.v) < small;
        const Expr y = select(is_small, emit(small), p.v);
        const Expr difference = asinh(tan(y + middle_)) - std::asinh(std::tan(middle_));
        const Expr width = select(is_small, cos(0.5 * p.v + middle_), y / difference);
        emit.require(abs(p.u) <= pi * width);
        return at_longitude_and_latitude_of_map(p.u / width, latitude);
    }

private:
    double middle_;
};

}  // namespace

InverseMapPointer special_pseudocylindrical(const Definition& definition, const ForwardMap& map) {
    const std::string& name = definition.projection;
    for (const ParametricMap& parametric : parametric_maps) {
        if (parametric.name == name) {
            return straight_parallels(scaled(parametric, map, 0.0));
        }
    }
    if (name == "wink2") {
        return straight_parallels(winkel_2(definition));
    }
    if (name == "goode") {
        return straight_parallels(homolosine(goode_limit, map, 0.0));
    }
    if (name == "hatano") {
        return straight_parallels(from_samples(map, {0.0}));
    }
    if (name == "robin") {
        return straight_parallels(from_samples(map, robinson_breaks()));
    }
    if (name == "loxim") {
        return std::make_shared<const Loximuthal>(definition.angle("lat_1", 0.0));
    }
    const std::vector<Lobe> lobes = name.ends_with("_o") ? oceans() : continents();
    const double meridian = lobes.front().meridian;
    if (name == "igh" || name == "igh_o") {
        return lobed_parallels(homolosine(interrupted_goode_limit, map, meridian), lobes, map);
    }
    if (name == "imoll" || name == "imoll_o") {
        return lobed_parallels(scaled(mollweide, map, meridian), lobes, map);
    }
    return nullptr;
}

}  // namespace balcony::camera::maps
