// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// getDirVec from one object: the normal of the eye object, on one side for the whole surface; and
// the normal of a curve in its own plane.

#include <algorithm>
#include <cmath>
#include <optional>

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

namespace {

/// The part of the surface in a cell of a grid over the picture, to first order.
struct SurfaceElement {
    std::array<double, 3> point{};
    std::array<double, 3> area{};  ///< Along the one-sided normal; its length is the area.
};

constexpr int cells = 16;  // of the grid, in width and in height

/// The camera's own image at time 0, without points that have no ray. Elements belong to
/// cells of equal size.
std::vector<SurfaceElement> elements_in_picture(const PathPoint& eye, const Emitter& emit) {
    Graph& graph = emit.graph();
    const std::array parameters{eye.parameters.u, eye.parameters.v};
    const std::vector<Expr> by_x = expr::differentiate(parameters, graph.picture_x());
    const std::vector<Expr> by_y = expr::differentiate(parameters, graph.picture_y());
    const Expr parameter_area = abs(by_x[0] * by_y[1] - by_x[1] * by_y[0]);
    const ObjectVector spanned = cross(eye.along_u, eye.along_v);
    const Expr scale = parameter_area * sqrt(dot(spanned, spanned) / dot(eye.normal, eye.normal));
    const ObjectVector area = scale * eye.one_sided_normal;

    const std::array extent{eye.size.width, eye.size.height};
    const std::array roots{eye.point.x, eye.point.y, eye.point.z, area.x,
                           area.y,      area.z,      emit.valid()};
    const std::vector<double> size = emit.trial(extent, 0.0, 0.0);
    std::vector<SurfaceElement> elements;
    for (int i = 0; i < cells * cells; ++i) {
        const double x = (i % cells + 0.5) / cells * size[0];
        const double y = (i / cells + 0.5) / cells * size[1];
        const std::vector<double> r = emit.trial(roots, x, y);
        if (std::all_of(r.begin(), r.end(), [](double value) { return std::isfinite(value); }) &&
            r.back() != 0.0) {
            elements.push_back({{r[0], r[1], r[2]}, {r[3], r[4], r[5]}});
        }
    }
    return elements;
}

double length(const std::array<double, 3>& a) { return std::hypot(a[0], a[1], a[2]); }

/// The side of the normals: 1 if they point outwards, -1 inwards, 0 if the surface has no outside.
/// The sum of area . (point - centre) is three times the volume of a closed surface if they point
/// outwards (Gauss), and positive on the convex side of an open one. It is 0 for a plane.
int side_of_normals(const std::vector<SurfaceElement>& elements) {
    double whole = 0.0;
    std::array<double, 3> middle{};
    for (const SurfaceElement& element : elements) {
        const double area = length(element.area);
        whole += area;
        for (std::size_t k = 0; k < 3; ++k) {
            middle[k] += area * element.point[k];
        }
    }
    double flux = 0.0;
    double largest = 0.0;
    for (const SurfaceElement& element : elements) {
        std::array<double, 3> offset{};
        for (std::size_t k = 0; k < 3; ++k) {
            offset[k] = element.point[k] - middle[k] / whole;
            flux += element.area[k] * offset[k];
        }
        largest += length(element.area) * length(offset);
    }
    constexpr double rounding = 1e-9;
    return flux < -rounding * largest ? -1 : flux > rounding * largest ? 1 : 0;
}

/// A piece of a curve, to first order.
struct CurveElement {
    ObjectPoint point;
    ObjectVector step;  ///< Along increasing u; 0 where the curve has no ray.
};

constexpr int pieces = 32;  // of each diagonal of the picture

/// The pieces of the curve that the camera's own image shows, at any time: along both diagonals,
/// since u may be constant on one.
std::vector<CurveElement> elements_along_picture(const PathPoint& eye, const Emitter& emit) {
    Graph& graph = emit.graph();
    const Expr x = graph.picture_x();
    const Expr y = graph.picture_y();
    const Expr by_x = expr::differentiate(eye.parameters.u, x) * eye.size.width;
    const Expr by_y = expr::differentiate(eye.parameters.u, y) * eye.size.height;
    std::vector<CurveElement> elements;
    for (const bool rising : {false, true}) {
        const Expr u_step = abs(rising ? by_x - by_y : by_x + by_y) / pieces;
        const ObjectVector step = u_step * eye.along_u;
        const Expr is_there = emit.valid() && is_finite(eye.point.x + eye.point.y + eye.point.z) &&
                              is_finite(step.x + step.y + step.z);
        std::vector<Expr> roots{eye.point.x, eye.point.y, eye.point.z, step.x, step.y, step.z};
        for (Expr& root : roots) {
            root = select(is_there, root, emit(0.0));
        }
        for (int i = 0; i < pieces; ++i) {
            const double part = (i + 0.5) / pieces;
            const std::array put{
                expr::Substitution{x, part * eye.size.width},
                expr::Substitution{y, (rising ? 1.0 - part : part) * eye.size.height}};
            const std::vector<Expr> r = expr::substitute(graph, roots, put);
            elements.push_back({{r[0], r[1], r[2]}, {r[3], r[4], r[5]}});
        }
    }
    return elements;
}

/// The vector about which a curve runs counter-clockwise, seen from its tip: twice the area that
/// the curve encloses with its centre. Without a value the curve is straight, at time 0.
std::optional<ObjectVector> area_of(const std::vector<CurveElement>& elements, Emitter& emit) {
    const ObjectPoint origin{emit(0.0), emit(0.0), emit(0.0)};
    ObjectVector middle = origin - origin;
    Expr whole = emit(0.0);
    for (const CurveElement& element : elements) {
        const Expr step = sqrt(dot(element.step, element.step));
        middle = middle + step * (element.point - origin);
        whole = whole + step;
    }
    middle = (1.0 / whole) * middle;
    ObjectVector area = origin - origin;
    Expr largest = emit(0.0);
    for (const CurveElement& element : elements) {
        const ObjectVector arm = element.point - (origin + middle);
        area = area + cross(arm, element.step);
        largest = largest + sqrt(dot(arm, arm) * dot(element.step, element.step));
    }
    const std::array sizes{sqrt(dot(area, area)), largest};
    const std::vector<double> known = emit.trial(sizes, 0.0, 0.0);
    constexpr double rounding = 1e-9;
    return known[0] > rounding * known[1] ? std::optional(area) : std::nullopt;
}

/// One object gives origins and directions: the normal is the cross product of its tangents, unless
/// the object has normals of its own.
class NormalRule final : public DirectionRule {
public:
    enum class Side : std::uint8_t { front, back, outward, inward };
    explicit NormalRule(Side side) : side_(side) {}
    int min_eye_dimension() const override {
        return side_ == Side::outward || side_ == Side::inward ? 1 : 2;
    }
    ObjectVector direction(const PathPoint& eye, const PathPoint*, Emitter& emit) const override {
        if (side_ == Side::front || side_ == Side::back) {
            return side_ == Side::back ? -eye.normal : eye.normal;
        }
        const bool is_curve = eye.along_v.x.is_constant(0.0) && eye.along_v.y.is_constant(0.0) &&
                              eye.along_v.z.is_constant(0.0);
        const ObjectVector out =
            is_curve ? outward_of_curve(eye, emit) : outward_of_surface(eye, emit);
        return side_ == Side::outward ? out : -out;
    }

private:
    static ObjectVector outward_of_surface(const PathPoint& eye, Emitter& emit) {
        const int side = side_of_normals(elements_in_picture(eye, emit));
        if (side == 0) {
            emit.report(warning(
                "a flat surface has no outside: 'outward' is its front and 'inward' its back", {},
                "write: look normal(front), or look normal(back)"));
        }
        return side < 0 ? -eye.one_sided_normal : eye.one_sided_normal;
    }

    /// In the plane of the curve, at right angles to it.
    static ObjectVector outward_of_curve(const PathPoint& eye, Emitter& emit) {
        const auto area = area_of(elements_along_picture(eye, emit), emit);
        if (!area) {
            emit.report(error("a straight line has no outside", {},
                              "write: look sideways, or give a vector: look along(x)"));
        }
        return area ? cross(eye.along_u, *area) : eye.along_u;
    }

    Side side_;
};

NormalRule::Side side_of(std::string_view name) {
    using enum NormalRule::Side;
    return name == "front" ? front : name == "back" ? back : name == "outward" ? outward : inward;
}

}  // namespace

std::vector<StageEntry> normal_rule() {
    return {
        {.name = "normal",
         .meaning = "along the normals of the eye object",
         .formula = R"(
surface   d = ±n,  n = ∂p/∂u × ∂p/∂v, or the object's own normal
curve     d = ±c′(u) × A,  A = ∫ (c − m) × c′ du
          over the visible part of the curve, with its centre m
outward   the sign with ∫ n·(p − m) dA > 0 for a surface, + for a curve
)",
         .parameters = {choice_parameter(
             "side", {"front", "back", "outward", "inward"},
             "front: the side of the cross product of the tangents along u and v, unless the "
             "object specifies otherwise; back: the opposite; outward: the convex side of "
             "the visible part of the surface, also beyond a pole, where the front is on the "
             "other side, or of a curve, in its plane; inward: the opposite of outward; a "
             "flat surface has no outside")},
         .make = [](const Arguments& a) { return made<NormalRule>(side_of(a.choice("side"))); },
         .example = R"(
// A room seen from inside a glass bowl: outwards in all directions, for any parametrisation.
camera bowl {
    map  u = 180deg .. -180deg, v = 0.3 .. 1.5
    eye  paraboloid(2, 2)
    look normal(outward)
}
)"},
    };
}

}  // namespace balcony::camera
