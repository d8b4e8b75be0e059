// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Affine picture arrangers, DCS → DCS: place, shift, scale, rotate, mirror. Fractions of a picture
// are measured from its top left corner to the right and down.

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

namespace {

/// The whole image of the camera in a rectangle of the picture, given by its corners as
/// fractions.
class Place final : public PictureArranger {
public:
    Place(Pair from, Pair to) : from_(std::move(from)), to_(std::move(to)) {}

    PicturePoint arrange(const PicturePoint& picture, Emitter& emit) const override {
        const auto& [point, size] = picture;
        const Expr x = point.x - emit(from_[0]) * size.width;
        const Expr y = point.y - emit(from_[1]) * size.height;
        const Expr width = (emit(to_[0]) - emit(from_[0])) * size.width;
        const Expr height = (emit(to_[1]) - emit(from_[1])) * size.height;
        return {{x, y}, {width, height}};
    }

private:
    Pair from_, to_;
};

/// Moves the picture by fractions of itself.
class Shift final : public PictureArranger {
public:
    explicit Shift(Pair by) : by_(std::move(by)) {}

    PicturePoint arrange(const PicturePoint& picture, Emitter& emit) const override {
        const auto& [point, size] = picture;
        return {{point.x - emit(by_[0]) * size.width, point.y - emit(by_[1]) * size.height}, size};
    }

private:
    Pair by_;
};

/// Scales the picture about a fixed point.
class ScalePicture final : public PictureArranger {
public:
    ScalePicture(Pair by, Pair at) : by_(std::move(by)), at_(std::move(at)) {}

    PicturePoint arrange(const PicturePoint& picture, Emitter& emit) const override {
        const auto& [point, size] = picture;
        const Expr width = emit(by_[0]) * size.width;
        const Expr height = emit(by_[1]) * size.height;
        return {{point.x - emit(at_[0]) * (size.width - width),
                 point.y - emit(at_[1]) * (size.height - height)},
                {width, height}};
    }

private:
    Pair by_, at_;
};

/// Rotates the picture counter-clockwise as seen; y points down here.
class RotatePicture final : public PictureArranger {
public:
    RotatePicture(Scalar angle, Pair at) : angle_(std::move(angle)), at_(std::move(at)) {}

    PicturePoint arrange(const PicturePoint& picture, Emitter& emit) const override {
        const auto& [point, size] = picture;
        const Expr center_x = emit(at_[0]) * size.width;
        const Expr center_y = emit(at_[1]) * size.height;
        const Expr x = point.x - center_x;
        const Expr y = point.y - center_y;
        const Expr c = cos(emit(angle_));
        const Expr s = sin(emit(angle_));
        return {{center_x + c * x - s * y, center_y + s * x + c * y}, size};
    }

private:
    Scalar angle_;
    Pair at_;
};

/// Swaps left and right, or top and bottom.
class Mirror final : public PictureArranger {
public:
    explicit Mirror(bool left_and_right) : left_and_right_(left_and_right) {}

    PicturePoint arrange(const PicturePoint& picture, Emitter&) const override {
        const auto& [point, size] = picture;
        return left_and_right_ ? PicturePoint{{size.width - point.x, point.y}, size}
                               : PicturePoint{{point.x, size.height - point.y}, size};
    }

private:
    bool left_and_right_;
};

StageParameter fixed_point(std::string_view meaning) {
    return {.name = "at",
            .type = PairParameter{.default_value = std::array{0.5, 0.5}},
            .meaning = meaning};
}

StageEntry place_row() {
    return {.name = "place",
            .meaning = "places the camera's image in a part of the picture",
            .formula = R"(
(x′, y′) = (x − from₁ W, y − from₂ H)
(W′, H′) = ((to₁ − from₁) W, (to₂ − from₂) H)
(x, y), (x′, y′)   the point in the picture and in the image that it shows,
                   in pixels from the top left, of W × H and W′ × H′ pixels
)",
            .parameters = {{.name = "from",
                            .type = PairParameter{.default_value = std::array{0.0, 0.0}},
                            .meaning = "top left corner, as a fraction of the picture"},
                           {.name = "to",
                            .type = PairParameter{.default_value = std::array{1.0, 1.0}},
                            .meaning = "bottom right corner, as a fraction of the picture"}},
            .make = [](const Arguments& a) -> StageResult {
                const auto from = a.pair("from");
                const auto to = a.pair("to");
                for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
                    const auto first = from[i].constant();
                    const auto last = to[i].constant();
                    if (first && last && *last <= *first) {
                        return error("this rectangle has no area", {},
                                     "'from' is its top left corner, 'to' its bottom right corner");
                    }
                }
                return made<Place>(from, to);
            },
            .example = R"(camera half {
    place (0.05, 0.1) .. (0.8, 0.9)
    map   u = 60deg .. -60deg, v = square
    eye   sphere(1)
})"};
}

}  // namespace

std::vector<StageEntry> picture_affine() {
    return {
        place_row(),
        {.name = "shift",
         .meaning = "shifts the image",
         .formula = R"(
(x′, y′) = (x − by₁ W, y − by₂ H)
(x, y)   the point in pixels from the top left of a picture of W × H pixels
)",
         .parameters = {{.name = "by",
                         .type = PairParameter{},
                         .meaning = "offset to the right and down, as a fraction of the picture"}},
         .make = maker<Shift>("by"),
         .example = R"(camera shifted {
    arrange shift((0.2, 0.1))
    map     u = 60deg .. -60deg, v = square
    eye     sphere(1)
})"},
        {.name = "scale",
         .meaning = "scales the image",
         .formula = R"(
(x′, y′) = (x − at₁ (W − W′), y − at₂ (H − H′))
(W′, H′) = (by₁ W, by₂ H)
(x, y), (x′, y′)   as for place
)",
         .parameters = {{.name = "by",
                         .type = PairParameter{.range = {.minimum = 0.0, .excludes_minimum = true},
                                               .one_for_both = true},
                         .meaning = "factors for width and height; below 1 reduces the image"},
                        fixed_point("the fixed point, as a fraction of the picture")},
         .make = maker<ScalePicture>("by", "at"),
         .example = R"(camera smaller {
    arrange scale(0.8, at = (1, 0.5))
    map     u = 60deg .. -60deg, v = square
    eye     sphere(1)
})"},
        {.name = "rotate",
         .meaning = "rotates the image",
         .formula = R"(
x′ = c₁ + (x − c₁) cos angle − (y − c₂) sin angle
y′ = c₂ + (x − c₁) sin angle + (y − c₂) cos angle      c = (at₁ W, at₂ H)
(x, y)   the point in pixels from the top left of a picture of W × H pixels
y points down, so the image turns counter-clockwise.
)",
         .parameters = {{.name = "angle",
                         .type = NumberParameter{.unit = Unit::angle},
                         .meaning = "angle, counter-clockwise"},
                        fixed_point("the fixed point, as a fraction of the picture")},
         .make = maker<RotatePicture>("angle", "at"),
         .example = R"(camera turned {
    arrange scale(0.8), rotate(10deg)
    map     u = 60deg .. -60deg, v = square
    eye     sphere(1)
})"},
        {.name = "mirror",
         .meaning = "mirrors the image",
         .formula = R"(
x:  (x′, y′) = (W − x, y)        y:  (x′, y′) = (x, H − y)
(x, y)   the point in pixels from the top left of a picture of W × H pixels
)",
         .parameters = {choice_parameter("axis", {"x", "y"},
                                         "x exchanges left and right, y exchanges top and bottom")},
         .make = [](const Arguments& a) { return made<Mirror>(a.choice("axis") == "x"); },
         .example = R"(camera in_the_mirror {
    arrange mirror(x)
    map     u = 60deg .. -60deg, v = square
    eye     sphere(1)
})"},
    };
}

}  // namespace balcony::camera
