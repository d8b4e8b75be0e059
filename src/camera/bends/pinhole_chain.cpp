// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Rays that go from pinhole to pinhole round corners: V. Popescu, P. Rosen, N. Adamo-Villani, "The
// Graph Camera" (2009); J. Cui, P. Rosen, V. Popescu, C. Hoffmann, "A Curved Ray Camera for
// Handling Occlusions through Continuous Multiperspective Visualization" (2010).

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "camera/bends/straight_parts.hpp"
#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

namespace {

/// Where a ray turns, and where to.
struct Turning {
    ObjectPoint point;
    ObjectVector direction;  ///< Behind it; unit length.
    Expr reached;            ///< 0 for a ray that passes this corner by and stays straight.
};

ObjectPoint select(Expr condition, const ObjectPoint& a, const ObjectPoint& b) {
    return {expr::select(condition, a.x, b.x), expr::select(condition, a.y, b.y),
            expr::select(condition, a.z, b.z)};
}

ObjectVector select(Expr condition, const ObjectVector& a, const ObjectVector& b) {
    return {expr::select(condition, a.x, b.x), expr::select(condition, a.y, b.y),
            expr::select(condition, a.z, b.z)};
}

Expr length(const ObjectVector& a) { return sqrt(dot(a, a)); }

class PinholeChain final : public Bend {
public:
    PinholeChain(PointList corners, Scalar distance, double rounding, std::size_t parts_of_corner)
        : corners_(std::move(corners)),
          distance_(std::move(distance)),
          rounding_(rounding),
          parts_of_corner_(parts_of_corner) {}

    BentPath path(const CentralRay& ray, Emitter& emit) const override {
        const std::vector<Turning> turnings = turnings_of(ray, emit);
        report_missed_corner(turnings, ray, emit);
        BentPath made{{ray.origin}, turnings.back().direction};
        for (std::size_t i = 1; i < turnings.size(); ++i) {
            if (parts_of_corner_ == 0) {
                made.knots.push_back(turnings[i].point);
            } else {
                round(turnings[i - 1], turnings[i],
                      i + 1 < turnings.size() ? &turnings[i + 1] : nullptr, made.knots, emit);
            }
        }
        return made;
    }

private:
    // The first one is the origin. The last corner only says where the way leads to.
    [[nodiscard]] std::vector<Turning> turnings_of(const CentralRay& ray, Emitter& emit) const {
        std::vector<Turning> turnings{{ray.origin, ray.direction, emit(1.0)}};
        ObjectPoint pinhole = middle_of(ray).origin;
        for (std::size_t i = 0; i + 1 < corners_.size(); ++i) {
            const ObjectPoint corner = corner_at(i, emit);
            const ObjectVector before = corner - pinhole;
            const ObjectVector onward = to_unit_length(corner_at(i + 1, emit) - corner);
            const ObjectVector across = to_unit_length(before) + onward;
            constexpr double straight_back = 1e-12;
            emit.require_somewhere(
                straight_back < dot(across, across),
                error(fmt::format("corner {} of this bend has no direction: it is where the way "
                                  "comes from, or the way turns straight back",
                                  i + 1),
                      {}, "move the corner"));
            pinhole = corner + -(emit(distance_) * length(before)) * onward;
            turnings.push_back(turning(turnings.back(), i == 0, corner, across, pinhole, emit));
        }
        return turnings;
    }

    // A ray that misses a corner misses all behind it.
    static void report_missed_corner(const std::vector<Turning>& turnings, const CentralRay& ray,
                                     Emitter& emit) {
        std::vector<Expr> reached;
        for (const Turning& turning : turnings) {
            reached.push_back(turning.reached);
        }
        std::size_t farthest = 0;
        for (const Imath::V2d& point : trial_points(ray, emit)) {
            const std::vector<double> values = emit.trial(reached, point.x, point.y);
            const auto missed = std::find(values.begin(), values.end(), 0.0);
            farthest = std::max(farthest, static_cast<std::size_t>(missed - values.begin()));
        }
        if (farthest < turnings.size()) {
            emit.report(warning(
                fmt::format("no ray of the picture turns at corner {} of this bend, because none "
                            "comes to the plane that halves its angle",
                            farthest),
                {}, "move the corner to where the rays go, or turn the camera"));
        }
    }

    [[nodiscard]] ObjectPoint corner_at(std::size_t i, const Emitter& emit) const {
        const auto p = corners_[i];
        return {emit(p[0]), emit(p[1]), emit(p[2])};
    }

    // The plane through the corner halves its angle. A ray that has passed it already, where the
    // planes of two corners cross, turns at once. One that never meets it is straight from then on:
    // its neighbours turn at infinity.
    [[nodiscard]] static Turning turning(const Turning& last, bool is_first,
                                         const ObjectPoint& corner, const ObjectVector& across,
                                         const ObjectPoint& pinhole, const Emitter& emit) {
        const Expr approach = dot(last.direction, across);
        const Expr way = dot(corner - last.point, across) / approach;
        const Expr ahead = last.reached && 0.0 < approach && is_finite(way);
        const Expr reached = is_first ? ahead && 0.0 < way : ahead;
        const ObjectVector to_plane = max(way, emit(0.0)) * last.direction;
        const ObjectPoint point = select(reached, last.point + to_plane, last.point);
        return {point, select(reached, to_unit_length(point - pinhole), last.direction), reached};
    }

    // Bézier's parabola from the same distance before and behind the corner, up to half of the way
    // to the next ones. A corner that is not reached is infinitely far away.
    void round(const Turning& last, const Turning& here, const Turning* next,
               std::vector<ObjectPoint>& knots, const Emitter& emit) const {
        constexpr double far_away = 1e30;
        const auto half_way = [&](const Turning& from, const Turning& to) {
            return select(to.reached, 0.5 * length(to.point - from.point), emit(far_away));
        };
        Expr reach = min(emit(rounding_), half_way(last, here));
        if (next != nullptr) {
            reach = min(reach, half_way(here, *next));
        }
        const ObjectPoint end = knots.back();  // Where a ray stays that does not turn.
        const ObjectVector before = reach * last.direction;
        const ObjectVector behind = reach * here.direction;
        const ObjectPoint first = here.point + -before;
        for (std::size_t i = 0; i <= parts_of_corner_; ++i) {
            const double t = static_cast<double>(i) / static_cast<double>(parts_of_corner_);
            const ObjectVector way = emit(t * (2.0 - t)) * before + emit(t * t) * behind;
            knots.push_back(select(here.reached, first + way, end));
        }
    }

    PointList corners_;
    Scalar distance_;
    double rounding_;
    std::size_t parts_of_corner_;  ///< 0: sharp.
};

StageResult make_chain(const Arguments& a) {
    const PointList& corners = a.points("corners");
    const double rounding = a.constant("rounding");
    const double tolerance = a.constant("tolerance");
    // Chords are at most |B''| / (8 n²) from the parabola, where B'' is 2 r times a difference of
    // unit vectors.
    const double parts = std::ceil(std::sqrt(rounding / (2.0 * tolerance)));
    const double knots = (parts + 1.0) * static_cast<double>(corners.size() - 1);
    if (knots > static_cast<double>(max_straight_parts)) {
        return error(fmt::format("this chain needs {:.6g} straight parts to round its corners to "
                                 "within {:g}, but a bend has at most {}",
                                 knots, tolerance, max_straight_parts),
                     {}, "write a larger tolerance, less rounding, or fewer corners");
    }
    return made<PinholeChain>(corners, a.number("distance"), rounding,
                              static_cast<std::size_t>(parts));
}

}  // namespace

std::vector<StageEntry> pinhole_chain() {
    return {
        {.name = "pinholes",
         .meaning = "rays round corners, from pinhole to pinhole: a graph camera",
         .formula = R"(
kᵢ   the corners;   c₁   the origin of the middle ray
eᵢ   the unit vector from kᵢ to kᵢ₊₁;   aᵢ   that from cᵢ to kᵢ
cᵢ₊₁ = kᵢ − distance |kᵢ − cᵢ| eᵢ
a ray meets (p − kᵢ)·(aᵢ + eᵢ) = 0 in pᵢ and goes on along pᵢ − cᵢ₊₁
rounding   pᵢ − r (1 − t)² d + r t² d′;   d, d′   the ray before and behind pᵢ
r   the rounding, at most half the way to the next corner
)",
         .parameters = {{.name = "corners",
                         .type = PointsParameter{.coordinates = {3}, .min_points = 2},
                         .meaning = "where the way turns, and at last a point where it leads to"},
                        positive_parameter(
                            "distance", 1.0,
                            "of each pinhole behind its corner, in lengths of the way from the "
                            "pinhole before; 1 goes on as if the way were straight, and more "
                            "makes the end of the way larger"),
                        {.name = "rounding",
                         .type =
                             NumberParameter{
                                 .default_value = 0.0, .range = {.minimum = 0.0}, .constant = true},
                         .meaning = "the length before and behind a corner on which rays are "
                                    "curved; 0 is sharp"},
                        {.name = "tolerance",
                         .type =
                             NumberParameter{.default_value = Division().tolerance,
                                             .range = {.minimum = 0.0, .excludes_minimum = true},
                                             .constant = true},
                         .meaning = "the farthest that the straight parts of a rounded corner may "
                                    "be from its curve, in scene units"}},
         .make = make_chain,
         .example = R"(
// Along the room, and round a corner before its end.
camera round_the_corner {
    map    u = 0.8 .. -0.8, v = square
    eye    point
    toward plane((1, 0, 0))
    move   translate(-40, -20, 0)
    bend   pinholes([(20, -20, 0), (20, 20, 0)], rounding = 8, tolerance = 0.05)
}
)"},
    };
}

}  // namespace balcony::camera
