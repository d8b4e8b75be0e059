// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <numbers>

#include "camera/arc_length.hpp"
#include "camera/families.hpp"

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

// The distance from the centre, at polar angle u, of |x|^e + |y|^e = 1.
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

constexpr double full_turn = 2.0 * std::numbers::pi;
constexpr std::size_t arc_length_cells = 4096;

/// |d/du| of the angle-centre superellipse (a r cos u, b r sin u).
double superellipse_speed(double a, double b, double gamma, double u) {
    const double e = 2.0 / gamma;
    // The curve is symmetric in both axes: the first quadrant serves for all.
    const double c = std::fabs(std::cos(u));
    const double s = std::fabs(std::sin(u));
    const double sum = std::pow(c, e) + std::pow(s, e);
    const double r = std::pow(sum, -1.0 / e);
    const double r_slope = r / sum * (std::pow(c, e - 1.0) * s - std::pow(s, e - 1.0) * c);
    return std::hypot(a * (r_slope * c - r * s), b * (r_slope * s + r * c));
}

/// 2 pi of u is the whole length. The angle comes from a table; tangent directions and thereby
/// normals are those of the exact curve.
class ArcLengthSuperellipse final : public Superconic {
public:
    ArcLengthSuperellipse(double a, double b, double gamma)
        : Superconic(a, b, gamma),
          angle_by_length_(std::make_shared<const expr::Table>(parameter_by_length(
              [=](double u) { return superellipse_speed(a, b, gamma, u); }, full_turn, full_turn,
              arc_length_cells))) {}

private:
    PlanePoint unit_curve(Expr u, Expr gamma, Emitter& emit) const override {
        const Expr angle = emit.graph().lookup(angle_by_length_, mod(u, emit(full_turn)));
        return superellipse_at_angle(angle, gamma);
    }

    std::shared_ptr<const expr::Table> angle_by_length_;
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
Result<std::shared_ptr<const Stage>> make_superconic(const Arguments& a) {
    return made<Concrete>(a.number("a"), a.number("b"), a.number("gamma"));
}

Result<std::shared_ptr<const Stage>> make_superellipse(const Arguments& a) {
    if (a.choice("by") == "angle_centre") {
        return make_superconic<AngleCentreSuperellipse>(a);
    }
    if (a.choice("by") == "trigonometric") {
        return make_superconic<TrigonometricSuperellipse>(a);
    }
    const auto constant_a = a.number("a").constant();
    const auto constant_b = a.number("b").constant();
    const auto gamma = a.number("gamma").constant();
    if (!constant_a || !constant_b || !gamma) {
        return error("a superellipse by arc_length cannot change with time", {},
                     "use constants for a, b and gamma, or by = angle_centre");
    }
    return made<ArcLengthSuperellipse>(*constant_a, *constant_b, *gamma);
}

Result<std::shared_ptr<const Stage>> make_superhyperbola(const Arguments& a) {
    if (a.choice("by") == "cartesian") {
        return make_superconic<CartesianSuperhyperbola>(a);
    }
    if (a.choice("by") == "hyperbolic") {
        return make_superconic<HyperbolicSuperhyperbola>(a);
    }
    if (a.choice("by") == "trigonometric") {
        return make_superconic<TrigonometricSuperhyperbola>(a);
    }
    return make_superconic<AngleCentreSuperhyperbola>(a);
}

// Below the least gamma the corners are sharper than the arc-length table resolves.
StageParameter gamma_parameter() {
    return {.name = "gamma", .default_value = {1.0}, .least = 0.05, .most = 20.0,
            .meaning = "superconic parameter: 1 is the conic, less is more square"};
}

StageParameter half_axis(std::string_view name, std::string_view meaning) {
    return {.name = name, .default_value = {1.0}, .least = 0.0, .above_least = true,
            .meaning = meaning};
}

}  // namespace

std::vector<StageEntry> superconics() {
    using enum ParameterType;
    const StageKind kind = StageKind::object_generator;
    return {
        {kind, "superellipse", "|x/a|^e + |y/b|^e = 1 with e = 2/gamma, as a curve in u",
         {half_axis("a", "half axis along x"), half_axis("b", "half axis along y"), gamma_parameter(),
          {.name = "by", .type = choice,
           .choices = {"angle_centre", "trigonometric", "arc_length"},
           .meaning = "the parametrisation: u is the polar angle before a and b are applied, the "
                      "classical parameter, or proportional to the length (the whole is 360deg)"}},
         make_superellipse,
         {}, 1},
        {kind, "superhyperbola",
         "one branch, x > 0, of |x/a|^e - |y/b|^e = 1 with e = 2/gamma, as a curve in u",
         {half_axis("a", "half axis along x"), half_axis("b", "half axis along y"), gamma_parameter(),
          {.name = "by", .type = choice,
           .choices = {"cartesian", "hyperbolic", "trigonometric", "angle_centre"},
           .meaning = "the parametrisation: u is y/b, the hyperbolic parameter, the classical angle "
                      "(below 90deg), or the polar angle before a and b are applied (below 45deg)"}},
         make_superhyperbola,
         {}, 1},
    };
}

}  // namespace balcony::camera
