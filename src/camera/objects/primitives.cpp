// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object generators, PCS → OCS: points, lines and the surfaces of elementary geometry.

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"
#include "camera/objects/ray_targets.hpp"

namespace balcony::camera {

namespace {

class Point final : public ObjectGenerator {
public:
    explicit Point(Triple at) : at_(std::move(at)) {}
    int dimension() const override { return 0; }
    ObjectPoint generate(const ParameterPoint&, Emitter& emit) const override {
        return point_of(at_, emit);
    }

private:
    Triple at_;
};

class Line final : public ObjectGenerator {
public:
    Line(Triple at, Triple along) : at_(std::move(at)), along_(std::move(along)) {}
    int dimension() const override { return 1; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        return point_of(at_, emit) + p.u * vector_of(along_, emit);
    }

private:
    Triple at_, along_;
};

class Circle final : public ObjectGenerator {
public:
    explicit Circle(Scalar radius) : radius_(std::move(radius)) {}
    int dimension() const override { return 1; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        const Expr r = emit(radius_);
        return {r * cos(p.u), r * sin(p.u), emit(0.0)};
    }

private:
    Scalar radius_;
};

class Plane final : public ObjectGenerator {
public:
    Plane(Triple at, Triple along_u, Triple along_v)
        : at_(std::move(at)), along_u_(std::move(along_u)), along_v_(std::move(along_v)) {}
    int dimension() const override { return 2; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        return point_of(at_, emit) + p.u * vector_of(along_u_, emit) +
               p.v * vector_of(along_v_, emit);
    }
    std::shared_ptr<const RayTarget> ray_target() const override {
        return plane_target(at_, along_u_, along_v_);
    }

private:
    Triple at_, along_u_, along_v_;
};

/// By angle u and height v.
class Cylinder final : public ObjectGenerator {
public:
    explicit Cylinder(Scalar radius) : radius_(std::move(radius)) {}
    int dimension() const override { return 2; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        const Expr r = emit(radius_);
        return {r * cos(p.u), r * sin(p.u), p.v};
    }
    std::shared_ptr<const RayTarget> ray_target() const override {
        return cylinder_target(radius_);
    }

private:
    Scalar radius_;
};

/// By the angle u around the axis and the angle v around the tube.
class Torus final : public ObjectGenerator {
public:
    Torus(Scalar major, Scalar minor) : major_(std::move(major)), minor_(std::move(minor)) {}
    int dimension() const override { return 2; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        const Expr r = emit(minor_);
        const Expr distance = emit(major_) + r * cos(p.v);
        return {distance * cos(p.u), distance * sin(p.u), r * sin(p.v)};
    }
    // A tube wider than its centre line intersects the axis, where its orientation changes.
    Expr orientation(const ParameterPoint& p, Emitter& emit) const override {
        const std::optional<double> major = major_.constant();
        const std::optional<double> minor = minor_.constant();
        return major && minor && *minor <= *major ? emit(1.0)
                                                  : emit(major_) + emit(minor_) * cos(p.v);
    }

private:
    Scalar major_, minor_;
};

StageParameter coordinate(std::string_view name) {
    return number_parameter(name, 0.0, "coordinate of the point");
}

StageParameter radius() { return positive_parameter("radius", 1.0, "the radius"); }

}  // namespace

std::vector<StageEntry> primitives() {
    return {
        {.name = "point",
         .meaning = "a single point",
         .formula = R"(
p = (x, y, z)
)",
         .parameters = {coordinate("x"), coordinate("y"), coordinate("z")},
         .make = [](const Arguments& a) { return made<Point>(xyz_of(a)); },
         .example = R"(
// All round from one point: the ceiling and the floor are stretched at the edges.
camera all_round {
    aspect 2
    map    u = 180deg .. -180deg, v = -90deg .. 90deg
    eye    point(0, 0, 0)
    toward sphere(1)
}
)"},
        {.name = "line",
         .meaning = "at + u along",
         .formula = R"(
p = at + u along
)",
         .parameters = {triple_parameter("at", {0.0, 0.0, 0.0}, "the point at u = 0"),
                        triple_parameter("along", {1.0, 0.0, 0.0}, "the vector for one unit of u")},
         .make = maker<Line>("at", "along"),
         .dimension = 1,
         .example = R"(
// From a train window: the eye moves along a line, and only the vertical direction has perspective.
camera train_window {
    map    u = -4 .. 4, v = -1 .. 1
    eye    line(along = (0, -1, 0))
    toward plane((1, 0, 0), along_u = (0, -1, 0))
}
)"},
        {.name = "circle",
         .meaning = "a circle around the z axis in the plane z = 0, by angle",
         .formula = R"(
p = (radius cos u, radius sin u, 0)
)",
         .parameters = {radius()},
         .make = maker<Circle>("radius"),
         .dimension = 1,
         .example = R"(
// Rays start on a circle and pass through a torus around it.
camera flight(R = 10, r = 2) {
    map    u = 90deg .. 0deg, v = -180deg .. 180deg
    eye    circle(R)
    toward torus(R, r)
}
)"},
        {.name = "plane",
         .meaning = "at + u along_u + v along_v",
         .formula = R"(
p = at + u along_u + v along_v
)",
         .parameters = {triple_parameter("at", {0.0, 0.0, 0.0}, "the point at u = v = 0"),
                        triple_parameter("along_u", {0.0, 1.0, 0.0},
                                         "the vector for one unit of u"),
                        triple_parameter("along_v", {0.0, 0.0, 1.0},
                                         "the vector for one unit of v")},
         .make = maker<Plane>("at", "along_u", "along_v"),
         .dimension = 2,
         .example = R"(
// Parallel rays from a plane: no perspective.
camera flat {
    map  u = 4 .. -4, v = square
    eye  plane
    look normal
}
)"},
        {.name = "cylinder",
         .meaning = "a cylinder around the z axis, by angle u and height v",
         .formula = R"(
p = (radius cos u, radius sin u, v)
)",
         .parameters = {radius()},
         .make = maker<Cylinder>("radius"),
         .dimension = 2,
         .example = R"(
// Unrolls a vase inside the cylinder.
camera unrolled_vase {
    map  u = -180deg .. 180deg, v = -1.5 .. 1.5
    eye  cylinder(3)
    look normal(side = back)
}
)"},
        {.name = "torus",
         .meaning =
             "a torus around the z axis, by the angles u around the axis and v around the tube",
         .formula = R"(
p = (r cos u, r sin u, minor sin v)      r = major + minor cos v
)",
         .parameters = {positive_parameter("major", 1.0,
                                           "distance from the axis to the centre of the tube"),
                        positive_parameter("minor", 1.0, "radius of the tube")},
         .make = maker<Torus>("major", "minor"),
         .dimension = 2,
         .example = R"(
// The outer half of a torus: all round and beyond the zenith and the nadir.
camera ring_outside {
    map  u = 180deg .. -180deg, v = -110deg .. 110deg
    eye  torus(3, 1)
    look normal
}
)"},
    };
}

}  // namespace balcony::camera
