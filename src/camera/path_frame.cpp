// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/path_frame.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace balcony::camera {

namespace {

Vector3 operator+(const Vector3& a, const Vector3& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Vector3 operator-(const Vector3& a, const Vector3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vector3 operator*(double factor, const Vector3& a) {
    return {factor * a[0], factor * a[1], factor * a[2]};
}
double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector3 cross(const Vector3& a, const Vector3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector3 unit(const Vector3& a) { return (1.0 / norm(a)) * a; }
Vector3 across(const Vector3& a, const Vector3& unit_normal) {
    return a - dot(a, unit_normal) * unit_normal;
}
Vector3 reflected(const Vector3& a, const Vector3& mirror_normal) {
    return a - (2.0 * dot(mirror_normal, a) / dot(mirror_normal, mirror_normal)) * mirror_normal;
}

/// A point on the path, with derivatives with respect to the fraction of the way.
struct Place {
    Vector3 point;
    Vector3 tangent;  ///< Unit length.
    Vector3 tangent_by_part;
};

constexpr std::size_t min_cells = 256;
constexpr std::size_t max_cells = 4096;
/// Up to this angle in radians between its ends, a cubic approximates the frame in a cell to 1e-6.
constexpr double max_turn = 0.1;
constexpr std::size_t max_corners = max_cells / 16;

double part(std::size_t i, std::size_t cells) {
    return static_cast<double>(i) / static_cast<double>(cells);
}

Result<std::vector<Place>> places_on(const CurveSampler& path, double from, double to,
                                     std::size_t cells) {
    std::vector<double> parameters;
    for (std::size_t i = 0; i <= cells; ++i) {
        parameters.push_back(std::lerp(from, to, part(i, cells)));
    }
    std::vector<Place> places;
    for (const CurveSample& sample : path(parameters)) {
        const double parameter = parameters[places.size()];
        const double speed = norm(sample.velocity);
        if (std::isnan(norm(sample.point))) {
            return error(fmt::format("the path has no point at its parameter {:.6g}", parameter),
                         {}, "choose from and to such that the path is defined between them");
        }
        if (!(speed > 0.0) || !std::isfinite(norm(sample.acceleration) / speed)) {
            return error(
                fmt::format("the path has no direction at its parameter {:.6g}", parameter), {},
                "use another parametrisation, or a range without this point");
        }
        const Vector3 tangent = unit(sample.velocity);
        places.push_back(
            {sample.point, tangent, ((to - from) / speed) * across(sample.acceleration, tangent)});
    }
    return places;
}

double angle_between(const Vector3& unit_a, const Vector3& unit_b) {
    return 2.0 * std::asin(std::min(1.0, 0.5 * norm(unit_b - unit_a)));
}

/// Samples so dense that the path hardly turns between two of them. Corners, where it always does,
/// are accepted if there are few.
Result<std::vector<Place>> fine_places_on(const CurveSampler& path, double from, double to) {
    for (std::size_t cells = min_cells;; cells *= 2) {
        Result<std::vector<Place>> places = places_on(path, from, to, cells);
        if (!places) {
            return places;
        }
        std::size_t turning = 0;
        for (std::size_t i = 0; i < cells; ++i) {
            const double turn = angle_between((*places)[i].tangent, (*places)[i + 1].tangent);
            turning += turn > max_turn ? 1 : 0;
        }
        if (turning == 0 || (cells == max_cells && turning <= max_corners)) {
            return places;
        }
        if (cells == max_cells) {
            return error(fmt::format("the path turns too much for a frame of {} steps", max_cells),
                         {}, "sweep along parts of the path, with from and to");
        }
    }
}

/// One step of a frame's upward vector by two reflections, in the plane between the two points and
/// in that between the two tangents (Wang, Jüttler, Zheng and Liu 2008): of fourth order, and
/// without a preferred direction at inflections and straight parts.
Vector3 transported(const Vector3& up, const Place& here, const Place& next) {
    const Vector3 way = next.point - here.point;
    const Vector3 up_half = reflected(up, way);
    const Vector3 tangent_half = reflected(here.tangent, way);
    return unit(across(reflected(up_half, next.tangent - tangent_half), next.tangent));
}

/// The angle about the tangent from one perpendicular vector to another.
double angle_about(const Vector3& tangent, const Vector3& from, const Vector3& to) {
    return std::atan2(dot(cross(from, to), tangent), dot(from, to));
}

/// The component of `wished` perpendicular to the path, or of another axis if the path is parallel
/// to it.
Vector3 first_up(const Vector3& wished, const Vector3& tangent) {
    Vector3 up = across(unit(wished), tangent);
    for (const Vector3& axis : {Vector3{1.0, 0.0, 0.0}, Vector3{0.0, 1.0, 0.0}}) {
        if (norm(up) < 1e-6) {
            up = across(axis, tangent);
        }
    }
    return unit(up);
}

}  // namespace

Result<PathFrame> rotation_minimising_frame(const ObjectGenerator& path, double from, double to,
                                            const Vector3& up) {
    const Result<CurveSampler> sampler =
        CurveSampler::make(path, CurveSampler::Derivatives::second);
    if (!sampler) {
        return sampler.diagnostics;
    }
    const Result<std::vector<Place>> places = fine_places_on(*sampler, from, to);
    if (!places) {
        return places.diagnostics;
    }
    const std::size_t cells = places->size() - 1;
    std::vector<Vector3> ups{first_up(up, places->front().tangent)};
    for (std::size_t i = 0; i < cells; ++i) {
        if ((*places)[i + 1].point == (*places)[i].point) {
            return error(fmt::format("the path has no velocity at its parameter {:.6g}",
                                     std::lerp(from, to, part(i, cells))),
                         {}, "choose from and to such that the path moves between them");
        }
        ups.push_back(transported(ups.back(), (*places)[i], (*places)[i + 1]));
    }

    PathFrame frame;
    const std::vector<CurveSample> ends = (*sampler)(std::array{from, to});
    frame.closed = at_same_point(ends[0], ends[1]);
    const Vector3& tangent = places->front().tangent;
    const double closing =
        frame.closed ? angle_about(tangent, unit(across(ups.back(), tangent)), ups.front()) : 0.0;

    // The frame's up changes only along the tangent, up' = -(up . tangent') tangent, and by the
    // closing angle.
    std::array<std::vector<double>, 3> values;
    std::array<std::vector<double>, 3> slopes;
    for (std::size_t i = 0; i <= cells; ++i) {
        const Place& place = (*places)[i];
        const double angle = closing * part(i, cells);
        const Vector3 turned =
            std::cos(angle) * ups[i] + std::sin(angle) * cross(place.tangent, ups[i]);
        const Vector3 slope = closing * cross(place.tangent, turned) -
                              dot(turned, place.tangent_by_part) * place.tangent;
        for (std::size_t k = 0; k < 3; ++k) {
            values[k].push_back(turned[k]);
            slopes[k].push_back(slope[k]);
        }
    }
    for (std::size_t k = 0; k < 3; ++k) {
        frame.up[k] = std::make_shared<const expr::Table>(
            expr::hermite_table(0.0, 1.0, values[k], slopes[k]));
    }
    return frame;
}

}  // namespace balcony::camera
