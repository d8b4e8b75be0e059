// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/calibrated/undistortion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace balcony::camera {

namespace {

constexpr std::size_t max_steps = 12;  // Newton doubles the number of digits in each
constexpr int spokes = 24;             // along which a distortion without symmetry is tried

PlanePoint<double> on_spoke(int spoke, double radius) {
    const double angle = 2.0 * std::numbers::pi * spoke / spokes;
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

double radial_part(const Distortion& d, double radius) {
    return radius * radial_factor(d, radius * radius);
}

/// The coefficients by powers of t of the polynomial that has the values at Chebyshev's points
/// t = cos(pi (i + 1/2)/n), which is nearly the best one from -1 to 1: Press et al., "Numerical
/// Recipes", section 5.8.
std::vector<double> interpolated(const std::vector<double>& values) {
    const std::size_t n = values.size();
    std::vector<double> sum(n, 0.0);
    std::vector<double> before(n, 0.0);
    std::vector<double> power(n, 0.0);  // Chebyshev's polynomials by powers of t
    power[0] = 1.0;
    for (std::size_t k = 0; k < n; ++k) {
        double coefficient = 0.0;
        for (std::size_t i = 0; i < n; ++i) {
            coefficient +=
                values[i] * std::cos(std::numbers::pi * static_cast<double>(k) *
                                     (static_cast<double>(i) + 0.5) / static_cast<double>(n));
        }
        coefficient *= (k == 0 ? 1.0 : 2.0) / static_cast<double>(n);
        std::vector<double> next(n, 0.0);
        for (std::size_t j = 0; j < n; ++j) {
            sum[j] += coefficient * power[j];
            if (j + 1 < n) {
                next[j + 1] = (k == 0 ? 1.0 : 2.0) * power[j];
            }
            next[j] -= k == 0 ? 0.0 : before[j];
        }
        before = std::exchange(power, std::move(next));
    }
    return sum;
}

double larger(double a, double b) { return std::max(a, b); }
Expr larger(Expr a, double b) { return max(a, a.graph().constant(b)); }

}  // namespace

Undistortion::Undistortion(Distortion distortion, double needed, double limit)
    : distortion_(std::move(distortion)), needed_(needed) {
    find_radius(limit);
    if (exists()) {
        fit_guess();
        count_steps();
    }
}

// A guess along the radius is too far away where a distortion that is not radial nearly folds. What
// is lost there is squeezed into some ten-thousandths of the image.
bool Undistortion::is_monotone_at(double radius) const {
    const double least = distortion_.is_radial() ? 0.0 : 0.02 * distortion_.numerator.front();
    for (int spoke = 0; spoke < (distortion_.is_radial() ? 1 : spokes); ++spoke) {
        const auto [x, y] = distorted_with_derivatives(distortion_, on_spoke(spoke, radius));
        const double shear = 0.5 * (x.by_b + y.by_a);
        const double a = x.by_a - least;
        const double b = y.by_b - least;
        // Written so that a NaN is no inverse.
        if (!(a > 0.0 && a * b - shear * shear > 0.0)) {
            return false;
        }
    }
    return true;
}

// Outwards until the image is covered, the distortion folds or nothing more is to be seen.
void Undistortion::find_radius(double limit) {
    if (!is_monotone_at(0.0)) {
        return;
    }
    double inside = 0.0;
    double outside = 0.0;
    while (outside < limit) {
        outside = std::min(inside + std::max(needed_ / 256.0, inside / 64.0), limit);
        folds_ = !is_monotone_at(outside);
        if (folds_) {
            break;
        }
        inside = outside;
        bool covers = true;
        for (int spoke = 0; spoke < spokes; ++spoke) {
            const auto [x, y] = distorted(distortion_, on_spoke(spoke, inside));
            covers = covers && std::hypot(x, y) >= needed_;
        }
        if (covers) {
            radius_ = inside;
            return;
        }
    }
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (inside + outside);
        (is_monotone_at(middle) ? inside : outside) = middle;
    }
    radius_ = inside;
}

void Undistortion::fit_guess() {
    constexpr std::size_t terms = 8;
    const double reach = radial_part(distortion_, radius_);
    squared_reach_ = reach * reach;
    std::vector<double> ratios;
    for (std::size_t i = 0; i < terms; ++i) {
        const double t = std::cos(std::numbers::pi * (static_cast<double>(i) + 0.5) /
                                  static_cast<double>(terms));
        const double part = 0.5 * (t + 1.0);
        const double wanted = reach * std::sqrt(folds_ ? 1.0 - part * part : part);
        double inside = 0.0;
        double outside = radius_;
        for (int k = 0; k < 60; ++k) {
            const double middle = 0.5 * (inside + outside);
            (radial_part(distortion_, middle) < wanted ? inside : outside) = middle;
        }
        ratios.push_back(0.5 * (inside + outside) / wanted);
    }
    guess_ = interpolated(ratios);
}

// Tries the inverse all over the disc, which ends before a fold, where Newton's method is slow:
// what is lost there is about a millionth of the image.
void Undistortion::count_steps() {
    constexpr int rings = 64;
    const double whole = folds_ ? radius_ * (1.0 - 1e-3) : radius_;
    radius_ = 0.0;
    for (int ring = 1; ring <= rings; ++ring) {
        const double radius = whole * ring / rings;
        for (int spoke = 0; spoke < (distortion_.is_radial() ? 1 : spokes); ++spoke) {
            const PlanePoint<double> p = distorted(distortion_, on_spoke(spoke, radius));
            const auto is_solved = [&] {
                const auto [x, y] = distorted(distortion_, solved(p, steps_));
                return std::hypot(x - p.a, y - p.b) <= inverse_accuracy * needed_;
            };
            while (!is_solved()) {
                if (++steps_ > max_steps) {
                    steps_ = max_steps;
                    return;
                }
            }
        }
        radius_ = radius;
    }
}

template <class Number>
Number Undistortion::guessed_ratio(const Number& squared_radius) const {
    using std::sqrt;
    constexpr double tiny = 1e-12;  // where the root still has a derivative
    const Number rest = larger(1.0 - squared_radius / squared_reach_, tiny);
    return polynomial(guess_, folds_ ? 2.0 * sqrt(rest) - 1.0 : 1.0 - 2.0 * rest);
}

// Newton's method: for the ratio s of the radii, s N(s²q)/D(s²q) = 1, or for both co-ordinates.
template <class Number>
PlanePoint<Number> Undistortion::solved(const PlanePoint<Number>& p, std::size_t steps) const {
    const Number q = p.a * p.a + p.b * p.b;
    Number ratio = guessed_ratio(q);
    if (distortion_.is_radial()) {
        const Number zero = 0.0 * q;
        for (std::size_t step = 0; step < steps; ++step) {
            const Dual<Number> s{ratio, zero + 1.0, zero};
            const Dual<Number> one =
                s * radial_factor(distortion_, Dual<Number>{q, zero, zero} * (s * s));
            ratio = ratio - (one.value - 1.0) / one.by_a;
        }
        return {ratio * p.a, ratio * p.b};
    }
    // The radial inverse of what is left of p without the other part, for a better guess.
    const auto [a, b] = sideways_part(distortion_, PlanePoint<Number>{ratio * p.a, ratio * p.b});
    const PlanePoint<Number> left{p.a - a, p.b - b};
    ratio = guessed_ratio(Number(left.a * left.a + left.b * left.b));
    PlanePoint<Number> found{ratio * left.a, ratio * left.b};
    for (std::size_t step = 0; step < steps; ++step) {
        const auto [x, y] = distorted_with_derivatives(distortion_, found);
        const Number miss_x = x.value - p.a;
        const Number miss_y = y.value - p.b;
        const Number determinant = x.by_a * y.by_b - x.by_b * y.by_a;
        found = {found.a - (y.by_b * miss_x - x.by_b * miss_y) / determinant,
                 found.b - (x.by_a * miss_y - y.by_a * miss_x) / determinant};
    }
    return found;
}

PlanePoint<Expr> Undistortion::emit(const PlanePoint<Expr>& p, Emitter& emit) const {
    const PlanePoint<Expr> found = solved(p, steps_);
    const auto [x, y] = distorted(distortion_, found);
    const Expr miss_x = x - p.a;
    const Expr miss_y = y - p.b;
    const double allowed = inverse_doubt * needed_;
    emit.require(miss_x * miss_x + miss_y * miss_y <= emit(allowed * allowed));
    emit.require(found.a * found.a + found.b * found.b <= emit(radius_ * radius_));
    return found;
}

}  // namespace balcony::camera
