// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Clip shapes: the visible part of a layer's image.

#include "camera/arrangers/clip_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"
#include "camera/tables/grey_table.hpp"

namespace balcony::camera {

namespace {

/// A point in pixels from the centre of its picture, to the right and up, and half the picture's
/// sides.
struct Centered {
    Expr x, y, half_width, half_height;
};

Centered centered(const PicturePoint& picture) {
    const auto& [point, size] = picture;
    const Expr half_width = 0.5 * size.width;
    const Expr half_height = 0.5 * size.height;
    return {point.x - half_width, half_height - point.y, half_width, half_height};
}

Expr rectangle_distance(const PicturePoint& picture) {
    const Centered c = centered(picture);
    return max(abs(c.x) - c.half_width, abs(c.y) - c.half_height);
}

class Rectangle final : public ClipShape {
public:
    Expr distance(const PicturePoint& picture, Emitter&) const override {
        return rectangle_distance(picture);
    }
    double corner_reach() const override { return 1.0; }
};

/// With k = |(x/a, y/b)| and g = |(x/a^2, y/b^2)|, (k - 1) k / g is the distance to first order: k
/// is 1 on the ellipse and its gradient there is g long. Exact for a circle.
Expr ellipse_distance(const Centered& c, Expr a, Expr b, Emitter& emit) {
    const Expr nx = c.x / a;
    const Expr ny = c.y / b;
    const Expr k = sqrt(nx * nx + ny * ny);
    const Expr g = sqrt(nx * nx / (a * a) + ny * ny / (b * b));
    // At the centre, where both are 0, uses a point slightly to the side.
    const Expr minimum = emit(1e-9);
    return (k - 1.0) * max(k, minimum) / max(g, minimum / a);
}

/// The largest ellipse in the picture.
class Ellipse final : public ClipShape {
public:
    Expr distance(const PicturePoint& picture, Emitter& emit) const override {
        const Centered c = centered(picture);
        return ellipse_distance(c, c.half_width, c.half_height, emit);
    }
    double corner_reach() const override { return 0.5 * std::numbers::sqrt2; }
};

/// The largest ellipse without a smaller, similar one.
class Ring final : public ClipShape {
public:
    explicit Ring(Scalar inner) : inner_(std::move(inner)) {}

    Expr distance(const PicturePoint& picture, Emitter& emit) const override {
        const Centered c = centered(picture);
        const Expr inner = emit(inner_);
        return max(ellipse_distance(c, c.half_width, c.half_height, emit),
                   -ellipse_distance(c, inner * c.half_width, inner * c.half_height, emit));
    }
    double corner_reach() const override { return 0.5 * std::numbers::sqrt2; }

private:
    Scalar inner_;
};

/// A rectangle whose corners are quarter circles.
class RoundedRectangle final : public ClipShape {
public:
    explicit RoundedRectangle(Scalar radius) : radius_(std::move(radius)) {}

    Expr distance(const PicturePoint& picture, Emitter& emit) const override {
        const Centered c = centered(picture);
        const Expr radius = emit(radius_) * 2.0 * min(c.half_width, c.half_height);
        const Expr zero = emit(0.0);
        // Relative to the rectangle whose corners are the centres of the circles.
        const Expr x = abs(c.x) - (c.half_width - radius);
        const Expr y = abs(c.y) - (c.half_height - radius);
        const Expr out_x = max(x, zero);
        const Expr out_y = max(y, zero);
        return sqrt(out_x * out_x + out_y * out_y) + min(max(x, y), zero) - radius;
    }
    double corner_reach() const override { return 0.5 * std::numbers::sqrt2; }

private:
    Scalar radius_;
};

/// The inside of a polygon, by the even-odd rule. The distance is that to the
/// nearest side.
class Polygon final : public ClipShape {
public:
    explicit Polygon(PointList corners) : corners_(std::move(corners)) {}

    Expr distance(const PicturePoint& picture, Emitter& emit) const override {
        Expr nearest;
        Expr outside = emit(1.0);
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            const Side side = relative(i, picture);
            const Expr along = side.x * side.to_x + side.y * side.to_y;
            const Expr squared_length = side.to_x * side.to_x + side.to_y * side.to_y;
            const Expr share = min(max(along / squared_length, emit(0.0)), emit(1.0));
            const Expr dx = side.x - share * side.to_x;
            const Expr dy = side.y - share * side.to_y;
            const Expr squared = dx * dx + dy * dy;
            nearest = nearest.valid() ? min(nearest, squared) : squared;

            // A ray to the right crosses the side if its ends are above and below, and the point is
            // to its left.
            const Expr above = side.y < 0.0;
            const Expr end_above = side.y < side.to_y;
            const Expr turn = side.x * side.to_y - side.y * side.to_x;
            const Expr meets =
                (above && !end_above && 0.0 < turn) || (!above && end_above && turn < 0.0);
            outside = select(meets, -outside, outside);
        }
        return outside * sqrt(nearest);
    }

private:
    // The point relative to one corner, and the next corner relative to that one, in pixels.
    struct Side {
        Expr x, y, to_x, to_y;
    };

    [[nodiscard]] Side relative(std::size_t i, const PicturePoint& picture) const {
        const auto first = corners_[i];
        const auto second = corners_[(i + 1) % corners_.size()];
        const auto& [point, size] = picture;
        return {point.x - first[0] * size.width, point.y - first[1] * size.height,
                (second[0] - first[0]) * size.width, (second[1] - first[1]) * size.height};
    }

    PointList corners_;  // Fractions of the picture from its top left corner.
};

/// The tips of a star on the largest ellipse, the first at the top, and the corners between them on
/// a smaller one.
PointList star_corners(std::size_t tips, double inner) {
    PointList corners{2, {}};
    for (std::size_t i = 0; i < 2 * tips; ++i) {
        const double angle = std::numbers::pi * static_cast<double>(i) / static_cast<double>(tips);
        const double radius = i % 2 == 0 ? 0.5 : 0.5 * inner;
        corners.values.push_back(0.5 + radius * std::sin(angle));
        corners.values.push_back(0.5 - radius * std::cos(angle));
    }
    return corners;
}

/// Where a formula of (x, y) is above 0; both run from -1 to 1, to the right and up.
class ClipFormula final : public ClipShape {
public:
    explicit ClipFormula(Formula formula) : formula_(std::move(formula)) {}

    Expr distance(const PicturePoint& picture, Emitter& emit) const override {
        Graph& graph = emit.graph();
        const std::array free{graph.fresh_variable(), graph.fresh_variable()};
        const Expr f = formula_.emit(graph, free).front();
        const std::array made{f, expr::differentiate(f, free[0]), expr::differentiate(f, free[1])};
        const Centered c = centered(picture);
        const std::array put{expr::Substitution{free[0], c.x / c.half_width},
                             expr::Substitution{free[1], c.y / c.half_height}};
        const std::vector<Expr> there = expr::substitute(graph, made, put);
        const Expr by_x = there[1] / c.half_width;
        const Expr by_y = there[2] / c.half_height;
        const Expr slope = max(sqrt(by_x * by_x + by_y * by_y), emit(1e-30));
        const Expr far = c.half_width + c.half_height;
        const Expr distance = select(is_finite(slope), -there[0] / slope, -far * sign(there[0]));
        return max(select(is_finite(there[0]), distance, far), rectangle_distance(picture));
    }

private:
    Formula formula_;
};

/// A grey image stretched over the layer's image: white is visible, black is not, grey partly.
class ImageMask final : public ClipShape {
public:
    explicit ImageMask(std::shared_ptr<const expr::Table> grey) : grey_(std::move(grey)) {}

    // The distance from the contour of half grey, by the gradient.
    Expr distance(const PicturePoint& picture, Emitter& emit) const override {
        Graph& graph = emit.graph();
        const std::array free{graph.fresh_variable(), graph.fresh_variable()};
        const Expr grey = value({{free[0], free[1]}, picture.size});
        const std::array made{0.5 - grey, expr::differentiate(grey, free[0]),
                              expr::differentiate(grey, free[1])};
        const std::array put{expr::Substitution{free[0], picture.point.x},
                             expr::Substitution{free[1], picture.point.y}};
        const std::vector<Expr> there = expr::substitute(graph, made, put);
        const Expr slope = sqrt(there[1] * there[1] + there[2] * there[2]);
        return max(there[0] / max(slope, emit(1e-30)), rectangle_distance(picture));
    }

    Expr coverage(const PicturePoint& picture, Expr, Emitter& emit) const override {
        return select(rectangle_distance(picture) <= 0.0, value(picture), emit(0.0));
    }

private:
    [[nodiscard]] Expr value(const PicturePoint& picture) const {
        const auto& [point, size] = picture;
        return grey_at(grey_, point.x / size.width, point.y / size.height);
    }

    std::shared_ptr<const expr::Table> grey_;
};

StageResult make_polygon(const Arguments& a) {
    const PointList& corners = a.points("points");
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto here = corners[i];
        const auto next = corners[(i + 1) % corners.size()];
        if (here[0] == next[0] && here[1] == next[1]) {
            return error(
                "two neighbouring corners of this polygon coincide", {},
                "remove one of them; the last corner is connected to the first automatically");
        }
    }
    constexpr std::size_t max_corners = 256;
    if (corners.size() > max_corners) {
        return error("this polygon has more than 256 corners", {},
                     "remove some, or draw the shape and use the clip image");
    }
    return made<Polygon>(corners);
}

// The examples are pictures of one camera with this clip.
constexpr std::string_view rectangle_example = R"(picture framed {
    layer panorama { place (0.1, 0.1) .. (0.9, 0.9)  fill  clip rectangle  frame(width = 0.01) }
})";
constexpr std::string_view ellipse_example = R"(picture oval {
    layer panorama { place (0.05, 0.05) .. (0.95, 0.95)  fill  clip ellipse  soft 0.1 }
})";
constexpr std::string_view ring_example = R"(picture wreath {
    aspect 1
    layer  panorama { fill  clip ring(0.5)  frame }
})";
constexpr std::string_view rounded_example = R"(picture card {
    layer panorama { place (0.05, 0.05) .. (0.95, 0.95)  fill  clip rounded(0.2)  frame(width = 0.01) }
})";
constexpr std::string_view polygon_example = R"(picture house {
    layer panorama { fill  clip polygon([(0.5, 0.05), (0.95, 0.4), (0.85, 0.95), (0.15, 0.95), (0.05, 0.4)])  frame }
})";
constexpr std::string_view star_example = R"(picture star {
    aspect 1
    layer  panorama { fill  clip star(5, inner = 0.5)  frame }
})";
constexpr std::string_view formula_example = R"(picture heart {
    aspect 1
    layer  panorama { fill  clip formula(x, y) = [0.8 - x^2 - (1.2*y - sqrt(abs(x)) + 0.2)^2]  frame }
})";
constexpr std::string_view image_example = R"(picture masked {
    aspect 4/3
    layer  panorama { fill  clip image("mask.png") }
})";

// Clip shapes with a formula for their edge.
std::vector<StageEntry> round_shapes() {
    return {
        {.name = "rectangle",
         .meaning = "the whole window of the layer",
         .formula = R"(
|X| ≤ W/2 and |Y| ≤ H/2
X = x − W/2,   Y = H/2 − y for the point (x, y) of an image of W × H pixels
)",
         .make = [](const Arguments&) { return made<Rectangle>(); },
         .example = rectangle_example},
        {.name = "ellipse",
         .meaning = "the largest ellipse in the layer's image",
         .formula = R"(
(2X/W)² + (2Y/H)² ≤ 1
X = x − W/2,   Y = H/2 − y for the point (x, y) of an image of W × H pixels
)",
         .make = [](const Arguments&) { return made<Ellipse>(); },
         .example = ellipse_example},
        {.name = "ring",
         .meaning = "the largest ellipse in the layer's image, with a hole",
         .formula = R"(
inner² ≤ (2X/W)² + (2Y/H)² ≤ 1
X = x − W/2,   Y = H/2 − y for the point (x, y) of an image of W × H pixels
)",
         .parameters = {number_parameter(
             "inner", 0.5, "size of the hole, relative to the ellipse",
             {.minimum = 0.0, .maximum = 1.0, .excludes_minimum = true})},
         .make = maker<Ring>("inner"),
         .example = ring_example},
        {.name = "rounded",
         .meaning = "a rectangle with rounded corners",
         .formula = R"(
|X| ≤ W/2, |Y| ≤ H/2 and, in the corners, |(|X| − W/2 + R, |Y| − H/2 + R)| ≤ R
R = radius min(W, H)
X = x − W/2,   Y = H/2 − y for the point (x, y) of an image of W × H pixels
)",
         .parameters = {number_parameter("radius", 0.1,
                                         "radius of the corners, as a fraction of the shorter side",
                                         {.minimum = 0.0, .maximum = 0.5})},
         .make = maker<RoundedRectangle>("radius"),
         .example = rounded_example},
    };
}

}  // namespace

ClipShapePointer whole_rectangle() {
    static const ClipShapePointer rectangle = std::make_shared<const Rectangle>();
    return rectangle;
}

std::vector<StageEntry> clip_shapes() {
    std::vector<StageEntry> rows = round_shapes();
    rows.push_back(
        {.name = "polygon",
         .meaning = "the inside of a polygon, by the even-odd rule",
         .formula = R"(
The ray from the point to the right crosses an odd number of sides.
corners (a W, b H) from the top left, the last connected to the first
)",
         .parameters = {{.name = "points",
                         .type = PointsParameter{.coordinates = {2}, .min_points = 3},
                         .meaning =
                             "corners, as fractions of the layer's image from its top left"}},
         .make = make_polygon,
         .example = polygon_example});
    rows.push_back(
        {.name = "star",
         .meaning = "a star, with one tip at the top",
         .formula = R"(
The polygon with the corners k = 0 … 2 points − 1 at (X, Y) =
(W/2 · r sin φ, H/2 · r cos φ),   φ = k 180°/points
r = 1 for even k, otherwise inner
X = x − W/2,   Y = H/2 − y for the point (x, y) of an image of W × H pixels
)",
         .parameters = {{.name = "points",
                         .type = CountParameter{.default_value = 5.0,
                                                .range = {.minimum = 2.0, .maximum = 100.0}},
                         .meaning = "number of tips"},
                        {.name = "inner",
                         .type = NumberParameter{.default_value = 0.382,
                                                 .range = {.minimum = 0.0,
                                                           .maximum = 1.0,
                                                           .excludes_minimum = true},
                                                 .constant = true},
                         .meaning = "distance of the inner corners from the centre, as a fraction "
                                    "of the distance of the tips"}},
         .make =
             [](const Arguments& a) {
                 return made<Polygon>(star_corners(a.count("points"), a.constant("inner")));
             },
         .example = star_example});
    rows.push_back(
        {.name = "formula",
         .meaning = "where a formula is above 0: formula(x, y) = [f], x and y from -1 to 1, to the "
                    "right and up",
         .formula = R"(
f(2X/W, 2Y/H) > 0
X = x − W/2,   Y = H/2 − y for the point (x, y) of an image of W × H pixels
)",
         .make = [](const Arguments& a) { return made<ClipFormula>(a.formula()); },
         .shape = FormulaShape{2, 1, 1},
         .example = formula_example});
    rows.push_back({.name = "image",
                    .meaning = "a grey image as a mask: white is visible, black is not",
                    .formula = R"(
coverage = g, or 1 − g if inverted
g   the grey value of the image, bilinear between the centres of its pixels
)",
                    .parameters = {{.name = "file",
                                    .type = ImageParameter{},
                                    .meaning = "image file, stretched over the layer's image"},
                                   choice_parameter("invert", {"no", "yes"},
                                                    "whether black is visible instead of white")},
                    .make =
                        [](const Arguments& a) {
                            return made<ImageMask>(grey_table(*a.file<GreyImage>("file"),
                                                              a.choice("invert") == "yes"));
                        },
                    .example = image_example});
    return rows;
}

}  // namespace balcony::camera
