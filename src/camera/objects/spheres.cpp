// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object generator, PCS → OCS: the sphere in several parametrisations. In each of them (0, 0) is
// the point on the x axis, u increases towards y and v towards z, and the front is the outside.

#include <numbers>

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"
#include "camera/objects/ray_targets.hpp"

namespace balcony::camera {

namespace {

constexpr double pi = std::numbers::pi;

/// The maps of the unit sphere are the inverses of those in Snyder, "Map Projections: A Working
/// Manual" (1987): from the map to the sphere.
class Sphere : public ObjectGenerator {
public:
    explicit Sphere(Scalar radius) : radius_(std::move(radius)) {}
    int dimension() const final { return 2; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const final {
        const ObjectPoint unit = unit_sphere(p, emit);
        const Expr r = emit(radius_);
        return {r * unit.x, r * unit.y, r * unit.z};
    }
    std::shared_ptr<const RayTarget> ray_target() const final { return sphere_target(radius_); }

private:
    virtual ObjectPoint unit_sphere(const ParameterPoint& p, Emitter& emit) const = 0;

    Scalar radius_;
};

ObjectPoint at_longitude_and_latitude(Expr longitude, Expr latitude) {
    return {cos(longitude) * cos(latitude), sin(longitude) * cos(latitude), sin(latitude)};
}

class LatitudeSphere final : public Sphere {
public:
    using Sphere::Sphere;
    // Beyond a pole, the tangent along u is reversed.
    Expr orientation(const ParameterPoint& p, Emitter&) const override { return cos(p.v); }

private:
    ObjectPoint unit_sphere(const ParameterPoint& p, Emitter&) const override {
        return at_longitude_and_latitude(p.u, p.v);
    }
};

/// Projection from the point opposite (1, 0, 0) onto the tangent plane there: conformal.
class StereographicSphere final : public Sphere {
    using Sphere::Sphere;
    ObjectPoint unit_sphere(const ParameterPoint& p, Emitter&) const override {
        const Expr q = p.u * p.u + p.v * p.v;
        const Expr k = 4.0 / (4.0 + q);
        return {k * (1.0 - 0.25 * q), k * p.u, k * p.v};
    }
};

/// Lambert's azimuthal map: the distance from the centre is the length of the chord to (1, 0, 0).
class AzimuthalEqualAreaSphere final : public Sphere {
    using Sphere::Sphere;
    ObjectPoint unit_sphere(const ParameterPoint& p, Emitter& emit) const override {
        const Expr q = p.u * p.u + p.v * p.v;
        emit.require(q < 4.0);
        const Expr k = sqrt(1.0 - 0.25 * q);
        return {1.0 - 0.5 * q, k * p.u, k * p.v};
    }
};

/// The distance from the centre is the angle to (1, 0, 0).
class AzimuthalEquidistantSphere final : public Sphere {
    using Sphere::Sphere;
    ObjectPoint unit_sphere(const ParameterPoint& p, Emitter& emit) const override {
        constexpr double tiny = 1e-20;  // makes sin(r)/r equal 1 in the centre
        const Expr q = p.u * p.u + p.v * p.v;
        emit.require(q < pi * pi);
        const Expr angle = sqrt(max(q, emit(tiny)));
        const Expr ratio = sin(angle) / angle;
        return {cos(angle), ratio * p.u, ratio * p.v};
    }
};

/// Parallel projection along x: the front hemisphere.
class OrthographicSphere final : public Sphere {
    using Sphere::Sphere;
    ObjectPoint unit_sphere(const ParameterPoint& p, Emitter& emit) const override {
        const Expr squared_cosine = 1.0 - p.u * p.u - p.v * p.v;
        emit.require(0.0 < squared_cosine);
        return {sqrt(squared_cosine), p.u, p.v};
    }
};

/// Lambert's cylindrical map: by longitude and height.
class CylindricalEqualAreaSphere final : public Sphere {
    using Sphere::Sphere;
    ObjectPoint unit_sphere(const ParameterPoint& p, Emitter& emit) const override {
        const Expr k = 1.0 - p.v * p.v;
        emit.require(0.0 < k);
        return {sqrt(k) * cos(p.u), sqrt(k) * sin(p.u), p.v};
    }
};

/// Mollweide's map: an ellipse of the half axes 2 sqrt(2) and sqrt(2), parallels straight.
class MollweideSphere final : public Sphere {
    using Sphere::Sphere;
    ObjectPoint unit_sphere(const ParameterPoint& p, Emitter& emit) const override {
        const Expr sine = p.v / std::numbers::sqrt2;
        const Expr squared_cosine = 1.0 - sine * sine;
        emit.require(0.0 < squared_cosine && p.u * p.u / 8.0 < squared_cosine);
        const Expr cosine = sqrt(squared_cosine);
        const Expr height = (2.0 / pi) * (asin(sine) + sine * cosine);
        const Expr longitude = pi / (2.0 * std::numbers::sqrt2) * p.u / cosine;
        const Expr distance = sqrt(1.0 - height * height);
        return {distance * cos(longitude), distance * sin(longitude), height};
    }
};

/// The cube of half side 1, seen from its centre and unfolded to a cross, u increasing to the left:
///
///                        top                 v = 3
///         back   left   front  right         v = 1
///                       bottom               v = -1
///
///     u = 5      3      1     -1     -3      v = -3
class CubeSphere final : public Sphere {
public:
    enum class Spacing : std::uint8_t { gnomonic, equiangular };
    CubeSphere(Scalar radius, Spacing spacing) : Sphere(std::move(radius)), spacing_(spacing) {}

private:
    ObjectPoint unit_sphere(const ParameterPoint& p, Emitter& emit) const override {
        const Expr column = floor(0.5 * (p.u + 1.0));
        const Expr row = floor(0.5 * (p.v + 1.0));
        const Expr in_band = equal(row, emit(0.0));
        emit.require((in_band && -1.0 <= column && column <= emit(2.0)) ||
                     (equal(column, emit(0.0)) && abs(row) <= emit(1.0)));

        // On the face, from -1 to 1; the front face is rotated to the row, then to the column.
        const Expr s = spaced(p.u - 2.0 * column);
        const Expr t = spaced(p.v - 2.0 * row);
        const Expr forward = select(in_band, emit(1.0), -row * t);
        const Expr up = select(in_band, t, row);
        const Expr cosine = 1.0 - abs(column);  // of -1, 0, 1 or 2 quarter turns
        const Expr sine = select(abs(column) <= emit(1.0), column, emit(0.0));
        const Expr scale = 1.0 / sqrt(1.0 + s * s + t * t);
        return {scale * (cosine * forward - sine * s), scale * (sine * forward + cosine * s),
                scale * up};
    }

    Expr spaced(Expr position) const {
        return spacing_ == Spacing::gnomonic ? position : tan(0.25 * pi * position);
    }

    Spacing spacing_;
};

StageResult make_sphere(const Arguments& a) {
    const Scalar radius = a.number("radius");
    const std::string& by = a.choice("by");
    if (by == "stereographic") {
        return made<StereographicSphere>(radius);
    }
    if (by == "equal_area") {
        return made<AzimuthalEqualAreaSphere>(radius);
    }
    if (by == "equidistant") {
        return made<AzimuthalEquidistantSphere>(radius);
    }
    if (by == "orthographic") {
        return made<OrthographicSphere>(radius);
    }
    if (by == "cylindrical_equal_area") {
        return made<CylindricalEqualAreaSphere>(radius);
    }
    if (by == "mollweide") {
        return made<MollweideSphere>(radius);
    }
    if (by == "cube") {
        return made<CubeSphere>(radius, CubeSphere::Spacing::gnomonic);
    }
    if (by == "equiangular_cube") {
        return made<CubeSphere>(radius, CubeSphere::Spacing::equiangular);
    }
    return made<LatitudeSphere>(radius);
}

}  // namespace

std::vector<StageEntry> spheres() {
    return {
        {.name = "sphere",
         .meaning = "a sphere, by longitude u and latitude v or by a map projection; u = v = 0 is "
                    "on the x axis",
         .formula = R"(
p = radius e with the unit vector e, and q = u² + v²:
latitude         e = (cos u cos v, sin u cos v, sin v)
stereographic    e = (4 − q, 4u, 4v)/(4 + q)
equal_area       e = (1 − q/2, u √(1 − q/4), v √(1 − q/4)),   q < 4
equidistant      e = (cos r, u sin(r)/r, v sin(r)/r),   r = √q < π
orthographic     e = (√(1 − q), u, v),   q < 1
cylindrical_equal_area   e = (√(1 − v²) cos u, √(1 − v²) sin u, v),   |v| < 1
mollweide        at longitude π u/(2√2 cos θ) and latitude φ,
                 sin θ = v/√2,   π sin φ = 2θ + sin 2θ
cube             on face (i, j) = (⌊(u + 1)/2⌋, ⌊(v + 1)/2⌋) of the cross, with
                 s = u − 2i, t = v − 2j:  e = f/|f|,
                 f = (1, s, t), turned by 90° i about z, if j = 0
                 f = (−j t, s, j) otherwise
equiangular_cube   the same with tan(π s/4) and tan(π t/4) for s and t
)",
         .parameters =
             {positive_parameter("radius", 1.0, "the radius"),
              choice_parameter(
                  "by",
                  {"latitude", "stereographic", "equal_area", "equidistant", "orthographic",
                   "cylindrical_equal_area", "mollweide", "cube", "equiangular_cube"},
                  "the parametrisation: longitude and latitude; plane coordinates of the "
                  "stereographic projection, the hemisphere within 2; of Lambert's azimuthal "
                  "projection, the sphere within 2, the hemisphere within the square root of 2, "
                  "which is an equisolid fisheye; of the equidistant one, in radians; of the "
                  "orthographic one, the hemisphere within 1; "
                  "longitude and z/radius; Mollweide's ellipse of 2.83 by 1.41; a cube unfolded "
                  "to a cross of faces that are 2 wide: the front from -1 to 1, all from u = 5 .. "
                  "-3 and v = -3 .. 3, flat or in equal angles")},
         .make = make_sphere,
         .dimension = 2,
         .example = R"(
// A cube map in one picture: four walls in a row, ceiling and floor above and below the front.
camera cube_map {
    aspect 4/3
    map  u = 5 .. -3, v = -3 .. 3
    eye  sphere(0.1, by = cube)
    look normal
}
)"},
    };
}

}  // namespace balcony::camera
