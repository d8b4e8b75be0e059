// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Lenses of glass, refracted surface by surface.

#include <cmath>
#include <memory>
#include <numbers>

#include <fmt/format.h>

#include "balcony/prescription.hpp"
#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"
#include "camera/lenses/disc.hpp"
#include "camera/lenses/exit_pupil.hpp"
#include "camera/lenses/lens_optics.hpp"
#include "camera/lenses/picture_plane.hpp"
#include "camera/lenses/prescription_check.hpp"
#include "camera/machine/ray_expressions.hpp"

namespace balcony::camera {

namespace {

using PrescriptionPointer = std::shared_ptr<const Prescription>;

/// The axes of a lens in the scene, and a point of the picture by its place on a plane that is one
/// unit in front of the pinhole.
struct LensFrame {
    ObjectVector right, up, forward;
    AperturePoint tangent;
    Expr width;  ///< Of the picture on this plane.
};

LensFrame frame_of(const CentralRay& central, Emitter& emit) {
    const auto [right, forward] = picture_plane(central, emit);
    const ObjectVector up = cross(right, forward);
    const ObjectVector& d = central.direction;
    const Expr along = dot(d, forward);
    emit.require(0.0 < along);
    const AperturePoint tangent{dot(d, right) / along, dot(d, up) / along};
    const PictureSize& size = central.picture.size;
    const auto at_column = [&](Expr x) {
        const std::array put{expr::Substitution{central.picture.point.x, x},
                             expr::Substitution{central.picture.point.y, 0.5 * size.height}};
        return expr::substitute(emit.graph(), std::array{tangent.x}, put)[0];
    };
    return {right, up, forward, tangent, abs(at_column(size.width) - at_column(emit(0.0)))};
}

class PrescribedLens final : public Lens {
public:
    struct Parts {
        PrescriptionPointer prescription;
        LensOptics optics;
        FocusSurfacePointer focus;
        std::optional<FocusingGroup> group;
        std::optional<Scalar> sensor;
        Scalar unit;
        ParaxialLens paraxial;     ///< In the vertical plane.
        double horizontal_length;  ///< The focal length in the horizontal one.
    };
    explicit PrescribedLens(Parts parts) : parts_(std::move(parts)) {}

    const FocusSurface& focus() const override { return *parts_.focus; }

    LensRays rays(const CentralRay& central, const AperturePoint& square,
                  Emitter& emit) const override {
        const LensFrame frame = frame_of(central, emit);
        const Expr vergence = vergence_of(central, frame, emit);
        const auto pupil = pupil_at(vergence, emit);
        if (!pupil) {
            return {{central.origin, central.direction, emit(1.0), emit(0.0)}};
        }
        const FocusedOptics<Expr> at = focused(parts_.optics, parts_.group, vergence);
        emit.require(at.valid);
        const Expr depth = at.depth();
        const Expr scale =
            parts_.sensor ? emit(*parts_.sensor) / frame.width : emit(parts_.horizontal_length);
        const double ratio = parts_.paraxial.focal_length / parts_.horizontal_length;
        const std::array<Expr, 2> sensor{-(scale * frame.tangent.x),
                                         -(ratio * scale * frame.tangent.y)};
        const Expr distance = sqrt(depth * depth + sensor[0] * sensor[0] + sensor[1] * sensor[1]);
        const std::array<Expr, 2> s{sensor[0] / distance, sensor[1] / distance};
        const Expr square_of_s = s[0] * s[0] + s[1] * s[1];
        const Expr lit = square_of_s <= pupil->largest_square;
        const auto middle = [&](std::size_t axis) {
            return -(s[axis] *
                     emit.graph().lookup(std::make_shared<const expr::Table>(pupil->middle[axis]),
                                         min(square_of_s, emit(pupil->largest_square))));
        };
        const std::array<Expr, 2> center{middle(0), middle(1)};
        const auto ray = [&](const Expr& m, const Expr& n) {
            LensRay made =
                through(frame, central.origin, at, sensor, {m + center[0], n + center[1]}, emit);
            made.valid = lit && made.valid;
            made.blocked = !made.valid;
            return made;
        };
        const PolarPoint on = on_disc(square, emit);
        const auto half_axis = [&](std::size_t axis) {
            return pupil->radius[axis] / depth * on.radius;
        };
        const Expr zero = emit(0.0);
        return {
            ray(half_axis(0) * cos(on.angle), half_axis(1) * sin(on.angle)), {}, ray(zero, zero)};
    }

private:
    /// In 1/mm along the axis, from the entrance pupil, which is in the place of the pinhole.
    Expr vergence_of(const CentralRay& central, const LensFrame& frame, Emitter& emit) const {
        CentralRay axis = middle_of(central);
        axis.direction = frame.forward;
        const Expr power = parts_.focus->vergence(axis, emit);
        return emit(parts_.unit) * select(0.0 < power && is_finite(power), power, emit(0.0));
    }

    std::optional<ExitPupil> pupil_at(const Expr& vergence, Emitter& emit) const {
        constexpr double nearest = 5.0;  // Focal lengths: closer than most lenses focus.
        const double near = 1.0 / (nearest * parts_.paraxial.focal_length);
        const std::vector<double> vergences = vergence.is_constant()
                                                  ? std::vector{vergence.node().value}
                                                  : std::vector{0.0, 0.5 * near, near};
        for (const double one : vergence.is_constant() ? vergences : std::vector<double>()) {
            if (auto fault = fault_at(focused(parts_.optics, parts_.group, one))) {
                emit.report(*std::move(fault));
                return std::nullopt;
            }
        }
        auto found = find_exit_pupil(parts_.optics, parts_.group, vergences);
        if (!found) {
            emit.report(error(fmt::format("no light passes the lens '{}' at this focus",
                                          parts_.prescription->name),
                              {}, "focus farther away"));
        }
        return found;
    }

    /// What makes it impossible to focus there.
    std::optional<Diagnostic> fault_at(const FocusedOptics<double>& at) const {
        const std::string& name = parts_.prescription->name;
        const auto& surfaces = parts_.prescription->surfaces;
        if (!at.valid) {
            return error(fmt::format("surfaces {} to {} of '{}' cannot focus so near",
                                     parts_.group->first + 1, parts_.group->last + 1, name),
                         {}, "focus farther away, or write another group");
        }
        for (std::size_t i = 0; parts_.group && i + 1 < surfaces.size(); ++i) {
            // A stop may be within the bulge of a surface.
            if (!parts_.optics.surfaces[i].refracts() ||
                !parts_.optics.surfaces[i + 1].refracts()) {
                continue;
            }
            if (auto fault = crossing_of(surfaces[i], surfaces[i + 1],
                                         at.vertices[i] - at.vertices[i + 1])) {
                fault->message += fmt::format(" when surfaces {} to {} are focused",
                                              parts_.group->first + 1, parts_.group->last + 1);
                fault->remedy = "focus farther away, or write another group";
                return fault;
            }
        }
        if (!(at.depth() > 0.0)) {
            return error(fmt::format("the sensor of '{}' is {:.4g} mm in front of its last surface "
                                     "at this focus",
                                     name, std::abs(at.depth())),
                         {}, "write another group or a larger defocus, or focus nearer");
        }
        return std::nullopt;
    }

    LensRay through(const LensFrame& frame, const ObjectPoint& pinhole,
                    const FocusedOptics<Expr>& at, const std::array<Expr, 2>& sensor,
                    const std::array<Expr, 2>& direction, const Emitter& emit) const {
        const auto& [m, n] = direction;
        const Expr square = m * m + n * n;
        const Expr along = sqrt(max(1.0 - square, emit(0.0)));
        const LensPath<Expr> path =
            traced(parts_.optics, at, sensor, std::array<Expr, 3>{m, n, along});
        const auto in_scene = [&](const std::array<Expr, 3>& v) {
            return v[0] * frame.right + (v[1] * frame.up + v[2] * frame.forward);
        };
        const std::array<Expr, 3> from_pupil{path.point[0], path.point[1],
                                             path.point[2] + parts_.paraxial.entrance_pupil};
        const ObjectPoint origin = pinhole + emit(parts_.unit) * in_scene(from_pupil);
        const ObjectVector toward = in_scene(path.direction);
        return {origin, toward, emit(1.0),
                path.passed && is_finite(dot(toward, toward) + path.point[2] * path.point[2])};
    }

    Parts parts_;
};

// ------------------------------------------------------------------------------ the arguments

std::optional<Diagnostic> too_wide(const ParaxialLens& paraxial, double f_number) {
    const double widest = paraxial.f_number();
    if (f_number < widest * (1.0 - 1e-6)) {
        return error(
            fmt::format("f/{:.3g} is wider than this lens, which is f/{:.3g}", f_number, widest),
            {}, "write a larger f_number, or leave it out");
    }
    return std::nullopt;
}

Result<std::optional<FocusingGroup>> group_of(const Arguments& a, std::size_t count) {
    if (!a.has("group")) {
        return std::optional<FocusingGroup>();
    }
    const Pair written = a.pair("group");
    const double first = *written[0].constant();
    const double last = *written[1].constant();
    if (first != std::floor(first) || last != std::floor(last) || !(first <= last) ||
        last > static_cast<double>(count)) {
        return error(
            fmt::format("there is no group from surface {:g} to surface {:g}", first, last), {},
            fmt::format("write the first and the last surface, 1 to {}", count));
    }
    return std::optional(
        FocusingGroup{static_cast<std::size_t>(first) - 1, static_cast<std::size_t>(last) - 1});
}

StageResult make_prescribed_lens(const Arguments& a) {
    const auto& prescription = a.file<Prescription>("file");
    const double wavelength = a.constant("wavelength") / 1000.0;
    for (const LensSurface& surface : prescription->surfaces) {
        if (auto fault = wrong_index(surface, wavelength)) {
            return *std::move(fault);
        }
    }
    PrescribedLens::Parts parts{prescription,
                                optics_of(*prescription, wavelength, line_d),
                                a.stage<FocusSurface>("focus"),
                                {},
                                {},
                                a.number("unit"),
                                paraxial(*prescription),
                                paraxial(horizontal_section(*prescription)).focal_length};
    auto group = group_of(a, prescription->surfaces.size());
    if (!group) {
        return group.diagnostics;
    }
    parts.group = *group;
    if (a.has("sensor")) {
        parts.sensor = a.number("sensor");
    }
    if (a.has("f_number")) {
        if (auto fault = too_wide(parts.paraxial, a.constant("f_number"))) {
            return *std::move(fault);
        }
        narrow_stop(parts.optics, parts.paraxial, a.constant("f_number"));
    }
    parts.optics.defocus = a.constant("defocus");
    parts.optics.blades = {a.count("blades"), a.constant("rotation")};
    if (parts.optics.blades.count == 1 || parts.optics.blades.count == 2) {
        return too_few_blades(parts.optics.blades.count);
    }
    return made<PrescribedLens>(std::move(parts));
}

}  // namespace

std::vector<StageEntry> prescribed_lenses() {
    return {
        {.name = "table",
         .meaning =
             "a lens of glass from a file, in the place of a pinhole: every ray is refracted "
             "surface by surface",
         .formula = R"(
from P = −F (x, y) on the sensor in the direction (m, n, √(1 − m² − n²))
(x, y)   the tangents of the pinhole's ray
F   the focal length, or sensor divided by the width of the tangents
    upwards times the ratio of the focal lengths, if the lens is anamorphic
(m, n) = −h P/|P − Q| + ρ (a, b)      (a, b)   a point of the unit disc
Q   the middle of the last surface,   h, ρ   so that the disc has what passes
at each surface   d′ = n/n′ d + (√(1 − (n/n′)² (1 − c²)) − n/n′ c) N,   c = d·N
n, n′   the indices before and behind it,   N   its normal
no ray that misses a hole or the stop, or that is totally reflected
)",
         .parameters =
             {{.name = "file",
               .type = PrescriptionParameter{},
               .meaning = "the surfaces: pbrt's .dat, Zemax's .zmx or a table"},
              {.name = "focus",
               .type = NestedStageParameter{.kind = StageKind::focus, .of_number = "distance"},
               .meaning = "what is sharp on the axis: a distance from the pinhole, or a surface of "
                          "focus"},
              {.name = "sensor",
               .type = NumberParameter{.range = {.minimum = 0.0, .excludes_minimum = true}},
               .optional = true,
               .meaning = "the width of the picture on the sensor in mm; without it, the focal "
                          "length times that of the pinhole's picture at the distance 1"},
              {.name = "f_number",
               .type = NumberParameter{.range = {.minimum = 0.0, .excludes_minimum = true},
                                       .constant = true},
               .optional = true,
               .meaning = "narrows the stop; without it, it is as wide as in the file"},
              {.name = "blades",
               .type =
                   CountParameter{.default_value = 0.0, .range = {.minimum = 0.0, .maximum = 64.0}},
               .meaning = "the number of sides of the stop; 0 is round"},
              {.name = "rotation",
               .type = NumberParameter{.unit = Unit::angle, .default_value = 0.0, .constant = true},
               .meaning = "of the polygon, counter-clockwise; at 0 a corner is at the top"},
              {.name = "group",
               .type =
                   PairParameter{.range = {.minimum = 1.0, .maximum = 1000.0}, .constant = true},
               .optional = true,
               .meaning = "the first and the last surface, counted from the scene, of what moves "
                          "to focus; without it, the sensor moves"},
              {.name = "defocus",
               .type = NumberParameter{.default_value = 0.0, .constant = true},
               .meaning = "how far behind its focus the sensor is, in mm"},
              {.name = "wavelength",
               .type = NumberParameter{.default_value = 587.5618,
                                       .range = {.minimum = 200.0, .maximum = 3000.0},
                                       .constant = true},
               .meaning = "of the light in nm; the lens is focused with that of 587.6 nm"},
              positive_parameter("unit", 0.001, "1 mm in scene units")},
         .make = make_prescribed_lens,
         .example = R"(
// A double Gauss, wide open, with the vignetting of its edges.
camera glass {
    map    u = 0.36 .. -0.36, v = square
    eye    point
    toward plane((1, 0, 0))
    lens   table("dgauss.dat", focus = 50, unit = 0.1)
}
)"},
    };
}

}  // namespace balcony::camera
