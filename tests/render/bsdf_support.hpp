// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Materials and directions to try the laws of a BSDF with.

#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include "shading/materials/bsdf.hpp"

namespace balcony::render::test {

struct NamedAppearance {
    std::string name;
    Appearance appearance;
    bool entering = true;
    V3f coat_normal{0.0F, 0.0F, 1.0F};  ///< Where the normal is z.
};

[[nodiscard]] Appearance dielectric(float roughness, const Color3f& color = Color3f(1.0F));
[[nodiscard]] Appearance metal(float roughness, const Color3f& color = Color3f(1.0F));

/// With a whole clearcoat.
[[nodiscard]] Appearance coated(Appearance appearance, float roughness);
/// With sheen.
[[nodiscard]] Appearance fibrous(Appearance appearance, float roughness, const Color3f& color);
/// A thin wall, and the boundary of a solid, through which all light passes.
[[nodiscard]] Appearance wall(float roughness, const Color3f& color = Color3f(1.0F));
[[nodiscard]] Appearance glass(float roughness, float ior, const Color3f& color = Color3f(1.0F));

/// One material or several of each kind, coloured, with roughnesses that a sum over cells of the
/// sphere resolves, and mirrors.
[[nodiscard]] std::vector<NamedAppearance> all_kinds();

/// The Bsdf on a plane with this normal.
[[nodiscard]] Bsdf on_plane(const NamedAppearance& material, const V3f& normal);
/// The same on the plane z = 0.
[[nodiscard]] Bsdf flat(const NamedAppearance& material);
[[nodiscard]] Bsdf flat(const Appearance& appearance);

[[nodiscard]] V3f at_cosine(float cosine);
[[nodiscard]] float brightest(const Color3f& color);

class Directions {
public:
    explicit Directions(unsigned seed) : random_(seed) {}

    float uniform() { return uniform_(random_); }
    V3f numbers() { return {uniform(), uniform(), uniform()}; }
    V3f on_sphere();
    V3f above(const V3f& normal, float min_cosine);
    /// Any material whatsoever, also with a clearcoat that is tilted by up to 60 degrees.
    NamedAppearance material();

private:
    std::mt19937 random_;
    std::uniform_real_distribution<float> uniform_{0.0F, 1.0F};
};

/// What a surface gives off for even light of radiance 1 from all sides, the mirror included: the
/// mean of the samples' weights, over a set of points that fills the cube evenly.
[[nodiscard]] Color3f albedo(const Bsdf& bsdf, const V3f& to_viewer, std::size_t samples);

}  // namespace balcony::render::test
