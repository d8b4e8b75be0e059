// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object generators, PCS → OCS: superellipse and superhyperbola, as curves and as factors of
// spherical products.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "camera/catalogue/families.hpp"
#include "camera/curves/arc_length.hpp"
#include "camera/objects/superconics.hpp"

namespace balcony::camera {

namespace {

// The formulas follow the paper's section 5 and its reference 22. gamma is the superconic
// parameter, e = 2 / gamma: 1 gives the conic, less makes it square, more makes it pointed.

struct PlanePoint {
    Expr x, y;
};

/// A superconic as a curve in the xy plane.
class Superconic : public ObjectGenerator {
public:
    Superconic(Scalar a, Scalar b, Scalar gamma)
        : a_(std::move(a)), b_(std::move(b)), gamma_(std::move(gamma)) {}
    int dimension() const final { return 1; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const final {
        const PlanePoint unit = unit_curve(p.u, emit(gamma_), emit);
        return {emit(a_) * unit.x, emit(b_) * unit.y, emit(0.0)};
    }

private:
    /// The curve with a = b = 1.
    virtual PlanePoint unit_curve(Expr u, Expr gamma, Emitter& emit) const = 0;

    Scalar a_, b_, gamma_;
};

// The point of |x|^e + |y|^e = 1 at polar angle u; r is its distance from the centre.
PlanePoint superellipse_at_angle(Expr u, Expr gamma) {
    const Expr e = 2.0 / gamma;
    const Expr r = pow(pow(abs(cos(u)), e) + pow(abs(sin(u)), e), -1.0 / e);
    return {r * cos(u), r * sin(u)};
}

class TrigonometricSuperellipse final : public Superconic {
    using Superconic::Superconic;
    PlanePoint unit_curve(Expr u, Expr gamma, Emitter&) const override {
        return {signed_power(cos(u), gamma), signed_power(sin(u), gamma)};
    }
};

class AngleCentreSuperellipse final : public Superconic {
    using Superconic::Superconic;
    PlanePoint unit_curve(Expr u, Expr gamma, Emitter&) const override {
        return superellipse_at_angle(u, gamma);
    }
};

constexpr double quarter_turn = 0.5 * std::numbers::pi;
constexpr std::size_t cells_a_quarter = 1024;

/// |d/du| of the angle-centre superellipse (a r cos u, b r sin u), u in the first quadrant.
double superellipse_speed(double a, double b, double gamma, double u) {
    const double e = 2.0 / gamma;
    const double c = std::fabs(std::cos(u));
    const double s = std::fabs(std::sin(u));
    const double c_power = std::pow(c, e);
    const double s_power = std::pow(s, e);
    const double sum = c_power + s_power;
    const double r = std::pow(sum, -1.0 / e);
    const double c_lower = c > 0.0 ? c_power / c : std::pow(c, e - 1.0);
    const double s_lower = s > 0.0 ? s_power / s : std::pow(s, e - 1.0);
    const double r_slope = r / sum * (c_lower * s - s_lower * c);
    return std::hypot(a * (r_slope * c - r * s), b * (r_slope * s + r * c));
}

/// The table maps the arc length of a quarter of the curve to its angle. The curve is symmetric in
/// both axes: each quarter is the reverse of the one before.
expr::Table angle_by_quarters(double a, double b, double gamma, const EndGrading& grading) {
    const auto speeds = [=](std::span<const double> angles) {
        std::vector<double> made(angles.size());
        std::transform(angles.begin(), angles.end(), made.begin(),
                       [=](double u) { return superellipse_speed(a, b, gamma, u); });
        return made;
    };
    const Knots quarter = parameter_by_length(speeds, quarter_turn, grading, cells_a_quarter);
    std::vector<double> angles(4 * cells_a_quarter + 1);
    std::vector<double> slopes(4 * cells_a_quarter + 1);
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const std::size_t turn = i / cells_a_quarter;
        const std::size_t within = i % cells_a_quarter;
        const bool backwards = turn % 2 == 1;
        const std::size_t knot = backwards ? cells_a_quarter - within : within;
        angles[i] = backwards ? quarter_turn * static_cast<double>(turn + 1) - quarter.values[knot]
                              : quarter_turn * static_cast<double>(turn) + quarter.values[knot];
        slopes[i] = quarter.slopes[knot];
    }
    return expr::hermite_table(0.0, 4.0, angles, slopes);
}

/// 2 pi of u is the whole length. The angle comes from a table; points, tangent directions and
/// thereby normals are those of the exact curve. For gamma in [0.05, 2] and axes in proportions of
/// up to 10 the length up to any u is off by less than 1e-7 of the whole.
class ArcLengthSuperellipse final : public Superconic {
public:
    ArcLengthSuperellipse(double a, double b, double gamma)
        : Superconic(a, b, gamma),
          grading_(gamma > 1.0 ? crowding_for_pointed : 0.0),
          angle_by_quarters_(
              std::make_shared<const expr::Table>(angle_by_quarters(a, b, gamma, grading_))) {}

private:
    // For 1 < gamma < 2 the curvature is infinite on the axes: a millionth of the quarter is then
    // still more than a cell.
    static constexpr double crowding_for_pointed = 1.0 - 2e-6;

    PlanePoint unit_curve(Expr u, Expr gamma, Emitter& emit) const override {
        // From -180deg on, so that -90deg and 90deg are angles whose cosine is not negative: there
        // a spherical product has its poles, beyond which normals point inwards.
        const Expr quarters = mod(u / quarter_turn + 2.0, emit(4.0));
        const Expr angle =
            emit.graph().lookup(angle_by_quarters_, graded(quarters)) - std::numbers::pi;
        return superellipse_at_angle(angle, gamma);
    }
    Expr graded(Expr quarters) const {
        const double k = grading_.crowding();
        if (k == 0.0) {
            return quarters;
        }
        const Expr quarter = floor(quarters);
        return quarter +
               0.5 * (1.0 + atanh(k * (2.0 * (quarters - quarter) - 1.0)) / grading_.reach());
    }

    EndGrading grading_;
    std::shared_ptr<const expr::Table> angle_by_quarters_;
};

class TrigonometricSuperhyperbola final : public Superconic {
    using Superconic::Superconic;
    PlanePoint unit_curve(Expr u, Expr gamma, Emitter& emit) const override {
        emit.require(0.0 < cos(u));
        return {signed_power(1.0 / cos(u), gamma), signed_power(tan(u), gamma)};
    }
};

class HyperbolicSuperhyperbola final : public Superconic {
    using Superconic::Superconic;
    PlanePoint unit_curve(Expr u, Expr gamma, Emitter&) const override {
        return {pow(cosh(u), gamma), signed_power(sinh(u), gamma)};
    }
};

class CartesianSuperhyperbola final : public Superconic {
    using Superconic::Superconic;
    PlanePoint unit_curve(Expr u, Expr gamma, Emitter&) const override {
        const Expr e = 2.0 / gamma;
        return {pow(1.0 + pow(abs(u), e), 1.0 / e), u};
    }
};

class AngleCentreSuperhyperbola final : public Superconic {
    using Superconic::Superconic;
    PlanePoint unit_curve(Expr u, Expr gamma, Emitter& emit) const override {
        const Expr e = 2.0 / gamma;
        const Expr difference = pow(abs(cos(u)), e) - pow(abs(sin(u)), e);
        emit.require(0.0 < difference && 0.0 < cos(u));
        const Expr r = pow(difference, -1.0 / e);
        return {r * cos(u), r * sin(u)};
    }
};

template <class Concrete>
Result<ObjectGeneratorPointer> made_curve(Scalar a, Scalar b, Scalar gamma) {
    return {std::make_shared<const Concrete>(std::move(a), std::move(b), std::move(gamma))};
}

Result<ObjectGeneratorPointer> arc_length_superellipse(const Scalar& a, const Scalar& b,
                                                       const Scalar& gamma) {
    const auto constant_a = a.constant();
    const auto constant_b = b.constant();
    const auto constant_gamma = gamma.constant();
    if (!constant_a || !constant_b || !constant_gamma) {
        return error("a superellipse by arc_length cannot change with time", {},
                     "use constants for a, b and gamma, or by = angle_centre");
    }
    constexpr double max_gamma = 2.0;
    if (*constant_gamma > max_gamma) {
        return error(fmt::format("a superellipse by arc_length cannot have gamma = {}, which is "
                                 "above {}",
                                 *constant_gamma, max_gamma),
                     {}, "use by = angle_centre or trigonometric");
    }
    return {
        std::make_shared<const ArcLengthSuperellipse>(*constant_a, *constant_b, *constant_gamma)};
}

}  // namespace

Result<ObjectGeneratorPointer> superellipse(Scalar a, Scalar b, Scalar gamma, std::string_view by) {
    if (by == "angle_centre") {
        return made_curve<AngleCentreSuperellipse>(std::move(a), std::move(b), std::move(gamma));
    }
    if (by == "trigonometric") {
        return made_curve<TrigonometricSuperellipse>(std::move(a), std::move(b), std::move(gamma));
    }
    return arc_length_superellipse(a, b, gamma);
}

Result<ObjectGeneratorPointer> superhyperbola(Scalar a, Scalar b, Scalar gamma,
                                              std::string_view by) {
    if (by == "cartesian") {
        return made_curve<CartesianSuperhyperbola>(std::move(a), std::move(b), std::move(gamma));
    }
    if (by == "hyperbolic") {
        return made_curve<HyperbolicSuperhyperbola>(std::move(a), std::move(b), std::move(gamma));
    }
    if (by == "trigonometric") {
        return made_curve<TrigonometricSuperhyperbola>(std::move(a), std::move(b),
                                                       std::move(gamma));
    }
    return made_curve<AngleCentreSuperhyperbola>(std::move(a), std::move(b), std::move(gamma));
}

// Below the minimum gamma, the corners are sharper than the arc-length table resolves; above the
// maximum, the points reach the centre.
StageParameter gamma_parameter(std::string_view name, std::string_view meaning) {
    return number_parameter(name, 1.0, meaning, {.minimum = 0.05, .maximum = 20.0});
}

std::vector<StageEntry> superconics() {
    return {
        {.name = "superellipse",
         .meaning = "|x/a|^e + |y/b|^e = 1 with e = 2/gamma, as a curve in u",
         .formula = R"(
angle_centre    p = r (a cos u, b sin u),   r = (|cos u|^e + |sin u|^e)^(−1/e)
trigonometric   p = (a cos^[gamma] u, b sin^[gamma] u)
arc_length      the same curve at the length u/360° of the whole
e = 2/gamma,   x^[g] = sign(x) |x|^g
)",
         .parameters = {positive_parameter("a", 1.0, "half axis along x"),
                        positive_parameter("b", 1.0, "half axis along y"),
                        gamma_parameter(
                            "gamma", "superconic parameter: 1 is the conic, less is more square"),
                        choice_parameter(
                            "by", superellipse_parametrisations(),
                            "the parametrisation: u is the polar angle before scaling by a and b, "
                            "the classical parameter (no tangent on the axes unless gamma is 1), "
                            "or proportional to arc length (the whole curve is 360deg; relative "
                            "error below 1e-7 for a/b from 1/10 to 10 and gamma <= 2)")},
         .make =
             [](const Arguments& a) {
                 return as_stage(
                     superellipse(a.number("a"), a.number("b"), a.number("gamma"), a.choice("by")));
             },
         .dimension = 1,
         .example = R"(
// The four sides of a square from its centre, each at a constant scale: the eye follows a rounded
// rectangle, and rays cross a wider one.
camera round_the_block {
    aspect 4
    map    u = 180deg .. -180deg, v = -3 .. 3
    eye    superellipse(6, 3, gamma = 1/4, by = arc_length)
    toward product(superellipse(1, 2/3, gamma = 1/4, by = arc_length), curve(v) = [9, v])
}
)"},
        {.name = "superhyperbola",
         .meaning = "one branch, x > 0, of |x/a|^e - |y/b|^e = 1 with e = 2/gamma, as a curve in u",
         .formula = R"(
cartesian       p = (a (1 + |u|^e)^(1/e), b u)
hyperbolic      p = (a cosh^[gamma] u, b sinh^[gamma] u)
trigonometric   p = (a (1/cos u)^[gamma], b tan^[gamma] u),   |u| < 90°
angle_centre    p = r (a cos u, b sin u),   r = (|cos u|^e − |sin u|^e)^(−1/e),
                |u| < 45°
e = 2/gamma,   x^[g] = sign(x) |x|^g
)",
         .parameters =
             {positive_parameter("a", 1.0, "half axis along x"),
              positive_parameter("b", 1.0, "half axis along y"),
              gamma_parameter("gamma", "superconic parameter: 1 is the conic, less is more square"),
              choice_parameter(
                  "by", superhyperbola_parametrisations(),
                  "the parametrisation: u is y/b, the hyperbolic parameter, the classical angle "
                  "(below 90deg; like the previous one without a tangent at 0 unless gamma is 1), "
                  "or the polar angle before scaling by a and b (below 45deg)")},
         .make =
             [](const Arguments& a) {
                 return as_stage(superhyperbola(a.number("a"), a.number("b"), a.number("gamma"),
                                                a.choice("by")));
             },
         .dimension = 1,
         .example = R"(
// Two walls that meet in a corner, both seen at right angles, with a narrow bend between them. The
// rays pass from one superhyperbola to another.
camera corner(gamma = 1/2) {
    map    u = -2 .. 2, v = -1 .. 1
    eye    superhyperbola(2, 2, gamma)
    toward product(superhyperbola(1, 3, gamma), curve(v) = [1, v])
    move   rotate(z, 180deg)
}
)"},
    };
}

}  // namespace balcony::camera
