// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// A lens with a round or polygonal aperture.

#include <numbers>

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"
#include "camera/lenses/disc.hpp"

namespace balcony::camera {

namespace {

constexpr double pi = std::numbers::pi;

class FocusedLens : public ThinLens {
public:
    FocusedLens(Scalar radius, FocusSurfacePointer focus)
        : radius_(std::move(radius)), focus_(std::move(focus)) {}
    Scalar radius() const final { return radius_; }
    const FocusSurface& focus() const final { return *focus_; }

private:
    Scalar radius_;
    FocusSurfacePointer focus_;
};

class RoundLens final : public FocusedLens {
    using FocusedLens::FocusedLens;
    AperturePoint aperture(const AperturePoint& square, Emitter& emit) const override {
        const PolarPoint p = on_disc(square, emit);
        return {p.radius * cos(p.angle), p.radius * sin(p.angle)};
    }
};

/// The polygon with its corners on the circle. Each sector of the disc goes to the triangle of a
/// side: arcs around the centre become straight, and are divided evenly as before.
class PolygonalLens final : public FocusedLens {
public:
    PolygonalLens(Scalar radius, FocusSurfacePointer focus, std::size_t blades, Scalar rotation)
        : FocusedLens(std::move(radius), std::move(focus)),
          blades_(static_cast<double>(blades)),
          rotation_(std::move(rotation)) {}
    AperturePoint aperture(const AperturePoint& square, Emitter& emit) const override {
        const PolarPoint p = on_disc(square, emit);
        const double step = 2.0 * pi / blades_;
        const Expr sides = p.angle / step;
        const Expr side = floor(sides);
        const Expr part = sides - side;
        const Expr first = pi / 2.0 + emit(rotation_) + side * step;
        const Expr next = first + step;
        return {p.radius * ((1.0 - part) * cos(first) + part * cos(next)),
                p.radius * ((1.0 - part) * sin(first) + part * sin(next))};
    }

private:
    double blades_;
    Scalar rotation_;
};

StageResult make_thin_lens(const Arguments& a) {
    const std::size_t blades = a.count("blades");
    const auto focus = a.stage<FocusSurface>("focus");
    if (blades == 0) {
        return made<RoundLens>(a.number("radius"), focus);
    }
    if (blades < 3) {
        return too_few_blades(blades);
    }
    return made<PolygonalLens>(a.number("radius"), focus, blades, a.number("rotation"));
}

}  // namespace

std::vector<StageEntry> lenses() {
    return {
        {.name = "lens",
         .meaning =
             "an aperture across each ray, around its origin: what is not in focus is blurred",
         .formula = R"(
o′ = o + a,   d′ = d − a/s      o, d   the ray, |d| = 1;   s   the focus
a = radius (x X + y Y)      (x, y)   a point of the unit disc or polygon
X   the unit vector across d along ∂(o + s d)/∂(picture x),   Y = X × d
all rays of a picture point meet in o + s d
)",
         .parameters =
             {{.name = "radius",
               .type = NumberParameter{.range = {.minimum = 0.0}},
               .meaning = "of the circle around the aperture, in scene units; 0 is a pinhole"},
              {.name = "blades",
               .type =
                   CountParameter{.default_value = 0.0, .range = {.minimum = 0.0, .maximum = 64.0}},
               .meaning = "the number of sides of the aperture; 0 is round"},
              {.name = "focus",
               .type = NestedStageParameter{.kind = StageKind::focus, .of_number = "distance"},
               .meaning = "what is sharp: a distance along the rays, or a surface of focus"},
              angle_parameter(
                  "rotation", 0.0,
                  "of the polygon, counter-clockwise as the picture shows it; at 0 a corner "
                  "is at the top")},
         .make = make_thin_lens,
         .example = R"(
// The painting behind is out of focus, blurred to hexagons.
camera hexagonal {
    map    u = 0.4 .. -0.4, v = square
    eye    point
    toward plane((1, 0, 0))
    lens(radius = 1.5, blades = 6, focus = 25)
}
)"},
    };
}

}  // namespace balcony::camera
