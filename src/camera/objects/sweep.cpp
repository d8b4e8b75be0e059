// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object generator, PCS → OCS: a curve swept along another.

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"
#include "camera/curves/path_frame.hpp"
#include "camera/curves/spline_tables.hpp"

namespace balcony::camera {

namespace {

/// Three orthonormal vectors: right = tangent x up.
struct Frame {
    ObjectVector tangent, right, up;
};

ObjectVector unit(const ObjectVector& a) { return (1.0 / sqrt(dot(a, a))) * a; }

/// The points path(u) + right x + up y + tangent z with the profile's (x, y, z) at v, scaled and
/// rotated according to the position along the path.
class Sweep final : public ObjectGenerator {
public:
    struct Parts {
        ObjectGeneratorPointer profile, path;
        double from, to;
        PathFrame frame;  ///< Without a position: upright.
        Triple up;
        Scalar twist;
        std::optional<Formula> scale;
    };
    explicit Sweep(Parts parts) : parts_(std::move(parts)) {}
    int dimension() const override { return 2; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        const Expr way = within_unit_range((p.u - parts_.from) / (parts_.to - parts_.from),
                                           parts_.frame.closed, emit);
        const PathPlace at =
            place_on(*parts_.path, parts_.from + (parts_.to - parts_.from) * way, emit);
        const Frame frame = frame_at(way, unit(at.along), emit);
        const std::array<Expr, 2> scale = scale_at(way, emit);
        const ObjectPoint q = parts_.profile->generate({p.v, emit(0.0)}, emit);
        // Counter-clockwise as seen along the path.
        const Expr angle = emit(parts_.twist) * way;
        const Expr x = scale[0] * q.x;
        const Expr y = scale[1] * q.y;
        return at.point + (cos(angle) * x - sin(angle) * y) * frame.right +
               (sin(angle) * x + cos(angle) * y) * frame.up + q.z * frame.tangent;
    }

private:
    // Takes the component of up perpendicular to the tangent, so that the
    // frame is orthonormal exactly.
    Frame frame_at(Expr way, const ObjectVector& tangent, Emitter& emit) const {
        ObjectVector up = vector_of(parts_.up, emit);
        if (parts_.frame.position) {
            const Expr position = (*parts_.frame.position)(way, emit);
            const auto value = [&](std::size_t k) {
                return emit.graph().lookup(parts_.frame.up[k], position);
            };
            up = {value(0), value(1), value(2)};
        }
        const ObjectVector across = up + -(dot(up, tangent) * tangent);
        emit.require(0.0 < dot(across, across));
        const ObjectVector unit_up = unit(across);
        return {tangent, cross(tangent, unit_up), unit_up};
    }

    std::array<Expr, 2> scale_at(Expr way, Emitter& emit) const {
        if (!parts_.scale) {
            return {emit(1.0), emit(1.0)};
        }
        const std::vector<Expr> scale = parts_.scale->emit(emit.graph(), std::array{way});
        return {scale.front(), scale.back()};
    }

    Parts parts_;
};

StageResult make_sweep(const Arguments& a) {
    Sweep::Parts parts{a.curve("profile"),
                       a.curve("path"),
                       a.constant("from"),
                       a.constant("to"),
                       {},
                       a.triple("up"),
                       a.number("twist"),
                       {}};
    if (parts.from == parts.to) {
        return error("from and to are equal, so the path is empty", {},
                     "use two different parameters of the path");
    }
    if (a.has("scale")) {
        parts.scale = a.formula("scale");
    }
    Vector3 up{};
    for (std::size_t k = 0; k < 3; ++k) {
        up[k] = *parts.up[k].constant();
    }
    if (norm(up) == 0.0) {
        return error("up has no direction", {}, "make one of its coordinates differ from 0");
    }
    Result<PathFrame> frame = rotation_minimising_frame(*parts.path, parts.from, parts.to, up);
    if (!frame) {
        return frame.diagnostics;
    }
    parts.frame = std::move(*frame);
    if (a.choice("frame") == "upright") {
        parts.frame.position.reset();
    }
    return made<Sweep>(std::move(parts));
}

}  // namespace

std::vector<StageEntry> sweeps() {
    return {
        {.name = "sweep",
         .meaning = "a curve, the profile, swept along another, the path: u is the path's own "
                    "parameter, v that of the profile",
         .formula = R"(
p = c(w) + X right + Y up + z T      (x, y, z) = profile(v),   c = path
(X, Y) = (k x, l y), rotated by s twist,   (k, l) = scale(s)
s = (u − from)/(to − from), modulo 1 if the path is closed
w = from + s (to − from)
T = c′/|c′|,   right = T × up
up   upright: the part of `up` perpendicular to T, at unit length
     rotation_minimising: that at the start, then up′ = −(up·T′) T; along a
     closed path it turns by a further s β about T, with the β that closes it
β and twist are even in s, the path's own parameter; for a path
arc_length(curve) they are even in length.
)",
         .parameters =
             {curve_parameter(
                  "profile",
                  "the profile; its x axis points to the right and its y axis up, as seen "
                  "along the path"),
              curve_parameter("path", "the path; it cannot change with time"),
              {.name = "from",
               .type =
                   NumberParameter{.unit = Unit::either, .default_value = 0.0, .constant = true},
               .meaning = "the path's parameter at the start"},
              {.name = "to",
               .type =
                   NumberParameter{.unit = Unit::either, .default_value = 1.0, .constant = true},
               .meaning =
                   "the path's parameter at the end; a path that is closed there is periodic"},
              angle_parameter(
                  "twist", 0.0,
                  "rotation of the profile along the path, counter-clockwise as seen along it"),
              {.name = "scale",
               .type = FormulaParameter{.shape = {1, 1, 2}},
               .optional = true,
               .meaning = "size of the profile: scale(s) = [k], or [k, l] in x and y, with s from "
                          "0 to 1 along the path"},
              choice_parameter(
                  "frame", {"rotation_minimising", "upright"},
                  "orientation of the profile: without rotation about the path, or with "
                  "its y axis as close to up as possible"),
              {.name = "up",
               .type = TripleParameter{.default_value = std::array{0.0, 0.0, 1.0},
                                       .constant = true,
                                       .names_axes = true},
               .meaning = "direction of the profile's y axis: at the start, or everywhere"}},
         .make = make_sweep,
         .dimension = 2,
         .example =
             R"(// Outwards from a tube that winds through space, from its last bend to its first.
camera winding_tube {
    map  u = 0.98 .. 0.02, v = -180deg .. 180deg
    eye  sweep(circle(0.4), natural_spline([(-4, -3, 0), (-2, 2, 1), (0, 0, -1), (2, -2, 1), (4, 3, 0)]),
               twist = 180deg, scale(s) = [1 + sin(pi*s)])
    look normal
})"},
    };
}

}  // namespace balcony::camera
