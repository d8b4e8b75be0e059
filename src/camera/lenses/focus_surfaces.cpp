// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Where the picture of a lens is sharp.

#include <algorithm>
#include <cmath>

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

namespace {

/// The same distance along every ray: a sphere around a point, a parallel surface of the eye object
/// of a camera of normals.
class DistanceFocus final : public FocusSurface {
public:
    explicit DistanceFocus(Scalar distance) : distance_(std::move(distance)) {}
    Expr vergence(const CentralRay&, Emitter& emit) const override { return 1.0 / emit(distance_); }

private:
    Scalar distance_;
};

/// Where the camera's rays meet an object. Who renders knows the scene.
class ObjectFocus final : public FocusSurface {
public:
    explicit ObjectFocus(std::string object) : object_(std::move(object)) {}
    Expr vergence(const CentralRay&, Emitter& emit) const override {
        return 1.0 / emit.graph().input(distance_input(object_));
    }
    std::optional<std::string> object() const override { return object_; }

private:
    std::string object_;
};

/// As far away as a point is from the origin of each ray.
class PointFocus final : public FocusSurface {
public:
    explicit PointFocus(Triple point) : point_(std::move(point)) {}
    Expr vergence(const CentralRay& ray, Emitter& emit) const override {
        const ObjectVector to_point = point_of(point_, emit) - ray.origin;
        return 1.0 / sqrt(dot(to_point, to_point));
    }

private:
    Triple point_;
};

/// The ray in the middle of the picture; reports that there is none.
CentralRay middle_ray(const CentralRay& ray, Emitter& emit) {
    CentralRay middle = middle_of(ray);
    const ObjectPoint& o = middle.origin;
    const ObjectVector& d = middle.direction;
    const std::vector<double> known =
        emit.trial(std::array{o.x, o.y, o.z, d.x, d.y, d.z}, 0.0, 0.0);
    if (!std::all_of(known.begin(), known.end(),
                     [](double value) { return std::isfinite(value); })) {
        emit.report(error(
            "this focus follows the ray in the middle of the picture, where there is "
            "none",
            {}, "write plane(through, normal) with both a point and a normal, or a distance"));
    }
    return middle;
}

/// A plane across the ray in the middle of the picture: the focus of a photographer's lens.
class FlatFocus final : public FocusSurface {
public:
    explicit FlatFocus(Scalar distance) : distance_(std::move(distance)) {}
    Expr vergence(const CentralRay& ray, Emitter& emit) const override {
        const CentralRay middle = middle_ray(ray, emit);
        const ObjectVector& normal = middle.direction;
        return dot(normal, ray.direction) /
               (emit(distance_) - dot(normal, ray.origin - middle.origin));
    }

private:
    Scalar distance_;
};

/// Any plane. One that is not across the middle ray is what a tilted lens focuses on (Scheimpflug).
class PlaneFocus final : public FocusSurface {
public:
    PlaneFocus(Triple through, std::optional<Triple> normal)
        : through_(std::move(through)), normal_(std::move(normal)) {}
    Expr vergence(const CentralRay& ray, Emitter& emit) const override {
        const ObjectVector normal =
            normal_ ? vector_of(*normal_, emit) : middle_ray(ray, emit).direction;
        return dot(normal, ray.direction) / dot(normal, point_of(through_, emit) - ray.origin);
    }

private:
    Triple through_;
    std::optional<Triple> normal_;
};

/// A distance along the ray by a formula of the parameters.
class ParameterFocus final : public FocusSurface {
public:
    explicit ParameterFocus(Formula distance) : distance_(std::move(distance)) {}
    Expr vergence(const CentralRay& ray, Emitter& emit) const override {
        const std::array uv{ray.parameters.u, ray.parameters.v};
        return 1.0 / distance_.emit(emit.graph(), uv).front();
    }

private:
    Formula distance_;
};

/// A distance along the ray by a formula of its direction.
class DirectionFocus final : public FocusSurface {
public:
    explicit DirectionFocus(Formula distance) : distance_(std::move(distance)) {}
    Expr vergence(const CentralRay& ray, Emitter& emit) const override {
        const std::array xyz{ray.direction.x, ray.direction.y, ray.direction.z};
        return 1.0 / distance_.emit(emit.graph(), xyz).front();
    }

private:
    Formula distance_;
};

StageParameter distance_parameter(std::string_view meaning) {
    return {.name = "distance",
            .type = NumberParameter{.range = {.minimum = 0.0, .excludes_minimum = true}},
            .meaning = meaning};
}

StageParameter coordinate(std::string_view name, std::string_view meaning) {
    return {.name = name, .type = NumberParameter{}, .meaning = meaning};
}

StageResult make_plane_focus(const Arguments& a) {
    std::optional<Triple> normal;
    if (a.has("normal")) {
        normal = a.triple("normal");
        if (std::all_of(normal->begin(), normal->end(),
                        [](const Scalar& one) { return one.constant() == 0.0; })) {
            return error("the normal of a plane of focus must not be (0, 0, 0)", {},
                         "write x, y, z, or a vector such as (1, 0, -1)");
        }
    }
    return made<PlaneFocus>(a.triple("through"), normal);
}

std::vector<StageEntry> measured_focus() {
    return {
        {.name = "distance",
         .meaning = "the same distance along every ray; a plain number is short for it",
         .formula = R"(
s = distance
)",
         .parameters = {distance_parameter("from the origin of each ray, along the ray")},
         .make = maker<DistanceFocus>("distance"),
         .example = R"(
// A room of 100 by 50 units: all around, what is 30 units away is sharp.
camera blurred_panorama {
    aspect 2
    map    u = 180deg .. -180deg, v = -90deg .. 90deg
    eye    point
    toward sphere(1)
    lens(radius = 1.5, focus = distance(30))
}
)"},
        {.name = "flat",
         .meaning = "a plane across the ray in the middle of the picture, as photographers focus",
         .formula = R"(
s = (distance − m·(o − o₀))/(m·d)      o, d   the ray;   o₀, m   the ray in the
middle of the picture;   infinity where this is not positive
)",
         .parameters = {distance_parameter("from the origin of the ray in the middle, along it")},
         .make = maker<FlatFocus>("distance"),
         .example = R"(
// Perspective with a sharp plane 35 units in front of the camera, as a photographer focuses.
camera along_the_wall {
    map    u = 0.8 .. -0.8, v = square
    eye    point
    toward plane((1, 0, 0))
    move   rotate(z, 40deg)
    lens(radius = 2, focus = flat(35))
}
)"},
        {.name = "at",
         .meaning = "as far away as a point of the scene is from the origin of each ray",
         .formula = R"(
s = |p − o|      p = (x, y, z),   o   the origin of the ray
)",
         .parameters = {coordinate("x", "of the point in the camera's axes; moves do not apply"),
                        coordinate("y", "of the point"), coordinate("z", "of the point")},
         .make = [](const Arguments& a) { return made<PointFocus>(xyz_of(a)); },
         .example = R"(
// The focus stays on one place, the middle of a wall, while the camera passes by.
camera passing_by {
    map    u = 0.8 .. -0.8, v = square
    eye    point
    toward plane((1, 0, 0))
    move   rotate(z, 60deg), translate(-20 + 4*t, 0, 0)
    lens(radius = 2, focus = at(0, 25, 0))
}
)"},
        {.name = "plane",
         .meaning = "a plane of the scene, across the ray in the middle of the picture or tilted",
         .formula = R"(
s = n·(p − o)/(n·d)      p = through,   n = normal;   o, d   the ray
infinity where this is not positive
)",
         .parameters = {{.name = "through",
                         .type = TripleParameter{},
                         .meaning =
                             "a point of the plane in the camera's axes; moves do not apply"},
                        {.name = "normal",
                         .type = TripleParameter{.names_axes = true},
                         .optional = true,
                         .meaning =
                             "across the plane; without it, the direction of the ray in the middle "
                             "of the picture"}},
         .make = make_plane_focus,
         .example = R"(
// A tilted lens: the floor is sharp from near to far, and what is above it is not.
camera tilted {
    map    u = 0.8 .. -0.8, v = square
    eye    point
    toward plane((1, 0, -0.3))
    lens(radius = 2, focus = plane((0, 0, -30), normal = z))
}
)"},
    };
}

std::vector<StageEntry> other_focus() {
    return {
        {.name = "on",
         .meaning = "the distance along the rays of an object of the scene",
         .formula = R"(
s   the median length of the rays of the picture that meet the object first;
    if none does, the length up to its middle of the ray that passes nearest
)",
         .parameters = {{.name = "object",
                         .type = NameParameter{},
                         .meaning = "the name of an object of the scene, as 'balcony info "
                                    "--objects' lists it"}},
         .make = [](const Arguments& a) { return made<ObjectFocus>(a.choice("object")); },
         .example = R"(
// The distance of a picture on the wall is measured when the scene is known.
camera autofocus {
    map    u = 0.8 .. -0.8, v = square
    eye    point
    toward plane((1, 0, 0))
    move   rotate(z, 35deg)
    lens(radius = 2, focus = on("picture 3"))
}
)"},
        {.name = "formula",
         .meaning = "a distance along each ray by its parameters: formula(u, v) = [s]",
         .formula = R"(
s = s(u, v)      u, v   the parameters of the eye object
infinity where this is not positive
)",
         .make = [](const Arguments& a) { return made<ParameterFocus>(a.formula()); },
         .shape = FormulaShape{2, 1, 1},
         .example = R"(
// The focus moves from near on the left to far on the right.
camera swept_focus {
    map    u = 0.8 .. -0.8, v = square
    eye    point
    toward plane((1, 0, 0))
    move   rotate(z, 40deg)
    lens(radius = 2, focus = formula(u, v) = [36 - 20*u])
}
)"},
        {.name = "by_direction",
         .meaning = "a distance along each ray by its direction: by_direction(x, y, z) = [s]",
         .formula = R"(
s = s(x, y, z)      (x, y, z)   the unit direction of the ray
infinity where this is not positive
)",
         .make = [](const Arguments& a) { return made<DirectionFocus>(a.formula()); },
         .shape = FormulaShape{3, 1, 1},
         .example = R"(
// Sharp where a round tower of radius 30 would have its wall, at any height.
camera tower {
    aspect 2
    map    u = 180deg .. -180deg, v = -90deg .. 90deg
    eye    point
    toward sphere(1)
    lens(radius = 1.5, focus = by_direction(x, y, z) = [30/sqrt(x^2 + y^2)])
}
)"},
    };
}

}  // namespace

std::vector<StageEntry> focus_surfaces() {
    std::vector<StageEntry> all = measured_focus();
    for (StageEntry& row : other_focus()) {
        all.push_back(std::move(row));
    }
    return all;
}

}  // namespace balcony::camera
