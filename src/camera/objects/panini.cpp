// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object generator, PCS → OCS: the sphere by the general Panini projection, as a direction object
// for wide views in which vertical and radial lines stay straight.

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

namespace {

/// Sharpless, Postle and German, "Pannini: A New Projection for Rendering Wide Angle Perspective
/// Images" (2010).
class Panini final : public ObjectGenerator {
public:
    Panini(Scalar radius, Scalar d, Scalar s)
        : radius_(std::move(radius)), d_(std::move(d)), s_(std::move(s)) {}
    int dimension() const override { return 2; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        const Expr d = emit(d_);
        const Expr s = emit(s_);
        // The point (cosine, sine) of the unit circle on the line from (-d, 0) to (1, h).
        const Expr h = p.u / (d + 1.0);
        const Expr k = h * h;
        const Expr discriminant = 1.0 + k * (1.0 - d * d);
        emit.require(0.0 <= discriminant);
        const Expr cosine = (sqrt(max(discriminant, emit(0.0))) - k * d) / (1.0 + k);
        const Expr reach = d + cosine;
        emit.require(0.0 < reach);
        const Expr sine = h * reach;
        // The vertical scale is that of the projection, or where s is 1 that of a perspective view.
        const Expr vertical = (1.0 - s) * (d + 1.0) / reach + s / cosine;
        emit.require(0.0 < vertical);
        const Expr tangent = p.v / vertical;
        const Expr scale = emit(radius_) / sqrt(1.0 + tangent * tangent);
        return {scale * cosine, scale * sine, scale * tangent};
    }

private:
    Scalar radius_, d_, s_;
};

}  // namespace

std::vector<StageEntry> panini() {
    return {
        {.name = "panini",
         .meaning = "a sphere by the general Panini projection, which keeps vertical and radial "
                    "lines straight in wide views; u = v = 0 is on the x axis",
         .formula = R"(
the point at longitude φ and latitude θ with
u = S sin φ,   v = tan θ ((1 − s) S + s/cos φ),   S = (d + 1)/(d + cos φ)
no point where these have no inverse: d + cos φ ≤ 0, 1 + d cos φ < 0
)",
         .parameters = {positive_parameter("radius", 1.0, "the radius"),
                        number_parameter(
                            "d", 1.0,
                            "the compression of the width: 0 is perspective, 1 the "
                            "painters' projection, and a large one nearly orthographic",
                            {.minimum = 0.0}),
                        number_parameter(
                            "s", 0.0,
                            "the compression of the height at the sides: 1 keeps horizontal "
                            "lines straight, too, for views of less than 180 degrees",
                            {.minimum = 0.0, .maximum = 1.0})},
         .make = maker<Panini>("radius", "d", "s"),
         .dimension = 2,
         .example = R"(
// 150 degrees in width, without the stretched sides of a perspective view.
camera painters_view {
    map    u = 1.5 .. -1.5, v = square
    eye    point
    toward panini(d = 1)
}
)"},
    };
}

}  // namespace balcony::camera
