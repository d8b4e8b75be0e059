// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object generators, PCS → OCS: seeded fractal height fields over a plane and over a sphere.

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"
#include "camera/objects/fractal_noise.hpp"

namespace balcony::camera {

namespace {

/// Heights over a surface, as a function of the surface's points in space.
class HeightField {
public:
    explicit HeightField(const Arguments& a)
        : noise_(a.count("seed"), a.count("octaves")),
          height_(a.number("height")),
          scale_(a.number("scale")),
          hurst_(a.number("hurst")),
          lacunarity_(a.number("lacunarity")) {}

    [[nodiscard]] Expr over(const ObjectPoint& p, const Emitter& emit) const {
        const Expr fineness = 1.0 / emit(scale_);
        return emit(height_) * noise_.emit({fineness * p.x, fineness * p.y, fineness * p.z},
                                           emit(lacunarity_), emit(hurst_));
    }

private:
    FractalNoise noise_;
    Scalar height_, scale_, hurst_, lacunarity_;
};

class FractalPlane final : public ObjectGenerator {
public:
    explicit FractalPlane(HeightField heights) : heights_(std::move(heights)) {}
    int dimension() const override { return 2; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        return {p.u, p.v, heights_.over({p.u, p.v, emit(0.0)}, emit)};
    }

private:
    HeightField heights_;
};

/// By longitude u and latitude v, without a seam or visible poles.
class FractalSphere final : public ObjectGenerator {
public:
    FractalSphere(Scalar radius, HeightField heights)
        : radius_(std::move(radius)), heights_(std::move(heights)) {}
    int dimension() const override { return 2; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        const Expr x = cos(p.u) * cos(p.v);
        const Expr y = sin(p.u) * cos(p.v);
        const Expr z = sin(p.v);
        const Expr r = emit(radius_);
        const Expr distance = r + heights_.over({r * x, r * y, r * z}, emit);
        emit.require(0.0 < distance);
        return {distance * x, distance * y, distance * z};
    }

private:
    Scalar radius_;
    HeightField heights_;
};

std::vector<StageParameter> height_field_parameters() {
    // Sixteen octaves of lacunarity 2 reach from a landscape to a pebble.
    return {
        number_parameter("height", 0.1, "standard deviation of the heights"),
        positive_parameter("scale", 1.0, "size of the largest features"),
        number_parameter("hurst", 0.8,
                         "Hurst exponent: 1 is smooth hills, 1/2 is rough rock; heights at a "
                         "distance d differ by about d^hurst",
                         {.minimum = 0.0, .maximum = 1.0}),
        {.name = "octaves",
         .type = CountParameter{.default_value = 8.0, .range = {.minimum = 1.0, .maximum = 16.0}},
         .meaning = "number of octaves, each finer by the lacunarity"},
        number_parameter("lacunarity", 2.0, "frequency ratio between successive octaves",
                         {.minimum = 1.0, .maximum = 8.0, .excludes_minimum = true}),
        {.name = "seed",
         .type = CountParameter{.default_value = 1.0, .range = {.minimum = 0.0, .maximum = 1e6}},
         .meaning = "random seed: the same seed gives the same surface on every machine"}};
}

}  // namespace

std::vector<StageEntry> fractals() {
    std::vector<StageParameter> sphere_parameters = height_field_parameters();
    sphere_parameters.insert(sphere_parameters.begin(),
                             positive_parameter("radius", 1.0, "radius at height 0"));
    return {
        {.name = "fractal_plane",
         .meaning =
             "a fractal landscape, z = height over (x, y) = (u, v), by fractional Brownian motion",
         .formula = R"(
p = (u, v, H(u, v, 0))
H(q) = height Σᵢ gⁱ N(lⁱ Rᵢ q/scale + oᵢ) / √(Σᵢ g²ⁱ)      i = 0 … octaves − 1
l = lacunarity,   g = l^(−hurst)
N   a cubic B-spline of random control values one unit apart, with period 8,
    mean 0 and variance 1
Rᵢ, oᵢ   a random rotation and a random offset for each octave
)",
         .parameters = height_field_parameters(),
         .make = [](const Arguments& a) { return made<FractalPlane>(HeightField(a)); },
         .dimension = 2,
         .example = R"(
// A view through frosted glass: every point of the pane, an upright landscape, looks elsewhere.
camera frosted_glass {
    map  u = 2 .. -2, v = square
    eye  fractal_plane(height = 0.05, octaves = 5)
    look normal
    move rotate(z, 90deg), rotate(y, 90deg)
}
)"},
        {.name = "fractal_sphere",
         .meaning = "a fractal planet by longitude u and latitude v, heights by fractional "
                    "Brownian motion",
         .formula = R"(
p = (radius + H(radius e)) e      e = (cos u cos v, sin u cos v, sin v)
H(q) = height Σᵢ gⁱ N(lⁱ Rᵢ q/scale + oᵢ) / √(Σᵢ g²ⁱ)      i = 0 … octaves − 1
l = lacunarity,   g = l^(−hurst)
N   a cubic B-spline of random control values one unit apart, with period 8,
    mean 0 and variance 1
Rᵢ, oᵢ   a random rotation and a random offset for each octave
)",
         .parameters = std::move(sphere_parameters),
         .make =
             [](const Arguments& a) {
                 return made<FractalSphere>(a.number("radius"), HeightField(a));
             },
         .dimension = 2,
         .example = R"(
// A full panorama from a boulder: every facet looks in another direction.
camera boulder {
    map  u = 180deg .. -180deg, v = -80deg .. 80deg
    eye  fractal_sphere(radius = 1, height = 0.03, octaves = 3, seed = 7)
    look normal
}
)"},
    };
}

}  // namespace balcony::camera
