// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object generators, PCS → OCS: surfaces that pictures are projected on, by lengths along them.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"
#include "camera/objects/ray_targets.hpp"
#include "camera/objects/vector3.hpp"

namespace balcony::camera {

namespace {

// ----------------------------------------------------------------------------------------- wall

class Wall final : public ObjectGenerator {
public:
    /// The sides start at the corner and are not parallel.
    Wall(const Vector3& corner, const Vector3& bottom, const Vector3& left)
        : corner_(corner), bottom_(bottom), left_(left) {}
    int dimension() const override { return 2; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        const Expr s = p.u / length(bottom_);
        const Expr t = p.v / length(left_);
        const auto coordinate = [&](std::size_t k) {
            return emit(corner_[k]) + s * bottom_[k] + t * left_[k];
        };
        return {coordinate(0), coordinate(1), coordinate(2)};
    }
    std::optional<ParameterRectangle> own_picture() const override {
        return ParameterRectangle{0.0, length(bottom_), 0.0, length(left_)};
    }
    std::shared_ptr<const RayTarget> ray_target() const override {
        return parallelogram_target(corner_, bottom_, left_);
    }

private:
    Vector3 corner_, bottom_, left_;
};

Vector3 wall_corner(const Arguments& a, std::string_view name) {
    const Triple t = a.triple(name);
    return {t[0].constant().value(), t[1].constant().value(), t[2].constant().value()};
}

std::string text_of_point(const Vector3& a) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", a[0], a[1], a[2]);
}

// What a tape measure leaves open is half a degree, or half a percent of a diagonal.
constexpr double max_wall_angle = 0.5 * std::numbers::pi / 180.0;
constexpr double max_wall_share = 0.005;

Diagnostics unfit_wall(const Vector3& corner, const Vector3& bottom, const Vector3& left) {
    const double area = length(cross(bottom, left));
    if (!(area > 1e-9 * (dot(bottom, bottom) + dot(left, left)))) {
        return {error("the corners of the wall are in one line and span no plane", {},
                      "give the lower left, the lower right and the upper left corner, each "
                      "(x, y, z)")};
    }
    const double angle = std::atan2(area, dot(bottom, left));
    if (std::abs(angle - 0.5 * std::numbers::pi) > max_wall_angle) {
        return {error(fmt::format("the corners of the wall are not those of a rectangle: the angle "
                                  "at {} is {:.1f} degrees",
                                  text_of_point(corner), angle * 180.0 / std::numbers::pi),
                      {},
                      "give the lower left, the lower right and the upper left corner, in "
                      "this order, as the viewer sees them")};
    }
    return {};
}

Diagnostics unfit_fourth(const Vector3& corner, const Vector3& bottom, const Vector3& left,
                         const Vector3& fourth) {
    const Vector3 n = cross(bottom, left);
    const double diagonal = length(sum(bottom, left));
    const Vector3 diagonally = difference(fourth, corner);
    const double off = std::abs(dot(n, diagonally)) / length(n);
    if (!(off <= max_wall_share * diagonal)) {
        return {error(fmt::format("the corners of the wall are not in a plane: {} is {:.3g} away "
                                  "from the plane of the other three",
                                  text_of_point(fourth), off),
                      {}, "measure the corners again; a bent wall is two walls")};
    }
    const Vector3 wanted = sum(corner, sum(bottom, left));
    if (!(length(difference(fourth, wanted)) <= max_wall_share * diagonal)) {
        return {error(fmt::format("the corners of the wall are not those of a rectangle, whose "
                                  "upper right corner would be {}, not {}",
                                  text_of_point(wanted), text_of_point(fourth)),
                      {}, "measure the corners again, or leave out upper_right")};
    }
    return {};
}

StageResult make_wall(const Arguments& a) {
    const Vector3 corner = wall_corner(a, "lower_left");
    const Vector3 bottom = difference(wall_corner(a, "lower_right"), corner);
    const Vector3 left = difference(wall_corner(a, "upper_left"), corner);
    Diagnostics problems = unfit_wall(corner, bottom, left);
    if (problems.empty() && a.has("upper_right")) {
        problems = unfit_fourth(corner, bottom, left, wall_corner(a, "upper_right"));
    }
    if (!problems.empty()) {
        return problems;
    }
    return made<Wall>(corner, bottom, left);
}

// -------------------------------------------------------------------------------- folded screen

class FoldedScreen final : public ObjectGenerator {
public:
    /// No two neighbouring points are equal.
    explicit FoldedScreen(PointList points) : points_(std::move(points)) {}
    int dimension() const override { return 2; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        double begin = 0.0;
        Expr x = emit(points_[0][0]);
        Expr y = emit(points_[0][1]);
        for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
            const std::span<const double> a = points_[i], b = points_[i + 1];
            const double width = std::hypot(b[0] - a[0], b[1] - a[1]);
            const Expr here = begin <= p.u;
            const Expr along = (p.u - begin) / width;
            x = select(here, a[0] + (b[0] - a[0]) * along, x);
            y = select(here, a[1] + (b[1] - a[1]) * along, y);
            begin += width;
        }
        emit.require(0.0 <= p.u && p.u <= begin);
        return {x, y, p.v};
    }
    std::shared_ptr<const RayTarget> ray_target() const override { return panels_target(points_); }

private:
    PointList points_;
};

StageResult make_folded_screen(const Arguments& a) {
    const PointList& points = a.points("points");
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        if (points[i][0] == points[i + 1][0] && points[i][1] == points[i + 1][1]) {
            return error(
                fmt::format("the points {} and {} of the folded screen are equal", i + 1, i + 2),
                {}, "remove one; a panel needs a width");
        }
    }
    return made<FoldedScreen>(points);
}

StageParameter corner_parameter(std::string_view name, const Vector3& value,
                                std::string_view meaning) {
    return {.name = name,
            .type = TripleParameter{.default_value = value, .constant = true},
            .meaning = meaning};
}

}  // namespace

std::vector<StageEntry> screens() {
    return {
        {.name = "wall",
         .meaning = "a rectangle by its corners, such as a projection wall, by lengths along its "
                    "edges",
         .formula = R"(
p = lower_left + u (lower_right − lower_left)/w + v (upper_left − lower_left)/h
w = |lower_right − lower_left|,   h = |upper_left − lower_left|
own picture: u from 0 to w, v from 0 to h
)",
         .parameters = {corner_parameter("lower_left", {1.5, 1.5, 0.0},
                                         "corner (x, y, z), as the viewer sees the wall"),
                        corner_parameter("lower_right", {1.5, -1.5, 0.0}, "corner (x, y, z)"),
                        corner_parameter("upper_left", {1.5, 1.5, 3.0}, "corner (x, y, z)"),
                        {.name = "upper_right",
                         .type = TripleParameter{.constant = true},
                         .optional = true,
                         .meaning = "the fourth corner, if it was measured too: a check"}},
         .make = make_wall,
         .dimension = 2,
         .example = R"(
// A wall to the right, seen from a head in front of it; the picture has the shape of the wall.
camera wall_of_a_cave {
    eye    point(0, 0, 1.6)
    toward wall((1.5, -1.5, 0), (-1.5, -1.5, 0), (1.5, -1.5, 2.4))
}
)"},
        {.name = "folded_screen",
         .meaning = "vertical panels along a polyline, by the length u along them and the height v",
         .formula = R"(
p = (x, y, v) with (x, y) at the length u along the polyline
no ray beyond its ends
)",
         .parameters = {{.name = "points",
                         .type = PointsParameter{.coordinates = {2}, .min_points = 2},
                         .meaning = "the points (x, y) where the panels begin and end"}},
         .make = make_folded_screen,
         .dimension = 2,
         .example = R"(
// A bay window: looks through each of its three panes at right angles.
camera bay_window {
    map  u = 0 .. 6, v = 0 .. 2
    eye  folded_screen([(0, 3), (1, 1), (1, -1), (0, -3)])
    look normal(side = back)
}
)"},
    };
}

}  // namespace balcony::camera
