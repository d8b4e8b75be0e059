// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object generators, PCS → OCS: pieces of lines and circles, and the helix.

#include <numbers>

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

namespace {

/// Undefined beyond the ends, where the parameter is 0 and 1.
void require_between_ends(Expr parameter, Emitter& emit) {
    emit.require(0.0 <= parameter && parameter <= emit(1.0));
}

class Segment final : public ObjectGenerator {
public:
    Segment(Triple from, Triple to) : from_(std::move(from)), to_(std::move(to)) {}
    int dimension() const override { return 1; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        require_between_ends(p.u, emit);
        const ObjectPoint from = point_of(from_, emit);
        return from + p.u * (point_of(to_, emit) - from);
    }

private:
    Triple from_, to_;
};

class Arc final : public ObjectGenerator {
public:
    Arc(Scalar radius, Scalar from, Scalar to)
        : radius_(std::move(radius)), from_(std::move(from)), to_(std::move(to)) {}
    int dimension() const override { return 1; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        require_between_ends(p.u, emit);
        const Expr r = emit(radius_);
        const Expr angle = emit(from_) + (emit(to_) - emit(from_)) * p.u;
        return {r * cos(angle), r * sin(angle), emit(0.0)};
    }

private:
    Scalar radius_, from_, to_;
};

/// By the angle around the axis.
class Helix final : public ObjectGenerator {
public:
    Helix(Scalar radius, Scalar pitch) : radius_(std::move(radius)), pitch_(std::move(pitch)) {}
    int dimension() const override { return 1; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        constexpr double turn = 2.0 * std::numbers::pi;
        const Expr r = emit(radius_);
        return {r * cos(p.u), r * sin(p.u), emit(pitch_) / turn * p.u};
    }

private:
    Scalar radius_, pitch_;
};

StageParameter end_angle(std::string_view name, double value, std::string_view meaning) {
    return angle_parameter(name, value, meaning);
}

}  // namespace

std::vector<StageEntry> curve_primitives() {
    return {
        {.name = "segment",
         .meaning = "the line segment between two points, u from 0 to 1",
         .formula = R"(
p = from + u (to − from)      0 ≤ u ≤ 1
)",
         .parameters = {triple_parameter("from", {0.0, 0.0, 0.0}, "the point at u = 0"),
                        triple_parameter("to", {1.0, 0.0, 0.0}, "the point at u = 1")},
         .make = maker<Segment>("from", "to"),
         .dimension = 1,
         .example = R"(
// The side of a street from a car that drives along it: perspective only in the vertical direction.
camera street(length = 12) {
    map    u = 0 .. 1, v = -1 .. 1
    eye    segment((0, length/2, 0), (0, -length/2, 0))
    toward surface(u, v) = [3, length*(1/2 - u), 3*v]
}
)"},
        {.name = "arc",
         .meaning = "a circular arc around the z axis, u from 0 to 1",
         .formula = R"(
p = (radius cos φ, radius sin φ, 0)      φ = from + u (to − from),   0 ≤ u ≤ 1
)",
         .parameters = {positive_parameter("radius", 1.0, "the radius"),
                        end_angle("from", 0.0, "the angle where u is 0"),
                        end_angle("to", 0.5 * std::numbers::pi, "the angle where u is 1")},
         .make = maker<Arc>("radius", "from", "to"),
         .dimension = 1,
         .example = R"(
// Walks a third of a turn around an object, from left to right, and always looks at the centre.
camera walk(radius = 4) {
    map    u = 0 .. 1, v = -1.5 .. 1.5
    eye    arc(radius, from = 120deg, to = 240deg)
    toward surface(u, v) = [0, 0, v]
}
)"},
        {.name = "helix",
         .meaning = "a helix around the z axis, by angle",
         .formula = R"(
p = (radius cos u, radius sin u, pitch u/2π)
)",
         .parameters = {positive_parameter("radius", 1.0, "distance from the axis"),
                        number_parameter("pitch", 1.0, "rise per turn")},
         .make = maker<Helix>("radius", "pitch"),
         .dimension = 1,
         .example = R"(
// Climbs around a tower in two turns and unrolls its wall.
camera spiral_stair(radius = 3, pitch = 2) {
    map    u = 0deg .. 720deg, v = -1.2 .. 1.2
    eye    helix(radius, pitch)
    toward surface(u, v) = [0, 0, pitch*u/360deg + v]
}
)"},
    };
}

}  // namespace balcony::camera
