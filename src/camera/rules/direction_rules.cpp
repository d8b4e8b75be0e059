// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// getDirVec: the direction of a ray along the normal of the eye object, absolute (from the
// direction object alone) or relative (from the eye point to the direction point).

#include "camera/families.hpp"

namespace balcony::camera {

namespace {

/// One object gives origins and directions: the normal is the cross product of its tangents.
class NormalRule final : public DirectionRule {
public:
    explicit NormalRule(bool back) : back_(back) {}
    int least_eye_dimension() const override { return 2; }
    ObjectVector direction(const PathPoint& eye, const PathPoint*, Emitter&) const override {
        const ObjectVector normal = eye.normal;
        return back_ ? -normal : normal;
    }

private:
    bool back_;
};

/// The direction object alone: its points as seen from its own origin.
class AbsoluteRule final : public DirectionRule {
public:
    bool needs_direction_object() const override { return true; }
    ObjectVector direction(const PathPoint&, const PathPoint* toward, Emitter&) const override {
        return toward->point - toward->center;
    }
};

/// From the eye point to the direction point.
class RelativeRule final : public DirectionRule {
public:
    bool needs_direction_object() const override { return true; }
    ObjectVector direction(const PathPoint& eye, const PathPoint* toward, Emitter&) const override {
        return toward->point - eye.point;
    }
};

}  // namespace

std::vector<StageEntry> direction_rules() {
    using enum ParameterType;
    const StageKind kind = StageKind::direction_rule;
    return {
        {kind,
         "normal",
         "along the normals of the eye object",
         {{.name = "side",
           .type = choice,
           .choices = {"front", "back"},
           .meaning = "front: the cross product of the tangents along u and v; back: against it"}},
         [](const Arguments& a) { return made<NormalRule>(a.choice("side") == "back"); }},
        {kind,
         "absolute",
         "the direction object alone, as seen from its own origin",
         {},
         [](const Arguments&) { return made<AbsoluteRule>(); }},
        {kind,
         "relative",
         "from the eye point to the point of the direction object",
         {},
         [](const Arguments&) { return made<RelativeRule>(); }},
    };
}

}  // namespace balcony::camera
