// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object generators, PCS → OCS: the mirrors of catadioptric cameras, parametrised by the image of
// the camera that looks at them. The rule `reflect` makes the rays.

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

namespace {

/// Where the ray from the origin through (1, u, v) meets the mirror, which is ahead on the x axis.
class MirrorOfPinhole : public ObjectGenerator {
public:
    int dimension() const final { return 2; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const final {
        const Expr x = depth(p.u * p.u + p.v * p.v, emit);
        return {x, x * p.u, x * p.v};
    }

private:
    /// x of the point, by u² + v².
    virtual Expr depth(Expr q, Emitter& emit) const = 0;
};

/// The branch around the second focus of the hyperboloid with the foci 0 and (2e, 0, 0).
class HyperbolicMirror final : public MirrorOfPinhole {
public:
    HyperbolicMirror(Scalar a, Scalar b) : a_(std::move(a)), b_(std::move(b)) {}

private:
    Expr depth(Expr q, Emitter& emit) const override {
        const Expr a = emit(a_);
        const Expr b = emit(b_);
        const Expr e = sqrt(a * a + b * b);
        const Expr slope = e - a * sqrt(1.0 + q);
        emit.require(0.0 < slope);
        return b * b / slope;
    }

    Scalar a_, b_;
};

class SphericalMirror final : public MirrorOfPinhole {
public:
    SphericalMirror(Scalar radius, Scalar distance)
        : radius_(std::move(radius)), distance_(std::move(distance)) {}

private:
    Expr depth(Expr q, Emitter& emit) const override {
        const Expr r = emit(radius_);
        const Expr d = emit(distance_);
        const Expr inside = r * r * (1.0 + q) - d * d * q;
        emit.require(0.0 < inside);
        return (d - sqrt(max(inside, emit(0.0)))) / (1.0 + q);
    }

    Scalar radius_, distance_;
};

/// With the focus 0, seen along x by parallel rays.
class ParabolicMirror final : public ObjectGenerator {
public:
    explicit ParabolicMirror(Scalar radius) : radius_(std::move(radius)) {}
    int dimension() const override { return 2; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        const Expr h = emit(radius_);
        return {(p.u * p.u + p.v * p.v - h * h) / (2.0 * h), p.u, p.v};
    }

private:
    Scalar radius_;
};

StageResult make_spherical_mirror(const Arguments& a) {
    const std::optional<double> radius = a.number("radius").constant();
    const std::optional<double> distance = a.number("distance").constant();
    if (radius && distance && *distance <= *radius) {
        return error("the camera is inside of the spherical mirror", {},
                     "write a distance above the radius");
    }
    return made<SphericalMirror>(a.number("radius"), a.number("distance"));
}

}  // namespace

std::vector<StageEntry> mirrors() {
    return {
        {.name = "hyperbolic_mirror",
         .meaning = "a hyperbolic mirror, by the image of a pinhole camera in its outer focus: all "
                    "rays reflected in it have the inner focus as their viewpoint",
         .formula = R"(
p = x (1, u, v),   x = b²/(e − a √(1 + u² + v²)),   e = √(a² + b²)
|p| − |p − (2e, 0, 0)| = 2a: the hyperboloid of revolution with the foci
(0, 0, 0) and (2e, 0, 0)
no point where e ≤ a √(1 + u² + v²)
)",
         .parameters = {positive_parameter("a", 0.6, "the half axis along x"),
                        positive_parameter("b", 0.8, "the half axis across x")},
         .make = maker<HyperbolicMirror>("a", "b"),
         .dimension = 2,
         .example = R"(
// A camera below a mirror, which looks up at it and sees all around.
camera look_around {
    aspect 1
    map    u = 0.8 .. -0.8, v = square
    eye    hyperbolic_mirror(a = 0.6, b = 0.8)
    toward point
    look   reflect
    move   scale(0.1), rotate(y, -90deg)
}
)"},
        {.name = "spherical_mirror",
         .meaning = "a spherical mirror, by the image of a pinhole camera in the origin",
         .formula = R"(
p = x (1, u, v),   x = (l − √(r² (1 + q) − l² q))/(1 + q),   q = u² + v²
r = radius,   l = distance,   |p − (l, 0, 0)| = r
no point where l² q ≥ r² (1 + q): the ray misses the mirror
)",
         .parameters = {positive_parameter("radius", 1.0, "the radius of the mirror"),
                        positive_parameter("distance", 1.5, "from the camera to its centre")},
         .make = make_spherical_mirror,
         .dimension = 2,
         .example = R"(
// The photographer's view into a glass ball, which shows the room behind the photographer.
camera glass_ball {
    aspect 1
    map    u = 0.33 .. -0.33, v = square
    eye    spherical_mirror(radius = 0.3, distance = 1)
    toward point
    look   reflect
}
)"},
        {.name = "parabolic_mirror",
         .meaning = "a parabolic mirror, by the image of an orthographic camera: all rays "
                    "reflected in it have the focus, the origin, as their viewpoint",
         .formula = R"(
p = ((u² + v² − h²)/(2h), u, v),   h = radius
x = |p| − h: the paraboloid of revolution with the focus (0, 0, 0)
)",
         .parameters = {positive_parameter("radius", 1.0,
                                           "where the rays leave at right angles to the axis")},
         .make = maker<ParabolicMirror>("radius"),
         .dimension = 2,
         .example = R"(
// Parallel rays come from a plane below the mirror, through the same u and v.
camera paracatadioptric {
    aspect 1
    map    u = 1.2 .. -1.2, v = square
    eye    parabolic_mirror(radius = 1)
    toward plane((-3, 0, 0))
    look   reflect
    move   scale(0.1), rotate(y, -90deg)
}
)"},
    };
}

}  // namespace balcony::camera
