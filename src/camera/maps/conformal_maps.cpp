// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Conformal maps of a region: polynomials of the complex coordinate of a stereographic map.

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "camera/maps/formula_maps.hpp"

namespace balcony::camera::maps {

namespace {

using Complex = std::complex<double>;

/// A complex expression.
struct ComplexExpr {
    Expr re, im;
};
ComplexExpr operator+(const ComplexExpr& a, const Complex& b) {
    return {a.re + b.real(), a.im + b.imag()};
}
ComplexExpr operator-(const ComplexExpr& a, const ComplexExpr& b) {
    return {a.re - b.re, a.im - b.im};
}
ComplexExpr operator*(const ComplexExpr& a, const ComplexExpr& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
ComplexExpr operator/(const ComplexExpr& a, const ComplexExpr& b) {
    const Expr square = b.re * b.re + b.im * b.im;
    return {(a.re * b.re + a.im * b.im) / square, (a.im * b.re - a.re * b.im) / square};
}

/// The power series of a conformal map in the stereographic coordinate z about a point.
struct PowerSeries {
    std::vector<Complex> coefficients;
    double radius = 0.0;  ///< |z| up to which the series is a map without folds.

    [[nodiscard]] ComplexExpr operator()(const ComplexExpr& z, Emitter& emit) const {
        ComplexExpr sum{emit(0.0), emit(0.0)};
        for (std::size_t i = coefficients.size(); i-- > 0;) {
            sum = sum * z + coefficients[i];
        }
        return sum;
    }
    [[nodiscard]] Complex operator()(const Complex& z) const {
        Complex sum = 0.0;
        for (std::size_t i = coefficients.size(); i-- > 0;) {
            sum = sum * z + coefficients[i];
        }
        return sum;
    }
    /// Of the map within the radius.
    [[nodiscard]] MapExtent extent() const {
        MapExtent extent;
        constexpr int points = 360;
        for (int i = 0; i < points; ++i) {
            const Complex w = (*this)(std::polar(radius, 2.0 * pi * i / points));
            extent = {std::min(extent.min_x, w.real()), std::max(extent.max_x, w.real()),
                      std::min(extent.min_y, w.imag()), std::max(extent.max_y, w.imag())};
        }
        return extent;
    }
    [[nodiscard]] PowerSeries derivative() const {
        PowerSeries made{{}, radius};
        for (std::size_t i = 1; i < coefficients.size(); ++i) {
            made.coefficients.push_back(static_cast<double>(i) * coefficients[i]);
        }
        return made;
    }
};

// The coefficients of a polynomial, or of an analytic function that they reach to rounding, by
// Cauchy's integrals round a circle.
std::optional<PowerSeries> power_series(const ForwardMap& map, const SphereAxes& axes,
                                        double circle, std::size_t degree) {
    constexpr int points = 64;
    std::vector<Complex> on_map;
    for (int i = 0; i < points; ++i) {
        const double turn = 2.0 * pi * i / points;
        // The point of the sphere over circle e^(i turn).
        const double k = 4.0 / (4.0 + circle * circle);
        const Direction e{k * (1.0 - 0.25 * circle * circle), k * circle * std::cos(turn),
                          k * circle * std::sin(turn)};
        const auto p = map(axes.on_earth(sphere_point_of(e)));
        if (!p) {
            return std::nullopt;
        }
        on_map.emplace_back(p->x, p->y);
    }
    PowerSeries series;
    for (std::size_t power = 0; power <= degree; ++power) {
        Complex sum = 0.0;
        for (int i = 0; i < points; ++i) {
            const double turn = 2.0 * pi * i / points;
            sum += on_map[static_cast<std::size_t>(i)] *
                   std::polar(1.0, -turn * static_cast<double>(power));
        }
        series.coefficients.push_back(sum / (points * std::pow(circle, power)));
    }
    // A power series is one-to-one where the slopes of its other terms add up to less than that of
    // the first one.
    constexpr double step = 0.001;
    const auto folds = [&series](double radius) {
        double slopes = 0.0;
        for (std::size_t i = 2; i < series.coefficients.size(); ++i) {
            slopes +=
                static_cast<double>(i) * std::abs(series.coefficients[i]) * std::pow(radius, i - 1);
        }
        return slopes >= std::abs(series.coefficients[1]);
    };
    while (series.radius < 1.9 && !folds(series.radius + step)) {
        series.radius += step;
    }
    return series;
}

InverseMapPointer conformal_region(const ForwardMap& map, const SpherePoint& center, double circle,
                                   double largest_radius, std::size_t degree) {
    const SphereAxes axes = along_great_circle(center, 0.5 * pi);
    std::optional<PowerSeries> series = power_series(map, axes, circle, degree);
    if (!series) {
        return nullptr;
    }
    series->radius = std::min(series->radius, largest_radius);
    return in_axes(
        axes, by_formula(
                  [series = *series](const ParameterPoint& p, Emitter& emit) {
                      constexpr int newton_steps = 7;
                      const ComplexExpr w{p.u, p.v};
                      const PowerSeries slope = series.derivative();
                      const Complex first = 1.0 / series.coefficients[1];
                      const ComplexExpr offset = w + -series.coefficients[0];
                      ComplexExpr z = offset * ComplexExpr{emit(first.real()), emit(first.imag())};
                      for (int i = 0; i < newton_steps; ++i) {
                          z = z - (series(z, emit) - w) / slope(z, emit);
                      }
                      const ComplexExpr miss = series(z, emit) - w;
                      const Expr q = z.re * z.re + z.im * z.im;
                      constexpr double doubt = 1e-10;
                      emit.require(q <= emit(series.radius * series.radius) &&
                                   miss.re * miss.re + miss.im * miss.im <= emit(doubt * doubt));
                      const Expr k = 4.0 / (4.0 + q);
                      return ObjectPoint{k * (1.0 - 0.25 * q), k * z.re, k * z.im};
                  },
                  series->extent()));
}

SpherePoint degrees(double longitude, double latitude) {
    return {degree * longitude, degree * latitude};
}

/// A modified stereographic map (Snyder, "Map Projections: A Working Manual", 1987, section 26) is
/// a polynomial of this degree about this point.
template <int longitude, int latitude, int degree>
InverseMapPointer modified_stereographic(const Definition&, const ForwardMap& map) {
    return conformal_region(map, degrees(longitude, latitude), 0.5, 1.9, degree);
}

}  // namespace

std::vector<FormulaMapRow> conformal_maps() {
    return {{"mil_os", modified_stereographic<20, 18, 3>},
            {"lee_os", modified_stereographic<-165, -10, 3>},
            {"gs48", modified_stereographic<-96, 39, 5>},
            {"alsk", modified_stereographic<-152, 64, 6>},
            {"gs50", modified_stereographic<-120, 45, 10>}};
}

}  // namespace balcony::camera::maps
