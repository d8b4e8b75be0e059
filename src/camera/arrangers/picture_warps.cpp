// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Picture arrangers that distort the picture, DCS → DCS.

#include <numbers>

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

namespace {

/// The offset of a picture point from a fixed point, in pixels.
struct Offset {
    Expr x, y;
};

Offset offset_from(const Pair& at, const PicturePoint& picture, Emitter& emit) {
    const auto& [point, size] = picture;
    return {point.x - emit(at[0]) * size.width, point.y - emit(at[1]) * size.height};
}

/// The local zoom of parameter space, on the picture: the offset d from the point becomes
/// d (1 - k (1 - q)^3) with q = |d|^2 / radius^2 < 1 and k = 1 - 1/strength.
class ZoomPicture final : public PictureArranger {
public:
    ZoomPicture(Pair at, Scalar radius, Scalar strength)
        : at_(std::move(at)), radius_(std::move(radius)), strength_(std::move(strength)) {}

    PicturePoint arrange(const PicturePoint& picture, Emitter& emit) const override {
        const auto& [point, size] = picture;
        const Offset d = offset_from(at_, picture, emit);
        const Expr radius = emit(radius_) * size.height;
        const Expr q = (d.x * d.x + d.y * d.y) / (radius * radius);
        const Expr near = max(1.0 - q, emit(0.0));
        const Expr pull = (1.0 - 1.0 / emit(strength_)) * (near * near * near);
        return {{point.x - pull * d.x, point.y - pull * d.y}, size};
    }

private:
    Pair at_;
    Scalar radius_, strength_;
};

/// Circular waves: distances r from the point become r + a sin(2 pi r / wavelength - phase).
class Ripple final : public PictureArranger {
public:
    Ripple(Scalar amplitude, Scalar wavelength, Pair at, Scalar phase)
        : amplitude_(std::move(amplitude)),
          wavelength_(std::move(wavelength)),
          at_(std::move(at)),
          phase_(std::move(phase)) {}

    PicturePoint arrange(const PicturePoint& picture, Emitter& emit) const override {
        const auto& [point, size] = picture;
        const Offset d = offset_from(at_, picture, emit);
        // A billionth of a pixel avoids 0/0 in the direction at the point itself.
        const Expr r = sqrt(d.x * d.x + d.y * d.y + 1e-18);
        const Expr wave =
            sin(2.0 * std::numbers::pi * r / (emit(wavelength_) * size.height) - emit(phase_));
        const Expr stretch = emit(amplitude_) * size.height * wave / r;
        return {{point.x + stretch * d.x, point.y + stretch * d.y}, size};
    }

private:
    Scalar amplitude_, wavelength_;
    Pair at_;
    Scalar phase_;
};

/// formula(x, y) = [x', y']: the position of the point (x, y) in the camera's image; both run from
/// -1 to 1, to the right and up.
class PictureFormula final : public PictureArranger {
public:
    explicit PictureFormula(Formula formula) : formula_(std::move(formula)) {}

    PicturePoint arrange(const PicturePoint& picture, Emitter& emit) const override {
        const auto& [point, size] = picture;
        const std::array centered{2.0 * point.x / size.width - 1.0,
                                  1.0 - 2.0 * point.y / size.height};
        const std::vector<Expr> xy = formula_.emit(emit.graph(), centered);
        emit.require(is_finite(xy[0]) && is_finite(xy[1]));
        return {{0.5 * (xy[0] + 1.0) * size.width, 0.5 * (1.0 - xy[1]) * size.height}, size};
    }

private:
    Formula formula_;
};

StageEntry zoom_row() {
    return {
        .name = "zoom",
        .meaning = "local zoom: magnifies around a point of the picture and keeps the rest visible",
        .formula = R"(
(x′, y′) = c + s d      c = (at₁ W, at₂ H),   d = (x, y) − c
s = 1 − (1 − 1/strength) (1 − q)³ where q < 1, otherwise 1
q = |d|²/(radius H)²
(x, y)   the point in pixels from the top left of a picture of W × H pixels
)",
        .parameters = {{.name = "at",
                        .type = PairParameter{.default_value = std::array{0.5, 0.5}},
                        .meaning = "the point, as a fraction of the picture"},
                       positive_parameter(
                           "radius", 0.3,
                           "radius of the affected region, as a fraction of the height"),
                       positive_parameter("strength", 2.0, "magnification at the centre")},
        .make = maker<ZoomPicture>("at", "radius", "strength"),
        .example = R"(camera under_the_glass {
    arrange zoom(at = (0.4, 0.5), radius = 0.4, strength = 3)
    map     u = 60deg .. -60deg, v = square
    eye     sphere(1)
})"};
}

StageEntry ripple_row() {
    return {.name = "ripple",
            .meaning = "circular waves, like those of a drop on water",
            .formula = R"(
(x′, y′) = c + (r′/r) d      c = (at₁ W, at₂ H),   d = (x, y) − c,   r = |d|
r′ = r + amplitude H sin(2π r/(wavelength H) − phase)
(x, y)   the point in pixels from the top left of a picture of W × H pixels
It folds over where 2π amplitude > wavelength.
)",
            .parameters =
                {number_parameter("amplitude", 0.01,
                                  "amplitude of the waves, as a fraction of the height"),
                 positive_parameter("wavelength", 0.1, "wavelength, as a fraction of the height"),
                 {.name = "at",
                  .type = PairParameter{.default_value = std::array{0.5, 0.5}},
                  .meaning = "centre of the waves, as a fraction of the picture"},
                 angle_parameter(
                     "phase", 0.0,
                     "phase: how far the waves have moved outwards; 360deg is one wavelength")},
            .make = maker<Ripple>("amplitude", "wavelength", "at", "phase"),
            .example = R"(camera in_the_pond {
    arrange ripple(amplitude = 0.01, wavelength = 0.15, phase = t*360deg)
    map     u = 60deg .. -60deg, v = square
    eye     sphere(1)
})"};
}

}  // namespace

std::vector<StageEntry> picture_warps() {
    return {
        zoom_row(),
        ripple_row(),
        {.name = "formula",
         .meaning =
             "a map of the picture: formula(x, y) = [x', y'], from -1 to 1, to the right and up",
         .formula = R"(
(X′, Y′) = [a, b]      X = 2x/W − 1,   Y = 1 − 2y/H,   X′ and Y′ likewise
(x, y)   the point in pixels from the top left of a picture of W × H pixels
)",
         .make = [](const Arguments& a) { return made<PictureFormula>(a.formula()); },
         .shape = FormulaShape{2, 2, 2},
         .example = R"(camera barrel {
    arrange formula(x, y) = [x*(0.8 + 0.1*(x^2 + y^2)), y*(0.8 + 0.1*(x^2 + y^2))]
    map     u = 60deg .. -60deg, v = square
    eye     sphere(1)
})"},
    };
}

}  // namespace balcony::camera
