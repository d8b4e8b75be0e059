// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object generator, PCS → OCS: the origins, the targets or the directions of a map of rays.

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"
#include "camera/tables/cubic_map.hpp"

namespace balcony::camera {

namespace {

/// Three channels of a map as a surface.
class RayMapSurface final : public ObjectGenerator {
public:
    explicit RayMapSurface(const PixelMap& points) : points_(points) {}

    int dimension() const override { return 2; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        const std::vector<Expr> at = points_(p, emit);
        return {at[0], at[1], at[2]};
    }

private:
    CubicMap points_;
};

StageResult make_ray_map(const Arguments& a) {
    const PixelMap& rays = *a.file<PixelMap>("file");
    const std::string& what = a.choice("points");
    const std::ptrdiff_t first = what == "directions" ? 3 : 0;
    PixelMap points{rays.width,
                    rays.height,
                    {rays.channels.begin() + first, rays.channels.begin() + first + 3},
                    rays.valid};
    for (std::size_t axis = 0; what == "targets" && axis < 3; ++axis) {
        for (std::size_t i = 0; i < points.valid.size(); ++i) {
            points.channels[axis][i] += rays.channels[3 + axis][i];
        }
    }
    return made<RayMapSurface>(points);
}

}  // namespace

std::vector<StageEntry> ray_maps() {
    return {
        {.name = "ray_map",
         .meaning =
             "the rays of a file, such as those of a measured camera: eye has their origins, "
             "toward their targets",
         .formula = R"(
p = Σᵢⱼ w(x − i) w(y − j) Pᵢⱼ      x = u W − 1/2,   y = (1 − v) H − 1/2
P   of the pixel in column i and row j of W × H: the origin o of its ray,
    its target o + d or its direction d
w   cubic convolution (Keys 1981): 1 − 5/2 |r|² + 3/2 |r|³ for |r| ≤ 1,
    2 − 4 |r| + 5/2 |r|² − 1/2 |r|³ for |r| ≤ 2, otherwise 0
no ray outside the map and in the squares of its pixels without a ray
)",
         .parameters = {{.name = "file",
                         .type = MapParameter{.content = MapParameter::Content::rays},
                         .meaning =
                             "EXR file or array (.npy) of rays; (0, 0) is the bottom left of "
                             "the map and (1, 1) its top right"},
                        choice_parameter("points", {"origins", "targets", "directions"},
                                         "of the rays; targets are a unit along them")},
         .make = make_ray_map,
         .dimension = 2,
         .example = R"(
// A camera that was measured: its rays, one for each pixel of a small map, are in a file.
camera measured {
    map    u = 0 .. 1, v = 0 .. 1
    eye    ray_map("rays.npy")
    toward ray_map("rays.npy", targets)
}
)"},
    };
}

}  // namespace balcony::camera
