// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// getDirVec by geometrical optics: a direction is reflected or refracted at the eye object or at
// the direction object.

#include <algorithm>

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

namespace {

/// What happens to a direction at a surface: at the eye object, from which the ray then starts, or
/// at the direction object. The direction is that of another rule, or from the other object.
class OpticalRule : public DirectionRule {
public:
    enum class Surface : std::uint8_t { eye, toward };
    OpticalRule(Surface surface, DirectionRulePointer incident)
        : surface_(surface), incident_(std::move(incident)) {}
    int min_eye_dimension() const final {
        return std::max(surface_ == Surface::eye ? 2 : 0,
                        incident_ ? incident_->min_eye_dimension() : 0);
    }
    bool needs_direction_object() const final {
        return surface_ == Surface::toward || !incident_ || incident_->needs_direction_object();
    }
    int min_direction_dimension() const final {
        return std::max(surface_ == Surface::toward ? 2 : 0,
                        incident_ ? incident_->min_direction_dimension() : 0);
    }
    bool needs_second_derivative() const final {
        return incident_ && incident_->needs_second_derivative();
    }
    ObjectVector direction(const PathPoint& eye, const PathPoint* toward,
                           Emitter& emit) const final {
        const PathPoint& surface = surface_ == Surface::eye ? eye : *toward;
        const ObjectVector incident = incident_ ? incident_->direction(eye, toward, emit)
                                      : surface_ == Surface::eye ? eye.point - toward->point
                                                                 : toward->point - eye.point;
        return leaving(to_unit_length(incident), to_unit_length(surface.normal), emit);
    }

private:
    /// Of two unit vectors.
    virtual ObjectVector leaving(const ObjectVector& incident, const ObjectVector& normal,
                                 Emitter& emit) const = 0;

    Surface surface_;
    DirectionRulePointer incident_;
};

class ReflectRule final : public OpticalRule {
    using OpticalRule::OpticalRule;
    ObjectVector leaving(const ObjectVector& incident, const ObjectVector& normal,
                         Emitter&) const override {
        return incident + (-2.0 * dot(incident, normal)) * normal;
    }
};

/// Snell's law as a vector: Heckbert, "Writing a Ray Tracer", in Glassner (ed.), "An Introduction
/// to Ray Tracing" (1989).
class RefractRule final : public OpticalRule {
public:
    RefractRule(Surface surface, DirectionRulePointer incident, Scalar index)
        : OpticalRule(surface, std::move(incident)), index_(std::move(index)) {}

private:
    ObjectVector leaving(const ObjectVector& incident, const ObjectVector& normal,
                         Emitter& emit) const override {
        const Expr ratio = 1.0 / emit(index_);
        const Expr cosine = dot(incident, normal);
        const Expr squared_cosine_after = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
        // Beyond the critical angle, all light is reflected.
        emit.require(0.0 <= squared_cosine_after);
        const Expr cosine_after = sqrt(max(squared_cosine_after, emit(0.0)));
        return ratio * incident +
               (select(cosine < 0.0, -cosine_after, cosine_after) - ratio * cosine) * normal;
    }

    Scalar index_;
};

OpticalRule::Surface surface_of(const Arguments& a) {
    return a.choice("at") == "eye" ? OpticalRule::Surface::eye : OpticalRule::Surface::toward;
}

DirectionRulePointer incident_of(const Arguments& a) {
    return a.has("incident") ? a.stage<DirectionRule>("incident") : nullptr;
}

StageParameter at_parameter(std::string_view meaning) {
    return choice_parameter("at", {"eye", "toward"}, meaning);
}

StageParameter incident_parameter() {
    return {.name = "incident",
            .type = NestedStageParameter{.kind = StageKind::direction_rule},
            .optional = true,
            .meaning =
                "the rule of the direction that arrives; without it, from the point of the "
                "other object to that of the surface"};
}

}  // namespace

std::vector<StageEntry> optical_rules() {
    return {
        {.name = "reflect",
         .meaning = "a direction reflected at the eye object or the direction object",
         .formula = R"(
d = i − 2 (i·n) n
i   the incident unit direction; without a rule, from the point of the other
    object to that of the surface
n   the unit normal of the surface; its side does not matter
)",
         .parameters = {at_parameter("the mirror: the eye object, where the rays then start, or "
                                     "the direction object"),
                        incident_parameter()},
         .make =
             [](const Arguments& a) { return made<ReflectRule>(surface_of(a), incident_of(a)); },
         .example = R"(
// A mirror ball photographed from afar, as used to record the light of a place: all that is on the
// camera's side of it, and more. Like every mirror, it swaps left and right.
camera light_probe {
    aspect 1
    map    u = 0.65 .. -0.65, v = square
    eye    surface(u, v) = [-sqrt(1 - u^2 - v^2), u, v]
    look   reflect(incident = along(x))
}
)"},
        {.name = "refract",
         .meaning = "a direction refracted at the eye object or the direction object",
         .formula = R"(
d = i/μ + (±√k − (i·n)/μ) n      the sign is that of i·n
k = 1 − (1 − (i·n)²)/μ²,   μ = index,   i, n   as for reflect
Snell's law: sin θ = μ sin θ′ for the angles θ of i and θ′ of d with n
no ray where k < 0 (total internal reflection: sin θ > μ)
)",
         .parameters =
             {{.name = "index",
               .type = NumberParameter{.range = {.minimum = 0.0, .excludes_minimum = true}},
               .meaning = "the refractive index beyond the surface, divided by that before it: "
                          "1.33 from air into water, 1/1.33 out of it"},
              at_parameter("the surface: the eye object, where the rays then start, or the "
                           "direction object"),
              incident_parameter()},
         .make =
             [](const Arguments& a) {
                 return made<RefractRule>(surface_of(a), incident_of(a), a.number("index"));
             },
         .example = R"(
// The world above the water as a diver sees it: all of it within 49 degrees of the zenith.
camera snells_window {
    aspect 1
    map    u = 1.1 .. -1.1, v = square
    eye    plane(along_u = (0, 1, 0), along_v = (-1, 0, 0))
    toward point(0, 0, -1)
    look   refract(1/1.33)
}
)"},
    };
}

}  // namespace balcony::camera
