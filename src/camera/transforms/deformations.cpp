// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object transformers, OCS → OCS: twist, taper and bend after A. H. Barr, "Global and Local
// Deformations of Solid Primitives" (SIGGRAPH 1984). Each works up along an axis between two
// heights; points below the first are fixed, points above the second follow rigidly.

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

namespace {

/// The range of the axis over which a deformation works: heights above `at`.
struct Stretch {
    Triple axis, at;
    Scalar from, to;
};

Expr clamp(Expr value, Expr from, Expr to) { return min(max(value, min(from, to)), max(from, to)); }

/// From 0 at the first height to 1 at the second.
Expr progress(Expr height, const Stretch& along, const Emitter& emit) {
    const Expr from = emit(along.from);
    return clamp((height - from) / (emit(along.to) - from), emit(0.0), emit(1.0));
}

class Twist final : public ObjectTransformer {
public:
    Twist(Stretch along, Scalar angle) : along_(std::move(along)), angle_(std::move(angle)) {}
    ObjectPoint transform(const ObjectPoint& p, Emitter& emit) const override {
        const ObjectVector axis = to_unit_length(vector_of(along_.axis, emit));
        const ObjectVector d = p - point_of(along_.at, emit);
        const Expr height = dot(axis, d);
        const Expr angle = emit(angle_) * progress(height, along_, emit);
        const ObjectVector aside = d + (-height) * axis;
        return p + ((cos(angle) - 1.0) * aside + sin(angle) * cross(axis, aside));
    }

private:
    Stretch along_;
    Scalar angle_;
};

class Taper final : public ObjectTransformer {
public:
    Taper(Stretch along, Scalar factor) : along_(std::move(along)), factor_(std::move(factor)) {}
    ObjectPoint transform(const ObjectPoint& p, Emitter& emit) const override {
        const ObjectVector axis = to_unit_length(vector_of(along_.axis, emit));
        const ObjectVector d = p - point_of(along_.at, emit);
        const Expr height = dot(axis, d);
        const ObjectVector aside = d + (-height) * axis;
        return p + ((emit(factor_) - 1.0) * progress(height, along_, emit)) * aside;
    }

private:
    Stretch along_;
    Scalar factor_;
};

/// With k = angle/(to - from), the curvature, s the height clamped to the range and
/// theta = k (s - from), a point at height h and depth n (towards the side that it bends to) goes
/// to
///     h' = from + sin(theta) (1/k - n) + cos(theta) (h - s)
///     n' = 1/k + cos(theta) (n - 1/k) + sin(theta) (h - s).
/// The line through `at` along the axis keeps its length.
class Bend final : public ObjectTransformer {
public:
    Bend(Stretch along, Triple toward, Scalar angle)
        : along_(std::move(along)), toward_(std::move(toward)), angle_(std::move(angle)) {}
    ObjectPoint transform(const ObjectPoint& p, Emitter& emit) const override {
        const ObjectVector axis = to_unit_length(vector_of(along_.axis, emit));
        const ObjectVector given = vector_of(toward_, emit);
        const ObjectVector side = to_unit_length(given + (-dot(axis, given)) * axis);
        const ObjectVector d = p - point_of(along_.at, emit);
        const Expr h = dot(axis, d);
        const Expr n = dot(side, d);
        const Expr from = emit(along_.from);
        const Expr s = clamp(h, from, emit(along_.to));
        // A straight bend uses a negligible curvature, to avoid a division by 0.
        const Expr curvature = emit(angle_) / (emit(along_.to) - from);
        const Expr k = select(abs(curvature) < 1e-12, emit(1e-12), curvature);
        const Expr theta = k * (s - from);
        // (1 - cos(theta))/k, as a product to avoid cancellation.
        const Expr half = sin(0.5 * theta);
        const Expr sag = 2.0 * half * half / k;
        const Expr h_new = from + sin(theta) / k - sin(theta) * n + cos(theta) * (h - s);
        const Expr n_new = sag + cos(theta) * n + sin(theta) * (h - s);
        return p + ((h_new - h) * axis + (n_new - n) * side);
    }

private:
    Stretch along_;
    Triple toward_;
    Scalar angle_;
};

Stretch stretch_of(const Arguments& a) {
    return {a.triple("axis"), a.triple("at"), a.number("from"), a.number("to")};
}

std::optional<ObjectVector> known(const Triple& t, Graph& graph) {
    for (const Scalar& coordinate : t) {
        if (!coordinate.constant()) {
            return std::nullopt;
        }
    }
    return vector_of(t, Emitter(graph));
}

Diagnostics unfit(const Arguments& a) {
    Graph graph;
    const auto axis = known(a.triple("axis"), graph);
    if (axis && dot(*axis, *axis).is_constant(0.0)) {
        return {error("the axis is (0, 0, 0), which is not a direction", {},
                      "write x, y, z or a vector such as (1, 1, 0)")};
    }
    const std::optional<double> from = a.number("from").constant();
    if (from && from == a.number("to").constant()) {
        return {error("from and to are the same height", {},
                      "give two different heights along the axis")};
    }
    return {};
}

/// A Concrete(stretch, amount).
template <class Concrete>
StageResult deformation(const Arguments& a, std::string_view amount) {
    if (Diagnostics diagnostics = unfit(a); !diagnostics.empty()) {
        return diagnostics;
    }
    return made<Concrete>(stretch_of(a), a.number(amount));
}

StageResult bend(const Arguments& a) {
    if (Diagnostics diagnostics = unfit(a); !diagnostics.empty()) {
        return diagnostics;
    }
    Graph graph;
    const auto axis = known(a.triple("axis"), graph);
    const auto toward = known(a.triple("toward"), graph);
    if (axis && toward) {
        const ObjectVector across = cross(*axis, *toward);
        if (dot(across, across).is_constant(0.0)) {
            return error(
                "toward is parallel to the axis", {},
                "give a direction perpendicular to the axis, such as toward = x for axis = z");
        }
    }
    return made<Bend>(stretch_of(a), a.triple("toward"), a.number("angle"));
}

std::vector<StageParameter> deformation_parameters(std::vector<StageParameter> own) {
    own.insert(own.begin(), {.name = "axis",
                             .type = TripleParameter{.names_axes = true},
                             .meaning = "axis of the deformation: x, y, z or a vector"});
    own.push_back(number_parameter("from", -1.0, "the height along the axis where it starts"));
    own.push_back(number_parameter("to", 1.0, "the height along the axis where it ends"));
    own.push_back(triple_parameter("at", {0.0, 0.0, 0.0}, "a point of the axis, at height 0"));
    return own;
}

}  // namespace

std::vector<StageEntry> deformations() {
    return {
        {.name = "twist",
         .meaning = "rotates about an axis, by an angle that increases along it",
         .formula = R"(
p′ = p, rotated about the line at + λ n by τ angle
h = n·d,   d = p − at,   n = axis/|axis|
τ = (h − from)/(to − from), held within 0 and 1
)",
         .parameters = deformation_parameters({{.name = "angle",
                                                .type = NumberParameter{.unit = Unit::angle},
                                                .meaning = "rotation between from and to"}}),
         .make = [](const Arguments& a) { return deformation<Twist>(a, "angle"); },
         .example = R"(camera twist {
    map  u = 2 .. -2, v = square
    eye  plane
    move twist(z, 120deg)
})"},
        {.name = "taper",
         .meaning = "scales perpendicular to an axis, by a factor that changes along it",
         .formula = R"(
p′ = at + h n + (1 + (factor − 1) τ) (d − h n)
h = n·d,   d = p − at,   n = axis/|axis|
τ = (h − from)/(to − from), held within 0 and 1
)",
         .parameters = deformation_parameters(
             {positive_parameter("factor", 0.5, "scale at `to`; at `from` it is 1")}),
         .make = [](const Arguments& a) { return deformation<Taper>(a, "factor"); },
         .example = R"(camera taper {
    map  u = 180deg .. -180deg, v = -1 .. 1
    eye  cylinder(1)
    move taper(z, 0.3)
})"},
        {.name = "bend",
         .meaning = "bends an axis and its surroundings into an arc",
         .formula = R"(
p′ = p + (h′ − h) n + (m′ − m) e
h′ = from + sin θ/k − m sin θ + (h − s) cos θ
m′ = (1 − cos θ)/k + m cos θ + (h − s) sin θ
h = n·d,   m = e·d,   d = p − at,   n = axis/|axis|
e   the unit vector perpendicular to n on the side of toward
s = h, held within from and to;   k = angle/(to − from);   θ = k (s − from)
)",
         .parameters = deformation_parameters(
             {{.name = "angle",
               .type = NumberParameter{.unit = Unit::angle},
               .meaning = "angle of the arc between from and to"},
              {.name = "toward",
               .type =
                   TripleParameter{.default_value = std::array{1.0, 0.0, 0.0}, .names_axes = true},
               .meaning = "the direction to bend to"}}),
         .make = bend,
         .example = R"(camera bent_strip {
    map  u = 2 .. -2, v = square
    eye  plane
    move bend(y, 120deg, toward = -x, from = -1.5, to = 1.5)
})"},
    };
}

}  // namespace balcony::camera
