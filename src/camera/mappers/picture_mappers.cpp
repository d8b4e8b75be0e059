// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Picture mappers, DCS → PCS: the part of parameter space that the picture covers.

#include "camera/catalogue/families.hpp"

namespace balcony::camera {

namespace {

/// The value that runs from `first` at 0 to `last` at `extent`.
Expr between(Expr first, Expr last, Expr position, Expr extent) {
    return first + (last - first) * (position / extent);
}

/// u from the left to the right edge of the picture, v from the bottom to the top.
class RangeMapper final : public PictureMapper {
public:
    RangeMapper(Scalar u_first, Scalar u_last, Scalar v_first, Scalar v_last)
        : u_first_(std::move(u_first)),
          u_last_(std::move(u_last)),
          v_first_(std::move(v_first)),
          v_last_(std::move(v_last)) {}

    ParameterPoint map(const PicturePoint& picture, Emitter& emit) const override {
        const auto& [point, size] = picture;
        return {between(emit(u_first_), emit(u_last_), point.x, size.width),
                between(emit(v_last_), emit(v_first_), point.y, size.height)};
    }

private:
    Scalar u_first_, u_last_, v_first_, v_last_;
};

/// One parameter over its range, the other symmetric about 0 with the same units per pixel, so that
/// the parameter plane is not stretched for any aspect ratio. It increases to the right or
/// upwards.
class SquareMapper final : public PictureMapper {
public:
    enum class Given : std::uint8_t { u, v };
    SquareMapper(Given given, Scalar first, Scalar last)
        : given_(given), first_(std::move(first)), last_(std::move(last)) {}

    ParameterPoint map(const PicturePoint& picture, Emitter& emit) const override {
        const auto& [point, size] = picture;
        const Expr first = emit(first_);
        const Expr last = emit(last_);
        const Expr right = point.x - 0.5 * size.width;
        const Expr up = 0.5 * size.height - point.y;
        if (given_ == Given::u) {
            const Expr pixel = abs(last - first) / size.width;
            return {between(first, last, point.x, size.width), pixel * up};
        }
        const Expr pixel = abs(last - first) / size.height;
        return {pixel * right, between(last, first, point.y, size.height)};
    }
    bool adapts_to_aspect() const override { return true; }

private:
    Given given_;
    Scalar first_, last_;
};

StageParameter edge(std::string_view name, std::string_view meaning) {
    return {.name = name, .type = NumberParameter{.unit = Unit::either}, .meaning = meaning};
}

}  // namespace

std::vector<StageEntry> picture_mappers() {
    return {
        {.name = "range",
         .meaning = "maps the picture to a rectangle of parameter space: u = a .. b, v = c .. d",
         .formula = R"(
u = u_first + (u_last − u_first) x/W
v = v_last + (v_first − v_last) y/H
(x, y)   the point in pixels from the top left of a picture of W × H pixels
)",
         .parameters = {edge("u_first", "u at the left edge"),
                        edge("u_last", "u at the right edge"),
                        edge("v_first", "v at the bottom edge"),
                        edge("v_last", "v at the top edge")},
         .make = maker<RangeMapper>("u_first", "u_last", "v_first", "v_last"),
         .example = R"(
// All longitudes and the latitudes between the polar circles.
camera temperate {
    map    u = 180deg .. -180deg, v = -66deg .. 66deg
    eye    point
    toward sphere(1)
}
)"},
        {.name = "square_v",
         .meaning = "u = a .. b, v = square: v is 0 in the middle and increases upwards, with u's "
                    "units per pixel",
         .formula = R"(
u = u_first + (u_last − u_first) x/W
v = |u_last − u_first|/W · (H/2 − y)
(x, y)   the point in pixels from the top left of a picture of W × H pixels
)",
         .parameters = {edge("u_first", "u at the left edge"),
                        edge("u_last", "u at the right edge")},
         .make =
             [](const Arguments& a) {
                 return made<SquareMapper>(SquareMapper::Given::u, a.number("u_first"),
                                           a.number("u_last"));
             },
         .example = R"(
// 90 degrees in width, and the same number of pixels per degree in height.
camera wide {
    map    u = 45deg .. -45deg, v = square
    eye    point
    toward sphere(1)
}
)"},
        {.name = "square_u",
         .meaning = "u = square, v = a .. b: u is 0 in the middle and increases to the right, with "
                    "v's units per pixel",
         .formula = R"(
u = |v_last − v_first|/H · (x − W/2)
v = v_last + (v_first − v_last) y/H
(x, y)   the point in pixels from the top left of a picture of W × H pixels
)",
         .parameters = {edge("v_first", "v at the bottom edge"),
                        edge("v_last", "v at the top edge")},
         .make =
             [](const Arguments& a) {
                 return made<SquareMapper>(SquareMapper::Given::v, a.number("v_first"),
                                           a.number("v_last"));
             },
         .example = R"(
// 60 degrees in height, and the same number of pixels per degree in width. Longitudes increase to
// the left, so u is reversed.
camera high {
    map    u = square, v = -30deg .. 30deg
    warp   scale((-1, 1))
    eye    point
    toward sphere(1)
}
)"},
    };
}

}  // namespace balcony::camera
