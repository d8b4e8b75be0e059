// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The views of a stereo pair: eyes beside each ray.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"
#include "camera/lenses/picture_plane.hpp"
#include "camera/machine/ray_expressions.hpp"

namespace balcony::camera {

namespace {

/// Where the eyes of a pair stand.
enum class Baseline : std::uint8_t {
    by_camera,  ///< `fixed` for a camera that sees from one point what is in front of it.
    fixed,      ///< Side by side, for all rays the same: two cameras.
    picture,    ///< Across each ray, to the left and right in the picture.
    level,      ///< Across each ray, horizontal in the camera's own axes.
};

/// Whether a camera's rays start at one point and none is more than 75 degrees off the one in the
/// middle, as far as a grid of points of the picture at time 0 shows.
bool looks_forward_from_a_point(const CentralRay& ray, const Emitter& emit) {
    constexpr std::size_t points = 5;
    constexpr double same = 1e-9;
    const double min_cosine = std::cos(75.0 * std::numbers::pi / 180.0);
    const auto& [o, d, parameters, picture] = ray;
    const std::vector<double> size =
        emit.trial(std::array{picture.size.width, picture.size.height}, 0.0, 0.0);
    const auto ray_at = [&, &origin = o, &direction = d](std::size_t i, std::size_t j) {
        return emit.trial(
            std::array{origin.x, origin.y, origin.z, direction.x, direction.y, direction.z},
            size[0] * static_cast<double>(i) / (points - 1),
            size[1] * static_cast<double>(j) / (points - 1));
    };
    const std::vector<double> middle = ray_at(points / 2, points / 2);
    for (std::size_t i = 0; i < points * points; ++i) {
        const std::vector<double> one = ray_at(i % points, i / points);
        double cosine = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            if (std::abs(one[k] - middle[k]) > same * (1.0 + std::abs(middle[k]))) {
                return false;
            }
            cosine += one[k + 3] * middle[k + 3];
        }
        if (cosine < min_cosine) {
            return false;
        }
    }
    return std::isfinite(middle[0] + middle[3]);
}

class StereoEye final : public StereoView {
public:
    struct Parts {
        Scalar separation, side;
        std::optional<Scalar> convergence;
        Baseline baseline = Baseline::by_camera;
        std::optional<Pair> merge;
        std::optional<Triple> up;
    };
    explicit StereoEye(Parts parts) : parts_(std::move(parts)) {}

    EyeRay eye(const CentralRay& ray, const ObjectVector& camera_up, Emitter& emit) const override {
        const ObjectVector up = parts_.up ? to_unit_length(vector_of(*parts_.up, emit)) : camera_up;
        const ObjectVector& d = ray.direction;
        const bool fixed =
            parts_.baseline == Baseline::fixed ||
            (parts_.baseline == Baseline::by_camera && looks_forward_from_a_point(ray, emit));
        const std::optional<PicturePlane> plane =
            fixed ? std::optional(picture_plane(ray, emit)) : std::nullopt;
        std::optional<Expr> vergence;
        if (parts_.convergence) {
            const Expr along_normal = plane ? dot(d, plane->normal) : emit(1.0);
            vergence = max(along_normal, emit(0.0)) / emit(*parts_.convergence);
        }
        const ObjectVector across = plane ? plane->right
                                    : parts_.baseline == Baseline::level
                                        ? level_across(d, up, emit)
                                        : right_across(ray, vergence, emit);
        const Expr shift = 0.5 * emit(parts_.side) * emit(parts_.separation);
        const ObjectVector offset = (merged(d, up, emit) * shift) * across;
        return {ray.origin + offset, vergence ? d + -(*vergence * offset) : d};
    }

private:
    /// The right of a viewer who looks along d; no direction for one who looks straight up or down.
    static ObjectVector level_across(const ObjectVector& d, const ObjectVector& up,
                                     const Emitter& emit) {
        const ObjectVector right = cross(d, up);
        const Expr square = dot(right, right);
        return select(smallest_square < square, 1.0 / sqrt(square), emit(0.0)) * right;
    }

    /// From 1 below the first angle to 0 above the second.
    [[nodiscard]] Expr merged(const ObjectVector& d, const ObjectVector& up,
                              const Emitter& emit) const {
        if (!parts_.merge) {
            return emit(1.0);
        }
        const ObjectVector level = cross(d, up);
        const Expr elevation = atan2(abs(dot(d, up)), sqrt(dot(level, level)));
        const Expr from = emit((*parts_.merge)[0]);
        const Expr part = (elevation - from) / (emit((*parts_.merge)[1]) - from);
        return 0.5 + 0.5 * cos(std::numbers::pi * min(max(part, emit(0.0)), emit(1.0)));
    }

    Parts parts_;
};

StageResult make_stereo(const Arguments& a) {
    StereoEye::Parts parts{a.number("separation"), a.number("side"), {}, {}, {}, {}};
    if (a.has("convergence")) {
        parts.convergence = a.number("convergence");
    }
    const std::string& baseline = a.choice("baseline");
    parts.baseline = baseline == "fixed"     ? Baseline::fixed
                     : baseline == "picture" ? Baseline::picture
                     : baseline == "level"   ? Baseline::level
                                             : Baseline::by_camera;
    if (a.has("merge")) {
        parts.merge = a.pair("merge");
        const auto from = (*parts.merge)[0].constant();
        const auto to = (*parts.merge)[1].constant();
        if (from && to && !(*from < *to)) {
            return error("the eyes merge from a smaller angle to a larger one", {},
                         "write merge = (60deg, 75deg)");
        }
    }
    if (a.has("up")) {
        parts.up = a.triple("up");
        if (std::all_of(parts.up->begin(), parts.up->end(),
                        [](const Scalar& one) { return one.constant() == 0.0; })) {
            return error("the upward direction must not be (0, 0, 0)", {},
                         "write up = z, or leave it out");
        }
    }
    return made<StereoEye>(std::move(parts));
}

}  // namespace

std::vector<StageEntry> stereo_views() {
    return {
        {.name = "stereo",
         .meaning = "one eye of a pair that stand beside each ray: the left or the right picture",
         .formula = R"(
o′ = o + a,   d′ = d − q a      o, d   the ray, |d| = 1
a = m side separation/2 X
fixed     X   to the right in the picture plane,   q = (d·N)/convergence
picture   X   across d, to the right in the picture,   q = 1/convergence
level     X = d × up/|d × up|,   q = 1/convergence
N   the unit vector across the picture plane;   q = 0 without convergence
m = (1 + cos(π s))/2,   s   from 0 to 1 between the elevations of merge
)",
         .parameters =
             {positive_parameter("separation", 0.064,
                                 "of the eyes, in scene units; people's eyes are 0.064 m apart"),
              {.name = "convergence",
               .type = NumberParameter{.range = {.minimum = 0.0, .excludes_minimum = true}},
               .optional = true,
               .meaning = "the distance at which both pictures agree: what is there appears on the "
                          "screen; without it, what is infinitely far away does"},
              number_parameter("side", 0.0,
                               "which eye: -1 is the left one, 1 the right one, 0 the middle",
                               {.minimum = -1.0, .maximum = 1.0}),
              choice_parameter(
                  "baseline", {"auto", "fixed", "picture", "level"},
                  "fixed: two cameras side by side; picture: across each ray, to the right "
                  "in the picture; level: across each ray, horizontal; auto: fixed if all "
                  "rays start at one point within 75 degrees of the middle one, else "
                  "picture"),
              {.name = "merge",
               .type = PairParameter{.unit = Unit::angle,
                                     .range = {.minimum = 0.0, .maximum = 0.5 * std::numbers::pi}},
               .optional = true,
               .meaning = "the angles above and below the horizon between which the separation "
                          "fades to 0, for panoramas: without it, zenith and nadir swirl"},
              {.name = "up",
               .type = TripleParameter{.names_axes = true},
               .optional = true,
               .meaning = "for level and merge, in the camera's axes; without it, the camera's own "
                          "upward direction, which moves turn"}},
         .make = make_stereo,
         .example = R"(
// What the left eye sees.
camera left_eye {
    map    u = 0.4 .. -0.4, v = square
    eye    point
    toward plane((1, 0, 0))
    stereo(separation = 2, convergence = 30, side = -1)
}
)"},
    };
}

}  // namespace balcony::camera
