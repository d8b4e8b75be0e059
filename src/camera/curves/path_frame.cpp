// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/curves/path_frame.hpp"

#include <algorithm>
#include <cmath>
#include <span>

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
struct PathSample {
    double part;
    Vector3 point;
    Vector3 tangent;  ///< Unit length.
    Vector3 tangent_by_part;
};

constexpr std::size_t min_cells = 256;
constexpr std::size_t max_cells = 4096;
/// Up to this angle in radians between its ends, a cubic approximates the frame in a cell to 1e-6.
constexpr double max_turn = 0.1;
constexpr std::size_t max_corners = max_cells / 16;
/// The maximum error of the frame in radians, in a cell and at its end.
constexpr double max_error = 1e-6;

/// A path between two of its parameters.
struct PathRange {
    const CurveSampler& path;
    double from, to;

    [[nodiscard]] double parameter(double part) const { return std::lerp(from, to, part); }
};

Result<std::vector<PathSample>> samples_at(const PathRange& range, std::span<const double> parts) {
    std::vector<double> parameters;
    for (const double part : parts) {
        parameters.push_back(range.parameter(part));
    }
    std::vector<PathSample> samples;
    for (const CurveSample& sample : range.path(parameters)) {
        const double part = parts[samples.size()];
        const double speed = norm(sample.velocity);
        if (std::isnan(norm(sample.point))) {
            return error(
                fmt::format("the path has no point at its parameter {:.6g}", range.parameter(part)),
                {}, "choose from and to such that the path is defined between them");
        }
        if (!(speed > 0.0) || !std::isfinite(norm(sample.acceleration) / speed)) {
            return error(fmt::format("the path has no direction at its parameter {:.6g}",
                                     range.parameter(part)),
                         {}, "use another parametrisation, or a range without this point");
        }
        const Vector3 tangent = unit(sample.velocity);
        samples.push_back(
            {part, sample.point, tangent,
             ((range.to - range.from) / speed) * across(sample.acceleration, tangent)});
    }
    return samples;
}

double angle_between(const Vector3& unit_a, const Vector3& unit_b) {
    return 2.0 * std::asin(std::min(1.0, 0.5 * norm(unit_b - unit_a)));
}

/// Samples so dense that the path hardly turns between two of them. Corners, where it always does,
/// are accepted if there are few.
Result<std::vector<PathSample>> fine_samples(const PathRange& range) {
    for (std::size_t cells = min_cells;; cells *= 2) {
        Result<std::vector<PathSample>> samples = samples_at(range, equal_breaks(cells));
        if (!samples) {
            return samples;
        }
        std::size_t turning = 0;
        for (std::size_t i = 0; i < cells; ++i) {
            const double turn = angle_between((*samples)[i].tangent, (*samples)[i + 1].tangent);
            turning += turn > max_turn ? 1 : 0;
        }
        if (turning == 0 || (cells == max_cells && turning <= max_corners)) {
            return samples;
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
Vector3 transported(const Vector3& up, const PathSample& here, const PathSample& next) {
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

/// The derivative of an upward vector that does not rotate about the tangent: only along the
/// tangent, up' = -(up . tangent') tangent.
Vector3 up_by_part(const Vector3& up, const PathSample& at) {
    return -dot(up, at.tangent_by_part) * at.tangent;
}

/// The error of a cell as an angle: of its cubic in the middle, or of its end as a fraction of the
/// error of the whole way.
double error_of_cell(const PathSample& begin, const PathSample& middle, const PathSample& end) {
    const Vector3 up = first_up({0.0, 0.0, 1.0}, begin.tangent);
    const Vector3 up_middle = transported(up, begin, middle);
    const Vector3 up_end = transported(up, begin, end);
    const double width = end.part - begin.part;
    const Vector3 cubic =
        0.5 * (up + up_end) + 0.125 * width * (up_by_part(up, begin) - up_by_part(up_end, end));
    const double in_middle = angle_about(middle.tangent, across(cubic, middle.tangent), up_middle);
    const double at_end = angle_about(end.tangent, up_end, transported(up_middle, middle, end));
    return std::max(std::fabs(in_middle), std::fabs(at_end) / width);
}

bool stands_still(const PathSample& here, const PathSample& next) {
    return here.point == next.point;
}

/// Halves cells until the error of all is within the limit, or they are as narrow as a position
/// among cells can be: around places where the path's second derivative jumps.
Result<std::vector<PathSample>> refined(const PathRange& range, std::vector<PathSample> samples) {
    std::vector<bool> is_good(samples.size() - 1, false);  // By cell.
    for (;;) {
        std::vector<double> middles;
        for (std::size_t i = 0; i < is_good.size(); ++i) {
            if (!is_good[i]) {
                middles.push_back(0.5 * (samples[i].part + samples[i + 1].part));
            }
        }
        const Result<std::vector<PathSample>> looked_at = samples_at(range, middles);
        if (!looked_at) {
            return looked_at.diagnostics;
        }
        std::vector<PathSample> next;
        std::vector<bool> next_is_good;
        auto middle = looked_at->begin();
        for (std::size_t i = 0; i < is_good.size(); ++i) {
            next.push_back(samples[i]);
            const PathSample& end = samples[i + 1];
            const bool divisible =
                !is_good[i] && end.part - middle->part >= CellPosition::narrowest_cell &&
                !stands_still(samples[i], *middle) && !stands_still(*middle, end);
            const bool divided = divisible && error_of_cell(samples[i], *middle, end) > max_error;
            if (divided) {
                next.push_back(*middle);
                next_is_good.push_back(false);
            }
            next_is_good.push_back(!divided);
            middle += is_good[i] ? 0 : 1;
        }
        next.push_back(samples.back());
        const bool done = next.size() == samples.size();
        samples = std::move(next);
        is_good = std::move(next_is_good);
        if (done) {
            return samples;
        }
    }
}

/// Cubics over the cells in sequence, from values and derivatives with respect to the fraction of
/// the way.
TablePointer cubic_table(std::span<const double> breaks, std::span<const double> values,
                         std::span<const double> slopes) {
    const std::size_t cells = breaks.size() - 1;
    std::vector<double> coefficients;
    for (std::size_t i = 0; i < cells; ++i) {
        const double width = breaks[i + 1] - breaks[i];
        const double rise = values[i + 1] - values[i];
        const double begin = width * slopes[i];
        const double end = width * slopes[i + 1];
        coefficients.insert(coefficients.end(), {values[i], begin, 3.0 * rise - 2.0 * begin - end,
                                                 begin + end - 2.0 * rise});
    }
    return table_of(std::array{cells_axis(cells, 3)}, std::move(coefficients));
}

}  // namespace

PathPlace place_on(const ObjectGenerator& path, Expr parameter, Emitter& emit) {
    Graph& graph = emit.graph();
    const Expr free = graph.fresh_variable();
    Emitter path_emit(graph);
    const ObjectPoint p = path.generate({free, emit(0.0)}, path_emit);
    std::vector<Expr> made{p.x, p.y, p.z};
    for (const std::size_t first : {std::size_t{0}, std::size_t{3}}) {
        const std::vector<Expr> slopes =
            expr::differentiate(std::span(made).subspan(first, 3), free);
        made.insert(made.end(), slopes.begin(), slopes.end());
    }
    made.push_back(path_emit.valid());
    const std::array put{expr::Substitution{free, parameter}};
    const std::vector<Expr> there = expr::substitute(graph, made, put);
    emit.require(there[9]);
    return {{there[0], there[1], there[2]},
            {there[3], there[4], there[5]},
            {there[6], there[7], there[8]}};
}

Result<PathFrame> rotation_minimising_frame(const ObjectGenerator& path, double from, double to,
                                            const Vector3& up) {
    const Result<CurveSampler> sampler =
        CurveSampler::make(path, CurveSampler::Derivatives::second);
    if (!sampler) {
        return sampler.diagnostics;
    }
    const PathRange range{*sampler, from, to};
    Result<std::vector<PathSample>> samples = fine_samples(range);
    if (samples) {
        samples = refined(range, std::move(*samples));
    }
    if (!samples) {
        return samples.diagnostics;
    }
    const std::size_t cells = samples->size() - 1;
    std::vector<Vector3> ups{first_up(up, samples->front().tangent)};
    for (std::size_t i = 0; i < cells; ++i) {
        const PathSample& here = (*samples)[i];
        const PathSample& next = (*samples)[i + 1];
        if (stands_still(here, next)) {
            return error(fmt::format("the path has no velocity at its parameter {:.6g}",
                                     range.parameter(here.part)),
                         {}, "choose from and to such that the path moves between them");
        }
        ups.push_back(transported(ups.back(), here, next));
    }

    PathFrame frame;
    const std::vector<CurveSample> ends = (*sampler)(std::array{from, to});
    frame.closed = at_same_point(ends[0], ends[1]);
    const Vector3& tangent = samples->front().tangent;
    const double closing =
        frame.closed ? angle_about(tangent, unit(across(ups.back(), tangent)), ups.front()) : 0.0;

    std::vector<double> breaks;
    std::array<std::vector<double>, 3> values;
    std::array<std::vector<double>, 3> slopes;
    for (std::size_t i = 0; i <= cells; ++i) {
        const PathSample& sample = (*samples)[i];
        const double angle = closing * sample.part;
        const Vector3 turned =
            std::cos(angle) * ups[i] + std::sin(angle) * cross(sample.tangent, ups[i]);
        const Vector3 slope = closing * cross(sample.tangent, turned) + up_by_part(turned, sample);
        breaks.push_back(sample.part);
        for (std::size_t k = 0; k < 3; ++k) {
            values[k].push_back(turned[k]);
            slopes[k].push_back(slope[k]);
        }
    }
    frame.position = CellPosition(breaks, false);
    for (std::size_t k = 0; k < 3; ++k) {
        frame.up[k] = cubic_table(breaks, values[k], slopes[k]);
    }
    return frame;
}

}  // namespace balcony::camera
