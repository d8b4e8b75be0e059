// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// getDirVec from one object: the normal of the eye object, on one side for the
// whole surface.

#include <algorithm>
#include <cmath>

#include "camera/families.hpp"

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

/// Whether the normals point inwards: the sum of area . (point - centre) is three times the volume
/// of a closed surface if they point outwards (Gauss), and positive on the convex side of an open
/// one. It is 0 for a plane, which has no outside.
bool point_inwards(const std::vector<SurfaceElement>& elements) {
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
    return flux < -rounding * largest;
}

/// One object gives origins and directions: the normal is the cross product of its tangents, unless
/// the object has normals of its own.
class NormalRule final : public DirectionRule {
public:
    enum class Side : std::uint8_t { front, back, outward, inward };
    explicit NormalRule(Side side) : side_(side) {}
    int min_eye_dimension() const override { return 2; }
    ObjectVector direction(const PathPoint& eye, const PathPoint*, Emitter& emit) const override {
        if (side_ == Side::front || side_ == Side::back) {
            return side_ == Side::back ? -eye.normal : eye.normal;
        }
        const bool against =
            point_inwards(elements_in_picture(eye, emit)) == (side_ == Side::outward);
        return against ? -eye.one_sided_normal : eye.one_sided_normal;
    }

private:
    Side side_;
};

NormalRule::Side side_of(std::string_view name) {
    using enum NormalRule::Side;
    return name == "front" ? front : name == "back" ? back : name == "outward" ? outward : inward;
}

}  // namespace

std::vector<StageEntry> normal_rule() {
    return {
        {.kind = StageKind::direction_rule,
         .name = "normal",
         .meaning = "along the normals of the eye object",
         .parameters =
             {{.name = "side",
               .type = ChoiceParameter{.choices = {"front", "back", "outward", "inward"}},
               .meaning =
                   "front: the cross product of the tangents along u and v, unless the object "
                   "specifies otherwise; back: the opposite; outward: the side of the surface that "
                   "leaves its visible part on the convex side, the same side in the whole "
                   "picture, "
                   "also beyond a pole, where the front is on the other side (for a plane: front); "
                   "inward: the opposite of outward"}},
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
