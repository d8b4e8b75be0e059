// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/probe/revolution.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <Imath/ImathMatrixAlgo.h>

#include "balcony/median.hpp"

namespace balcony::render {

namespace {

using Imath::V2d;
using Imath::V3d;

constexpr std::size_t heights = 24;
constexpr int unknowns = 4;
using Unknowns = Imath::V4d;

struct AxisGuess {
    V3d direction{0.0, 0.0, 1.0};
    V3d point{0.0};
};

// Unit vectors at right angles to an axis and to each other.
std::pair<V3d, V3d> sides_of_axis(const V3d& axis) {
    const V3d other = std::abs(axis.x) < 0.6 ? V3d(1.0, 0.0, 0.0) : V3d(0.0, 1.0, 0.0);
    const V3d first = axis.cross(other).normalized();
    return {first, axis.cross(first)};
}

/// A sample relative to an axis.
struct SeenFromAxis {
    double height = 0.0;
    double distance = 0.0;
    V2d side{0.0};  ///< The unit vector from the axis, in the directions of sides_of_axis().
    std::size_t group = 0;
    double upright =
        0.0;  ///< How much the surface runs along the axis: 0 of a bottom, 1 of a wall.
    double weight = 0.0;
    double residual = 0.0;  ///< The distance minus that of the profile.
};

/// The profile in an interval of heights, of the inner or the outer side: a line.
struct ProfileLine {
    double weight = 0.0, height = 0.0, distance = 0.0, slope = 0.0;

    [[nodiscard]] double at(double h) const { return distance + slope * (h - height); }
};

// Lines of a value of each place over its height, by least squares.
template <class Value>
std::array<ProfileLine, 2 * heights> profile_lines(const std::vector<SeenFromAxis>& places,
                                                   const Value& value) {
    struct Sums {
        double w = 0.0, h = 0.0, v = 0.0, hh = 0.0, hv = 0.0;
    };
    std::array<Sums, 2 * heights> sums;
    for (const SeenFromAxis& p : places) {
        Sums& s = sums[p.group];
        const double v = value(p);
        s.w += p.weight;
        s.h += p.weight * p.height;
        s.v += p.weight * v;
        s.hh += p.weight * p.height * p.height;
        s.hv += p.weight * p.height * v;
    }
    std::array<ProfileLine, 2 * heights> lines;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const Sums& s = sums[i];
        if (s.w > 0.0) {
            const double spread = s.hh - s.h * s.h / s.w;
            lines[i] = {s.w, s.h / s.w, s.v / s.w,
                        spread > 1e-12 * s.hh ? (s.hv - s.h * s.v / s.w) / spread : 0.0};
        }
    }
    return lines;
}

/// Looks for an axis by the method of Gauss and Newton with the profile eliminated (variable
/// projection), and weights that fall with the residual (Geman and McClure). Lengths are relative
/// to the size of what is fitted, whose middle is the origin.
class AxisSearch {
public:
    AxisSearch(std::span<const SurfaceSample> samples, const V3d& middle, double size)
        : samples_(samples.begin(), samples.end()) {
        for (SurfaceSample& sample : samples_) {
            sample.position = (sample.position - middle) / size;
        }
    }

    /// From the circle through the samples as seen along a direction.
    [[nodiscard]] AxisGuess from(const V3d& direction) const {
        return from(AxisGuess{direction, circle_centre(direction)});
    }
    [[nodiscard]] AxisGuess from(AxisGuess axis) const {
        double scale = spread(axis);
        for (int i = 0; i < 16; ++i) {
            const Unknowns step = next_step(axis, scale);
            const double before = cost(axis, scale);
            AxisGuess next = axis;
            double after = before;
            for (double part = 1.0; part > 0.01 && !(after < before); part *= 0.5) {
                next = moved(axis, step, part);
                after = cost(next, scale);
            }
            if (!(after < before)) {
                break;
            }
            axis = next;
            scale = std::min(scale, spread(axis));
        }
        // What hardly tells which way its axis leans, such as a sphere, has an upright one.
        const AxisGuess upright{{0.0, 0.0, 1.0}, axis.point};
        return spread(upright) <= 1.05 * spread(axis) ? upright : axis;
    }

    /// The samples with their weights; a residual of three times the scale halves them twice.
    [[nodiscard]] std::vector<SeenFromAxis> places(const AxisGuess& axis, double scale) const {
        std::vector<SeenFromAxis> made = unweighted(axis);
        for (SeenFromAxis& p : made) {
            p.weight = p.upright / std::pow(1.0 + std::pow(p.residual / (3.0 * scale), 2), 2);
        }
        set_residuals(made);
        return made;
    }

    /// The median of the residuals of what runs along the axis.
    [[nodiscard]] double spread(const AxisGuess& axis) const {
        std::vector<double> residuals;
        for (const SeenFromAxis& p : unweighted(axis)) {
            if (p.upright > 0.25) {
                residuals.push_back(std::abs(p.residual));
            }
        }
        constexpr double rounding = 1e-7;  // Of coordinates in single precision.
        return std::max(median(std::move(residuals)).value_or(1.0), rounding);
    }

    /// The smallest sum of squared components along a direction that normals have: of a cylinder,
    /// its axis.
    [[nodiscard]] V3d least_normal() const {
        Imath::M33d products(0.0);
        for (const SurfaceSample& sample : samples_) {
            for (int i = 0; i < 3; ++i) {
                for (int j = 0; j < 3; ++j) {
                    products[i][j] += sample.normal[i] * sample.normal[j];
                }
            }
        }
        V3d least(0.0, 0.0, 1.0);
        Imath::minEigenVector(products, least);
        return least.normalized();
    }

private:
    // By least squares of the equation of a circle (Kasa, 1976).
    [[nodiscard]] V3d circle_centre(const V3d& direction) const {
        const auto [e1, e2] = sides_of_axis(direction);
        Imath::M33d matrix(0.0);
        V3d right(0.0);
        for (const SurfaceSample& sample : samples_) {
            const V3d row(sample.position.dot(e1), sample.position.dot(e2), 1.0);
            const double square = row.x * row.x + row.y * row.y;
            for (int i = 0; i < 3; ++i) {
                for (int j = 0; j < 3; ++j) {
                    matrix[i][j] += row[i] * row[j];
                }
                right[i] += square * row[i];
            }
        }
        if (!(std::abs(matrix.determinant()) > 0.0)) {
            return V3d(0.0);
        }
        const V3d solution = right * matrix.inverse();
        return 0.5 * (solution.x * e1 + solution.y * e2);
    }

    [[nodiscard]] std::vector<SeenFromAxis> unweighted(const AxisGuess& axis) const {
        const auto [e1, e2] = sides_of_axis(axis.direction);
        std::vector<SeenFromAxis> made(samples_.size());
        double low = 0.0;
        double high = 0.0;
        for (std::size_t i = 0; i < made.size(); ++i) {
            const V3d from_point = samples_[i].position - axis.point;
            SeenFromAxis& p = made[i];
            p.height = from_point.dot(axis.direction);
            p.side = {from_point.dot(e1), from_point.dot(e2)};
            p.distance = p.side.length();
            p.side = p.distance > 0.0 ? p.side / p.distance : V2d(1.0, 0.0);
            low = i == 0 ? p.height : std::min(low, p.height);
            high = i == 0 ? p.height : std::max(high, p.height);
        }
        const double step = std::max(high - low, 1e-12) / static_cast<double>(heights);
        for (std::size_t i = 0; i < made.size(); ++i) {
            SeenFromAxis& p = made[i];
            const double outwards =
                samples_[i].normal.dot(e1) * p.side.x + samples_[i].normal.dot(e2) * p.side.y;
            const auto interval =
                std::min(static_cast<std::size_t>((p.height - low) / step), heights - 1);
            p.group = 2 * interval + (outwards > 0.0 ? 1 : 0);
            p.upright = outwards * outwards;
            p.weight = p.upright;
        }
        set_residuals(made);
        return made;
    }

    static void set_residuals(std::vector<SeenFromAxis>& places) {
        const auto lines = profile_lines(places, [](const SeenFromAxis& p) { return p.distance; });
        for (SeenFromAxis& p : places) {
            p.residual = p.distance - lines[p.group].at(p.height);
        }
    }

    // Of Geman and McClure, relative to how much there is that runs along the axis.
    [[nodiscard]] double cost(const AxisGuess& axis, double scale) const {
        double sum = 0.0;
        double all = 1e-12;
        for (const SeenFromAxis& p : places(axis, scale)) {
            const double square = std::pow(p.residual / (3.0 * scale), 2);
            sum += p.upright * square / (1.0 + square);
            all += p.upright;
        }
        return sum / all;
    }

    // How the residuals change with the point, along sides_of_axis(), and with the direction.
    static Unknowns derivative(const SeenFromAxis& p, double slope) {
        const double arm = p.height + slope * p.distance;
        return {-p.side.x, -p.side.y, -arm * p.side.x, -arm * p.side.y};
    }

    [[nodiscard]] Unknowns next_step(const AxisGuess& axis, double scale) const {
        const std::vector<SeenFromAxis> all = places(axis, scale);
        const auto profile = profile_lines(all, [](const SeenFromAxis& p) { return p.distance; });
        std::array<std::array<ProfileLine, 2 * heights>, unknowns> parts;
        for (int k = 0; k < unknowns; ++k) {
            parts[static_cast<std::size_t>(k)] = profile_lines(all, [&](const SeenFromAxis& p) {
                return derivative(p, profile[p.group].slope)[k];
            });
        }
        Imath::M44d matrix(0.0);
        Unknowns right(0.0);
        for (const SeenFromAxis& p : all) {
            Unknowns row = derivative(p, profile[p.group].slope);
            for (int k = 0; k < unknowns; ++k) {
                row[k] -= parts[static_cast<std::size_t>(k)][p.group].at(p.height);
            }
            for (int k = 0; k < unknowns; ++k) {
                for (int m = 0; m < unknowns; ++m) {
                    matrix[k][m] += p.weight * row[k] * row[m];
                }
                right[k] -= p.weight * row[k] * p.residual;
            }
        }
        // A sphere has any axis.
        for (int k = 0; k < unknowns; ++k) {
            matrix[k][k] += 1e-9 * matrix[k][k] + 1e-12;
        }
        return right * matrix.inverse();
    }

    // The point stays beside the middle.
    static AxisGuess moved(const AxisGuess& axis, const Unknowns& step, double part) {
        const auto [e1, e2] = sides_of_axis(axis.direction);
        AxisGuess made;
        made.direction = (axis.direction + part * (step[2] * e1 + step[3] * e2)).normalized();
        made.point = axis.point + part * (step[0] * e1 + step[1] * e2);
        made.point -= made.point.dot(made.direction) * made.direction;
        return made;
    }

    std::vector<SurfaceSample> samples_;
};

// The angle around the axis that places cover, but for gaps of a few degrees.
double arc_of(const std::vector<SeenFromAxis>& places) {
    constexpr std::size_t parts = 72;
    std::array<bool, parts> covered{};
    for (const SeenFromAxis& p : places) {
        const double turn = std::atan2(p.side.y, p.side.x) / (2.0 * std::numbers::pi) + 0.5;
        covered[std::min(static_cast<std::size_t>(turn * parts), parts - 1)] |= p.upright > 0.25;
    }
    return 2.0 * std::numbers::pi *
           (1.0 - static_cast<double>(longest_gap(covered).length) / static_cast<double>(parts));
}

// Of the outer side, unless there is little of it.
double largest_radius(const std::vector<SeenFromAxis>& places) {
    const auto lines = profile_lines(places, [](const SeenFromAxis& p) { return p.distance; });
    std::array<double, 2> areas{};
    for (std::size_t i = 0; i < lines.size(); ++i) {
        areas[i % 2] += lines[i].weight;
    }
    const std::size_t side = areas[1] > 0.2 * (areas[0] + areas[1]) ? 1 : 0;
    double radius = 0.0;
    for (std::size_t i = side; i < lines.size(); i += 2) {
        const bool is_part = lines[i].weight > 0.25 * areas[side] / static_cast<double>(heights);
        radius = is_part ? std::max(radius, lines[i].distance) : radius;
    }
    return radius;
}

// Whether most of a surface is near the profile: within a twentieth of the depth of its arc, from
// which a wall that hardly bends is as far as one that is no surface of revolution.
bool is_near(const std::vector<SeenFromAxis>& places, double radius) {
    constexpr double largest_radius_of_an_arc = 10.0;  // Of the size.
    const double depth = radius * (1.0 - std::cos(0.5 * arc_of(places)));
    double near = 0.0;
    double all = 0.0;
    for (const SeenFromAxis& p : places) {
        near += std::abs(p.residual) <= 0.05 * depth ? p.upright : 0.0;
        all += p.upright;
    }
    return radius < largest_radius_of_an_arc && all > 0.25 * static_cast<double>(places.size()) &&
           near > 0.75 * all;
}

}  // namespace

CircleGap longest_gap(std::span<const bool> covered) {
    const std::size_t parts = covered.size();
    CircleGap gap;
    std::size_t length = 0;
    for (std::size_t i = 0; i < 2 * parts && gap.length < parts; ++i) {
        length = covered[i % parts] ? 0 : length + 1;
        if (length > gap.length) {
            gap = {length, i + 1};
        }
    }
    return gap;
}

std::optional<RevolutionFit> fit_revolution(std::span<const SurfaceSample> samples) {
    if (samples.empty()) {
        return std::nullopt;
    }
    V3d middle(0.0);
    for (const SurfaceSample& sample : samples) {
        middle += sample.position / static_cast<double>(samples.size());
    }
    double size = 0.0;
    for (const SurfaceSample& sample : samples) {
        size = std::max(size, (sample.position - middle).length());
    }
    if (!(size > 0.0)) {
        return std::nullopt;
    }
    std::vector<SurfaceSample> few;
    for (std::size_t i = 0; i < samples.size(); i += 8) {
        few.push_back(samples[i]);
    }
    const AxisSearch search(few, middle, size);
    std::optional<AxisGuess> best;
    double least = 0.0;
    // What is upright is taken for it, unless another axis is much better.
    for (const V3d& start :
         {V3d(0.0, 0.0, 1.0), search.least_normal(), V3d(1.0, 0.0, 0.0), V3d(0.0, 1.0, 0.0)}) {
        const AxisGuess axis = search.from(start);
        const double spread = search.spread(axis);
        const std::vector<SeenFromAxis> places = search.places(axis, spread);
        if (is_near(places, largest_radius(places)) && (!best || spread < 0.5 * least)) {
            best = axis;
            least = spread;
        }
    }
    if (!best) {
        return std::nullopt;
    }
    const AxisSearch all(samples, middle, size);
    const AxisGuess axis = all.from(*best);
    const double radius = largest_radius(all.places(axis, all.spread(axis)));
    return RevolutionFit{axis.direction.z < 0.0 ? -axis.direction : axis.direction,
                         middle + size * axis.point, size * radius};
}

}  // namespace balcony::render
