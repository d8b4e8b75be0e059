// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/families.hpp"

namespace balcony::camera {

namespace {

using Triple = std::array<Scalar, 3>;

ObjectPoint point_of(const Triple& t, Emitter& emit) {
    return {emit(t[0]), emit(t[1]), emit(t[2])};
}

ObjectVector vector_of(const Triple& t, Emitter& emit) {
    return {emit(t[0]), emit(t[1]), emit(t[2])};
}

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

private:
    Triple at_, along_u_, along_v_;
};

/// By longitude u and latitude v.
class Sphere final : public ObjectGenerator {
public:
    explicit Sphere(Scalar radius) : radius_(std::move(radius)) {}
    int dimension() const override { return 2; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        const Expr r = emit(radius_);
        return {r * cos(p.u) * cos(p.v), r * sin(p.u) * cos(p.v), r * sin(p.v)};
    }

private:
    Scalar radius_;
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

private:
    Scalar radius_;
};

/// By the angle u round the axis and the angle v round the tube.
class Torus final : public ObjectGenerator {
public:
    Torus(Scalar major, Scalar minor) : major_(std::move(major)), minor_(std::move(minor)) {}
    int dimension() const override { return 2; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        const Expr r = emit(minor_);
        const Expr distance = emit(major_) + r * cos(p.v);
        return {distance * cos(p.u), distance * sin(p.u), r * sin(p.v)};
    }

private:
    Scalar major_, minor_;
};

StageParameter coordinate(std::string_view name) {
    return {.name = name, .default_value = {0.0}, .meaning = "its position"};
}

StageParameter place(std::string_view meaning) {
    return {.name = "at",
            .type = ParameterType::triple,
            .default_value = {0.0, 0.0, 0.0},
            .meaning = meaning};
}

StageParameter radius(std::string_view name, std::string_view meaning) {
    return {.name = name,
            .default_value = {1.0},
            .least = 0.0,
            .above_least = true,
            .meaning = meaning};
}

}  // namespace

std::vector<StageEntry> primitives() {
    using enum ParameterType;
    const StageKind kind = StageKind::object_generator;
    return {
        {kind,
         "point",
         "a single point",
         {coordinate("x"), coordinate("y"), coordinate("z")},
         [](const Arguments& a) {
             return made<Point>(Triple{a.number("x"), a.number("y"), a.number("z")});
         },
         {},
         0},
        {kind,
         "line",
         "at + u along",
         {place("the point of u = 0"),
          {.name = "along",
           .type = triple,
           .default_value = {1.0, 0.0, 0.0},
           .meaning = "the step for one unit of u"}},
         [](const Arguments& a) { return made<Line>(a.triple("at"), a.triple("along")); },
         {},
         1},
        {kind,
         "circle",
         "a circle round the z axis in the plane z = 0, by angle",
         {radius("radius", "its radius")},
         [](const Arguments& a) { return made<Circle>(a.number("radius")); },
         {},
         1},
        {kind,
         "plane",
         "at + u along_u + v along_v",
         {place("the point of u = v = 0"),
          {.name = "along_u",
           .type = triple,
           .default_value = {0.0, 1.0, 0.0},
           .meaning = "the step for one unit of u"},
          {.name = "along_v",
           .type = triple,
           .default_value = {0.0, 0.0, 1.0},
           .meaning = "the step for one unit of v"}},
         [](const Arguments& a) {
             return made<Plane>(a.triple("at"), a.triple("along_u"), a.triple("along_v"));
         },
         {},
         2},
        {kind,
         "sphere",
         "a sphere by longitude u and latitude v",
         {radius("radius", "its radius")},
         [](const Arguments& a) { return made<Sphere>(a.number("radius")); },
         {},
         2},
        {kind,
         "cylinder",
         "a cylinder round the z axis by angle u and height v",
         {radius("radius", "its radius")},
         [](const Arguments& a) { return made<Cylinder>(a.number("radius")); },
         {},
         2},
        {kind,
         "torus",
         "a torus round the z axis by the angle u round the axis and v round the tube",
         {radius("major", "from the axis to the middle of the tube"),
          radius("minor", "of the tube")},
         [](const Arguments& a) { return made<Torus>(a.number("major"), a.number("minor")); },
         {},
         2},
    };
}

}  // namespace balcony::camera
