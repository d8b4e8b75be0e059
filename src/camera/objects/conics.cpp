// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object generators, PCS → OCS: ellipse, hyperbola and parabola as curves in the plane z = 0, by
// the parameters of the superconics and by angles; and the superparabola.

#include "camera/catalogue/families.hpp"
#include "camera/objects/superconics.hpp"

namespace balcony::camera {

namespace {

struct PlanePoint {
    Expr x, y;
};

/// A curve in the plane z = 0 with two measures a and b.
class PlaneCurve : public ObjectGenerator {
public:
    PlaneCurve(Scalar a, Scalar b) : a_(std::move(a)), b_(std::move(b)) {}
    int dimension() const final { return 1; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const final {
        const PlanePoint point = curve(p.u, emit(a_), emit(b_), emit);
        return {point.x, point.y, emit(0.0)};
    }

private:
    virtual PlanePoint curve(Expr u, Expr a, Expr b, Emitter& emit) const = 0;

    Scalar a_, b_;
};

/// By the polar angle at the centre.
class PolarEllipse final : public PlaneCurve {
    using PlaneCurve::PlaneCurve;
    PlanePoint curve(Expr u, Expr a, Expr b, Emitter&) const override {
        const Expr across = b * cos(u);
        const Expr up = a * sin(u);
        const Expr r = a * b / sqrt(across * across + up * up);
        return {r * cos(u), r * sin(u)};
    }
};

/// By the polar angle at the focus (c, 0), the true anomaly of orbits.
class FocalEllipse final : public PlaneCurve {
    using PlaneCurve::PlaneCurve;
    PlanePoint curve(Expr u, Expr a, Expr b, Emitter& emit) const override {
        emit.require(b <= a);
        const Expr c = sqrt(a * a - b * b);
        const Expr r = b * b / (a + c * cos(u));
        return {c + r * cos(u), r * sin(u)};
    }
};

/// By the polar angle at the centre, between the asymptotes.
class PolarHyperbola final : public PlaneCurve {
    using PlaneCurve::PlaneCurve;
    PlanePoint curve(Expr u, Expr a, Expr b, Emitter& emit) const override {
        const Expr across = b * cos(u);
        const Expr up = a * sin(u);
        emit.require(abs(up) < across);
        const Expr r = a * b / sqrt(across * across - up * up);
        return {r * cos(u), r * sin(u)};
    }
};

/// By the angle at the focus (c, 0) from the direction to the vertex.
class FocalHyperbola final : public PlaneCurve {
    using PlaneCurve::PlaneCurve;
    PlanePoint curve(Expr u, Expr a, Expr b, Emitter& emit) const override {
        const Expr c = sqrt(a * a + b * b);
        const Expr denominator = a + c * cos(u);
        emit.require(0.0 < denominator);
        const Expr r = b * b / denominator;
        return {c - r * cos(u), r * sin(u)};
    }
};

/// y^2 = 4 f x by u = y.
class CartesianParabola final : public PlaneCurve {
public:
    explicit CartesianParabola(Scalar focus) : PlaneCurve(std::move(focus), 0.0) {}

private:
    PlanePoint curve(Expr u, Expr focus, Expr, Emitter&) const override {
        return {0.25 * (u * u) / focus, u};
    }
};

/// By the angle at the focus (f, 0) from the direction to the vertex.
class FocalParabola final : public PlaneCurve {
public:
    explicit FocalParabola(Scalar focus) : PlaneCurve(std::move(focus), 0.0) {}

private:
    PlanePoint curve(Expr u, Expr focus, Expr, Emitter& emit) const override {
        emit.require(0.0 < cos(0.5 * u));
        const Expr slope = tan(0.5 * u);
        return {focus * slope * slope, 2.0 * focus * slope};
    }
};

/// x/a = |y/b|^(2/gamma), by u = y/b or by the signed root u of x/a, in which y is a signed power.
class Superparabola final : public ObjectGenerator {
public:
    enum class Parameter : std::uint8_t { height, root };
    Superparabola(Scalar a, Scalar b, Scalar gamma, Parameter parameter)
        : a_(std::move(a)), b_(std::move(b)), gamma_(std::move(gamma)), parameter_(parameter) {}
    int dimension() const override { return 1; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        const Expr gamma = emit(gamma_);
        const bool by_height = parameter_ == Parameter::height;
        const Expr x = by_height ? pow(abs(p.u), 2.0 / gamma) : p.u * p.u;
        const Expr y = by_height ? p.u : signed_power(p.u, gamma);
        return {emit(a_) * x, emit(b_) * y, emit(0.0)};
    }

private:
    Scalar a_, b_, gamma_;
    Parameter parameter_;
};

StageResult make_ellipse(const Arguments& arguments) {
    const Scalar a = arguments.number("a");
    const Scalar b = arguments.number("b");
    const std::string& by = arguments.choice("by");
    if (by == "polar") {
        return made<PolarEllipse>(a, b);
    }
    if (by != "focal") {
        return as_stage(superellipse(a, b, 1.0, by));
    }
    if (a.constant() && b.constant() && *a.constant() < *b.constant()) {
        return error("an ellipse by its focal angle needs a >= b", {},
                     "use a for the larger half axis, and rotate it with: move rotate(z, 90deg)");
    }
    return made<FocalEllipse>(a, b);
}

StageResult make_hyperbola(const Arguments& arguments) {
    const Scalar a = arguments.number("a");
    const Scalar b = arguments.number("b");
    const std::string& by = arguments.choice("by");
    if (by == "polar") {
        return made<PolarHyperbola>(a, b);
    }
    if (by == "focal") {
        return made<FocalHyperbola>(a, b);
    }
    return as_stage(superhyperbola(a, b, 1.0, by));
}

StageParameter parametrisation(std::vector<std::string_view> choices, std::string_view meaning) {
    return choice_parameter("by", std::move(choices), meaning);
}

std::vector<StageParameter> half_axes(StageParameter by) {
    return {positive_parameter("a", 1.0, "half axis along x"),
            positive_parameter("b", 1.0, "half axis along y"), std::move(by)};
}

}  // namespace

std::vector<StageEntry> conics() {
    return {
        {.name = "ellipse",
         .meaning = "x^2/a^2 + y^2/b^2 = 1, as a curve in u",
         .formula = R"(
trigonometric   p = (a cos u, b sin u)
arc_length      the same point at the length of the curve u/360° of the whole
polar           p = r (cos u, sin u),   r = a b/√(b² cos² u + a² sin² u)
focal           p = (c + r cos u, r sin u)
                r = b²/(a + c cos u),   c = √(a² − b²)
                u counter-clockwise from the near vertex (a, 0)
)",
         .parameters = half_axes(
             parametrisation({"trigonometric", "arc_length", "polar", "focal"},
                             "the parametrisation: u is the classical parameter, the eccentric "
                             "anomaly; proportional to arc length (the whole curve is 360deg); the "
                             "polar angle at the centre; or the polar angle at the focus with x > "
                             "0, the true anomaly (requires a >= b)")),
         .make = make_ellipse,
         .dimension = 1,
         .example = R"(
// Once around an oval table: all people at the same scale, because the eye moves by arc length.
camera oval_table(a = 3, b = 1) {
    aspect 4
    map    u = 180deg .. -180deg, v = -0.6 .. 0.6
    eye    ellipse(a, b, by = arc_length)
    toward product(ellipse(1, (b + 1)/(a + 1), by = arc_length), curve(v) = [a + 1, v])
}
)"},
        {.name = "hyperbola",
         .meaning = "the branch x > 0 of x^2/a^2 - y^2/b^2 = 1, as a curve in u",
         .formula = R"(
hyperbolic      p = (a cosh u, b sinh u)
cartesian       p = (a √(1 + u²), b u)
trigonometric   p = (a/cos u, b tan u),   |u| < 90°
polar           p = r (cos u, sin u),   r = a b/√(b² cos² u − a² sin² u)
focal           p = (c − r cos u, r sin u)
                r = b²/(a + c cos u) > 0,   c = √(a² + b²)
                u clockwise from the direction of the vertex (a, 0), so that y
                has the sign of u
)",
         .parameters = half_axes(parametrisation(
             {"hyperbolic", "cartesian", "trigonometric", "polar", "focal"},
             "the parametrisation: u is the hyperbolic parameter; y/b; the classical angle (below "
             "90deg); the polar angle at the centre, between the asymptotes; or the angle at the "
             "focus, 0 towards the vertex")),
         .make = make_hyperbola,
         .dimension = 1,
         .example = R"(
// The hyperbolic cylinder: sees both walls of a corner at right angles and bends in between.
camera both_walls {
    map  u = -1.5 .. 1.5, v = -2 .. 2
    eye  product(hyperbola(3, 3), curve(v) = [1, v])
    look normal(side = back)
    move rotate(z, 180deg)
}
)"},
        {.name = "parabola",
         .meaning = "y^2 = 4 focus x, as a curve in u",
         .formula = R"(
cartesian   p = (u²/(4 focus), u)
focal       p = (focus − r cos u, r sin u),   r = 2 focus/(1 + cos u)
              = (focus tan²(u/2), 2 focus tan(u/2)),   |u| < 180°
            u clockwise from the direction of the vertex (0, 0), so that y has
            the sign of u
)",
         .parameters = {positive_parameter(
                            "focus", 1.0,
                            "distance from the vertex, at the origin, to the focus at x > 0"),
                        parametrisation(
                            {"cartesian", "focal"},
                            "the parametrisation: u is y, or the angle at the focus, 0 towards the "
                            "vertex, below 180deg")},
         .make =
             [](const Arguments& a) {
                 return a.choice("by") == "cartesian" ? made<CartesianParabola>(a.number("focus"))
                                                      : made<FocalParabola>(a.number("focus"));
             },
         .dimension = 1,
         .example = R"(
// From a comet's orbit, always towards the sun in its focus, and slightly above and below it.
camera comet(focus = 2) {
    map    u = 120deg .. -120deg, v = -1 .. 1
    eye    parabola(focus, by = focal)
    toward surface(u, v) = [focus, 0, v]
}
)"},
        {.name = "superparabola",
         .meaning = "x/a = |y/b|^e with e = 2/gamma, as a curve in u",
         .formula = R"(
cartesian   p = (a |u|^e, b u)      e = 2/gamma
root        p = (a u², b sign(u) |u|^gamma)
)",
         .parameters =
             {positive_parameter("a", 1.0, "x where y is b"),
              positive_parameter("b", 1.0, "y where x is a"),
              gamma_parameter(
                  "gamma",
                  "superconic parameter: 1 is the parabola, less is flatter at the vertex"),
              parametrisation({"cartesian", "root"},
                              "the parametrisation: u is y/b, or the root of x/a with y's sign")},
         .make =
             [](const Arguments& a) {
                 using enum Superparabola::Parameter;
                 return made<Superparabola>(a.number("a"), a.number("b"), a.number("gamma"),
                                            a.choice("by") == "cartesian" ? height : root);
             },
         .dimension = 1,
         .example = R"(
// A shop window that is flat in the middle and curves at both sides.
camera bow_window(gamma = 1/2) {
    map  u = -1.2 .. 1.2, v = -1 .. 1
    eye  product(superparabola(1, 2, gamma), curve(v) = [1, v])
    look normal(side = back)
    move rotate(z, 180deg)
}
)"},
    };
}

}  // namespace balcony::camera
