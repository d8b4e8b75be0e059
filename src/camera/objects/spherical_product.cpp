// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object generator, PCS → OCS: the spherical product of two plane curves, which makes quadrics and
// superquadrics.

#include "camera/objects/spherical_product.hpp"

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

namespace {

/// g(u) ⊗ h(v) = (g1 h1, g2 h1, h2): cross-sections across z are scaled copies of g, cross-sections
/// through the z axis scaled copies of h (the paper, section 3.2).
class SphericalProduct final : public ObjectGenerator {
public:
    SphericalProduct(ObjectGeneratorPointer g, ObjectGeneratorPointer h)
        : g_(std::move(g)), h_(std::move(h)) {}
    int dimension() const override { return 2; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        const ObjectPoint g = g_->generate({p.u, emit(0.0)}, emit);
        const ObjectPoint h = h_->generate({p.v, emit(0.0)}, emit);
        return {g.x * h.x, g.y * h.x, h.y};
    }
    // The tangents (g1' h1, g2' h1, 0) and (g1 h1', g2 h1', h2') have the cross product
    // h1 (g2' h2', -g1' h2', (g1' g2 - g2' g1) h1'), which turns over where h1 changes sign.
    Expr orientation(const ParameterPoint& p, Emitter& emit) const override {
        return h_->generate({p.v, emit(0.0)}, emit).x;
    }

private:
    ObjectGeneratorPointer g_, h_;
};

bool lies_in_xy_plane(const ObjectGenerator& curve) {
    Graph graph;
    Emitter emit(graph);
    return curve.generate({graph.fresh_variable(), emit(0.0)}, emit).z.is_constant(0.0);
}

}  // namespace

ObjectGeneratorPointer spherical_product_of(ObjectGeneratorPointer g, ObjectGeneratorPointer h) {
    return std::make_shared<const SphericalProduct>(std::move(g), std::move(h));
}

std::vector<StageEntry> spherical_product() {
    return {
        {.name = "product",
         .meaning = "spherical product (g1 h1, g2 h1, h2) of two plane curves g(u) and h(v)",
         .formula = R"(
p = (g₁(u) h₁(v), g₂(u) h₁(v), h₂(v))
)",
         .parameters = {curve_parameter("g", "the horizontal cross-section, a curve in u"),
                        curve_parameter("h", "the vertical cross-section, a curve in v")},
         .make = [](const Arguments& a) -> StageResult {
             for (const char* factor : {"g", "h"}) {
                 if (!lies_in_xy_plane(*a.curve(factor))) {
                     return error("factor " + std::string(factor) +
                                      " of a spherical product must be a plane curve",
                                  {}, "use a curve whose z is 0, such as curve(u) = [x, y]");
                 }
             }
             return made<SphericalProduct>(a.curve("g"), a.curve("h"));
         },
         .dimension = 2,
         .example = R"(
// A long room unfolded: walls, ceiling and floor, from the product of two superellipses.
camera room(a = 45, b = 25, c = 25, gamma = 1/4) {
    aspect 4
    map  u = 180deg .. -180deg, v = -60deg .. 60deg
    eye  product(superellipse(1, b/a, gamma, by = arc_length),
                 superellipse(a, c, gamma, by = arc_length))
    look normal
}
)"},
    };
}

}  // namespace balcony::camera
