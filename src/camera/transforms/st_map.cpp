// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Parameter transformer, PCS → PCS: an STMap, the form in which compositing programs keep the
// distortion of a lens.

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"
#include "camera/tables/cubic_map.hpp"

namespace balcony::camera {

namespace {

class StMap final : public ParameterTransformer {
public:
    StMap(const PixelMap& positions, Pair from, Pair to)
        : positions_(positions), from_(std::move(from)), to_(std::move(to)) {}

    ParameterPoint transform(const ParameterPoint& p, Emitter& emit) const override {
        const ParameterPoint from = parameter_point_of(from_, emit);
        const ParameterPoint to = parameter_point_of(to_, emit);
        const std::vector<Expr> st =
            positions_({(p.u - from.u) / (to.u - from.u), (p.v - from.v) / (to.v - from.v)}, emit);
        return {from.u + st[0] * (to.u - from.u), from.v + st[1] * (to.v - from.v)};
    }

private:
    CubicMap positions_;
    Pair from_, to_;
};

StageResult make_st_map(const Arguments& a) {
    const Pair from = a.pair("from");
    const Pair to = a.pair("to");
    for (std::size_t axis = 0; axis < 2; ++axis) {
        if (from[axis].constant() && from[axis].constant() == to[axis].constant()) {
            return error("the box of this STMap has no extent", {},
                         "make from and to differ in both coordinates");
        }
    }
    return made<StMap>(*a.file<PixelMap>("file"), from, to);
}

}  // namespace

std::vector<StageEntry> st_maps() {
    return {
        {.name = "stmap",
         .meaning = "an STMap, such as the distortion of a lens: an image whose red and green are "
                    "the position to take",
         .formula = R"(
(u′, v′) = from + (s, t) (to − from)
(s, t)   red and green of the image at ((u, v) − from)/(to − from),
         where (0, 0) is the bottom left and (1, 1) the top right,
         by cubic convolution (Keys 1981) between the centres of its pixels
no ray outside the box and where the image is transparent
)",
         .parameters = {{.name = "file",
                         .type = MapParameter{.content = MapParameter::Content::positions},
                         .meaning = "image file with at least two channels, usually EXR"},
                        pair_parameter("from", {0.0, 0.0},
                                       "(u, v) at the bottom left of the image"),
                        pair_parameter("to", {1.0, 1.0}, "(u, v) at its top right")},
         .make = make_st_map,
         .example = R"(
// The barrel distortion of a lens, as a compositing program has it.
camera through_lens {
    map    u = 0.8 .. -0.8, v = -0.45 .. 0.45
    warp   stmap("lens.exr", from = (0.8, -0.45), to = (-0.8, 0.45))
    eye    point
    toward plane((1, 0, 0))
}
)"},
    };
}

}  // namespace balcony::camera
