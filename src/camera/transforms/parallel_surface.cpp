// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object transformers, OCS → OCS: along the normals of the object. do Carmo, "Differential Geometry
// of Curves and Surfaces", section 3-5: parallel surfaces.

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

namespace {

/// The parallel surface has the normals of the surface.
class Offset final : public ObjectTransformer {
public:
    explicit Offset(Scalar distance) : distance_(std::move(distance)) {}
    int min_dimension() const override { return 2; }
    /// A point without a surface stays.
    ObjectPoint transform(const ObjectPoint& p, Emitter&) const override { return p; }
    ObjectElement transform_element(const ObjectElement& e, Emitter& emit) const override {
        const ObjectVector n = normal_of(e);
        const ObjectVector unit = (1.0 / sqrt(dot(n, n))) * n;
        return {e.point + emit(distance_) * unit, unit, e.parameters};
    }

private:
    Scalar distance_;
};

}  // namespace

std::vector<StageEntry> parallel_surface() {
    return {
        {.name = "offset",
         .meaning = "moves a surface along its normals, which it keeps",
         .formula = R"(
p′ = p + distance n,   n′ = n
n   the unit vector along ∂p/∂u × ∂p/∂v, or the object's own unit normal
It folds over where distance κ > 1 for a principal curvature κ, which is
positive where the surface bends towards n.
)",
         .parameters = {{.name = "distance",
                         .type = NumberParameter{},
                         .meaning = "towards the front of the surface; a negative distance is "
                                    "towards its back"}},
         .make = maker<Offset>("distance"),
         .example = R"(
// A bent panel scanned from one unit in front of it, everywhere at right angles.
camera scan {
    map  u = 2 .. -2, v = square
    eye {
        object surface(u, v) = [0.3*sin(2*u), u, v]
        move   offset(-1)
    }
    look normal(front)
}
)"},
    };
}

}  // namespace balcony::camera
