// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include <Imath/ImathMatrixAlgo.h>
#include <fmt/format.h>

#include "balcony/object_names.hpp"
#include "balcony/probe.hpp"
#include "render/probe/main_objects.hpp"
#include "render/probe/object_view.hpp"
#include "render/probe/revolution.hpp"
#include "render/probe/triangles.hpp"
#include "render/probe/viewer.hpp"

namespace balcony::render {

namespace {

using Imath::V2d;
using Imath::V3d;
using Box = Imath::Box3d;

// ------------------------------------------------------------------------------------ geometry

/// Calls a function with the ends of every edge of every triangle, with z up.
template <class Function>
void for_each_edge(const scene::Scene& scene, std::optional<std::uint32_t> object,
                   const Function& function) {
    for_each_triangle(scene, object, [&function](const std::array<V3d, 3>& p) {
        for (std::size_t i = 0; i < 3; ++i) {
            function(p[i], p[(i + 1) % 3]);
        }
    });
}

// Cameras whose lengths are sides of the box need sides above 0, also of a flat scene.
Box thickened(const Box& box, double radius) {
    constexpr double least = 0.01;  // Half a side, as a part of the radius.
    const V3d center = 0.5 * (box.min + box.max);
    Box made = box;
    for (int axis = 0; axis < 3; ++axis) {
        const double half = least * (radius > 0.0 ? radius : 1.0);
        made.min[axis] = std::min(box.min[axis], center[axis] - half);
        made.max[axis] = std::max(box.max[axis], center[axis] + half);
    }
    return made;
}

Box turned_box(const Box& box, Axes axes) {
    Box made;
    made.extendBy(turned(box.min, axes, Axes::z_up));
    made.extendBy(turned(box.max, axes, Axes::z_up));
    return made;
}

// ------------------------------------------------------------------------------------- profile

/// The largest distances from a vertical axis, by height.
class Profile {
public:
    explicit Profile(const Box& box)
        : center_(0.5 * (box.min + box.max)),
          low_(box.min.z),
          step_((box.max.z - box.min.z) / static_cast<double>(intervals)) {}

    // On an edge, the distance from the axis is a convex function. So it is largest at the ends of
    // the part of the edge in an interval of heights.
    void add(V3d a, V3d b) {
        if (a.z > b.z) {
            std::swap(a, b);
        }
        const std::size_t first = interval_of(a.z);
        const std::size_t last = interval_of(b.z);
        for (std::size_t i = first; i <= last; ++i) {
            add(i == first ? a : at_height(a, b, height(i)), i);
            add(i == last ? b : at_height(a, b, height(i + 1)), i);
        }
    }

    /// From bottom to top; heights are relative to the centre.
    [[nodiscard]] std::vector<V2d> points(double least_radius) const {
        std::vector<V2d> made;
        for (std::size_t i = 0; i <= intervals; ++i) {
            const double below = i > 0 ? largest_[i - 1] : 0.0;
            const double above = i < intervals ? largest_[i] : 0.0;
            made.emplace_back(std::max({below, above, least_radius}), height(i) - center_.z);
        }
        return made;
    }

private:
    static constexpr std::size_t intervals = 32;

    [[nodiscard]] double height(std::size_t i) const {
        return low_ + step_ * static_cast<double>(i);
    }
    [[nodiscard]] std::size_t interval_of(double z) const {
        const double i = step_ > 0.0 ? (z - low_) / step_ : 0.0;
        return static_cast<std::size_t>(std::clamp(i, 0.0, static_cast<double>(intervals) - 1.0));
    }
    static V3d at_height(const V3d& a, const V3d& b, double z) {
        const double share = std::clamp((z - a.z) / (b.z - a.z), 0.0, 1.0);
        return a + share * (b - a);
    }
    void add(const V3d& p, std::size_t i) {
        largest_[i] = std::max(largest_[i], std::hypot(p.x - center_.x, p.y - center_.y));
    }

    V3d center_;
    double low_, step_;
    std::array<double, intervals> largest_{};
};

// ---------------------------------------------------------------------------------- revolution

/// Samples of equal areas of the triangles in a box.
std::vector<SurfaceSample> surface_samples(const scene::Scene& scene,
                                           std::optional<std::uint32_t> object, const Box& box) {
    constexpr double count = 16384.0;
    const auto normal_of = [&box](const std::array<V3d, 3>& p) {
        const bool inside = box.intersects(p[0]) && box.intersects(p[1]) && box.intersects(p[2]);
        return inside ? (p[1] - p[0]).cross(p[2] - p[0]) : V3d(0.0);
    };
    double area = 0.0;
    for_each_triangle(scene, object, [&](const auto& p) { area += normal_of(p).length(); });
    std::vector<SurfaceSample> samples;
    if (!(area > 0.0)) {
        return samples;
    }
    // A sequence of low discrepancy: Roberts, "The Unreasonable Effectiveness of Quasirandom
    // Sequences" (2018).
    const auto number = [&samples](double step) {
        const double at = 0.5 + step * static_cast<double>(samples.size());
        return at - std::floor(at);
    };
    double before = 0.0;
    for_each_triangle(scene, object, [&](const auto& p) {
        const V3d normal = normal_of(p);
        const double part = normal.length() / area * count;
        while (static_cast<double>(samples.size()) + number(0.8191725133961645) < before + part) {
            double a = number(0.6710436067037893);
            double b = number(0.5497004779019703);
            if (a + b > 1.0) {
                a = 1.0 - a;
                b = 1.0 - b;
            }
            samples.push_back({p[0] + a * (p[1] - p[0]) + b * (p[2] - p[0]), normal.normalized()});
        }
        before += part;
    });
    return samples;
}

/// Points relative to an axis, which is their z, with a point of it as their origin.
class AxisFrame {
public:
    AxisFrame(const V3d& axis, const V3d& origin) : origin_(origin) {
        const Imath::M44d world_from_axis = Imath::rotationMatrix(V3d(0.0, 0.0, 1.0), axis);
        for (int i = 0; i < 3; ++i) {
            sides_[static_cast<std::size_t>(i)] =
                V3d(world_from_axis[i][0], world_from_axis[i][1], world_from_axis[i][2]);
        }
    }

    [[nodiscard]] V3d operator()(const V3d& p) const {
        const V3d from_origin = p - origin_;
        return {from_origin.dot(sides_[0]), from_origin.dot(sides_[1]), from_origin.dot(sides_[2])};
    }

private:
    V3d origin_;
    std::array<V3d, 3> sides_;
};

/// From 0 to 1, from a direction.
double turn_between(double azimuth, const V3d& p) {
    const double turns = (std::atan2(p.y, p.x) - azimuth) / (2.0 * std::numbers::pi);
    return turns - std::floor(turns);
}

/// The middle of the largest gap between the azimuths of points; nothing if it is small.
std::optional<double> middle_of_gap(const std::vector<V3d>& points) {
    constexpr std::size_t parts = 720;
    constexpr std::size_t least = 20;
    std::array<bool, parts> covered{};
    for (const V3d& p : points) {
        covered[std::min(static_cast<std::size_t>(turn_between(0.0, p) * parts), parts - 1)] = true;
    }
    const CircleGap gap = longest_gap(covered);
    const double middle = static_cast<double>(gap.end) - 0.5 * static_cast<double>(gap.length);
    return least <= gap.length && gap.length < parts
               ? std::optional(2.0 * std::numbers::pi / static_cast<double>(parts) * middle)
               : std::nullopt;
}

std::optional<Revolution> find_revolution(const scene::Scene& scene,
                                          std::optional<std::uint32_t> object, const Box& box) {
    const std::vector<SurfaceSample> samples = surface_samples(scene, object, box);
    const std::optional<RevolutionFit> fit = fit_revolution(samples);
    if (!fit) {
        return std::nullopt;
    }
    const auto for_each_part = [&](const auto& function) {
        for_each_edge(scene, object, [&](const V3d& a, const V3d& b) {
            if (box.intersects(a) && box.intersects(b)) {
                function(a, b);
            }
        });
    };
    Box along_axis;
    const AxisFrame from_point(fit->axis, fit->point);
    for_each_part([&](const V3d& a, const V3d&) { along_axis.extendBy(from_point(a)); });
    const double middle = 0.5 * (along_axis.min.z + along_axis.max.z);
    Revolution made{.axis = fit->axis,
                    .center = fit->point + middle * fit->axis,
                    .length = std::max(along_axis.max.z - along_axis.min.z, 0.02 * fit->radius),
                    .radius = fit->radius,
                    .profile = {}};
    const AxisFrame frame(made.axis, made.center);
    const double half = 0.5 * made.length;
    Profile profile(Box(V3d(0.0, 0.0, -half), V3d(0.0, 0.0, half)));
    for_each_part([&](const V3d& a, const V3d& b) {
        const V3d from = frame(a);
        profile.add(from, frame(b));
        made.reach = std::max(made.reach, std::hypot(from.x, from.y));
    });
    made.profile = profile.points(1e-3 * made.reach);

    const auto is_beside = [&made](const V3d& p) {
        return std::hypot(p.x, p.y) > 0.5 * made.radius;
    };
    std::vector<V3d> beside;
    for (const SurfaceSample& sample : samples) {
        if (const V3d p = frame(sample.position); is_beside(p)) {
            beside.push_back(p);
        }
    }
    if (const std::optional<double> gap = middle_of_gap(beside)) {
        double first = 1.0;
        double last = 0.0;
        for_each_part([&](const V3d& a, const V3d&) {
            if (const V3d p = frame(a); is_beside(p)) {
                first = std::min(first, turn_between(*gap, p));
                last = std::max(last, turn_between(*gap, p));
            }
        });
        constexpr double full_turn = 2.0 * std::numbers::pi;
        made.arc = full_turn * (last - first);
        made.arc_middle = std::remainder(*gap + 0.5 * full_turn * (first + last), full_turn);
    }
    return made;
}

// -------------------------------------------------------------------------------------- inside

/// A place to stand in the open.
class Inside {
public:
    Inside(const scene::Scene& scene, const Viewer& viewer, const Box& box,
           const std::stop_token& stop)
        : scene_(scene), viewer_(viewer), box_(box), stop_(stop) {}

    /// Much of the scene is seen from there, nothing is near, and it is near the middle.
    [[nodiscard]] V3d find() const {
        constexpr int steps = 9;
        V3d best = 0.5 * (box_.min + box_.max);
        double highest = 0.0;
        for (int i = 0; i < steps * steps && !stop_.stop_requested(); ++i) {
            const double x = (i % steps + 0.5) / steps;
            const double y = (i / steps + 0.5) / steps;  // NOLINT(bugprone-integer-division)
            for (const double level : {0.5 * (box_.min.z + box_.max.z), box_.min.z}) {
                const V3d point =
                    at_eye_level({between(0, x), between(1, y), level + 1e-3 * size().z});
                const double found = merit(point) * std::exp(-4.0 * (sqr(x - 0.5) + sqr(y - 0.5)));
                if (found > highest) {
                    highest = found;
                    best = point;
                }
            }
        }
        return best;
    }

private:
    static double sqr(double x) { return x * x; }
    [[nodiscard]] V3d size() const { return box_.size(); }
    [[nodiscard]] double between(int axis, double share) const {
        return box_.min[axis] + share * size()[axis];
    }

    // A person's eye level above what is below the point, but at most in the middle of the scene's
    // height, as of an object on a table.
    [[nodiscard]] V3d at_eye_level(const V3d& point) const {
        constexpr double eye_level = 1.6;  // Metres.
        const double ground =
            point.z - viewer_.distance(in_scene(point), in_scene({0.0, 0.0, -1.0}));
        const double floor = std::isfinite(ground) ? std::max(ground, box_.min.z) : box_.min.z;
        const double level =
            std::min(eye_level / scene_.meters_per_unit, 0.5 * (box_.max.z - floor));
        return {point.x, point.y, floor + level};
    }

    // The clearance counts up to a tenth of the scene's width.
    [[nodiscard]] double merit(const V3d& point) const {
        const Sight round = viewer_.look_round(in_scene(point));
        if (2 * round.fronts <= round.hits) {
            return 0.0;  // Within a solid.
        }
        const double enough = 0.1 * std::hypot(size().x, size().y);
        return round.interest() * sqr(std::min(round.nearest / enough, 1.0));
    }

    [[nodiscard]] V3d in_scene(const V3d& v) const { return turned(v, Axes::z_up, scene_.axes); }

    const scene::Scene& scene_;
    const Viewer& viewer_;
    const Box box_;
    const std::stop_token& stop_;
};

// -------------------------------------------------------------------------------------- object

Result<std::optional<std::uint32_t>> find_object(const scene::Scene& scene,
                                                 const std::string& name) {
    if (name.empty()) {
        return std::optional<std::uint32_t>();
    }
    const std::vector<std::uint32_t> found = scene::objects_named(scene, name);
    if (found.empty()) {
        return scene::no_object(
            scene, fmt::format("'{}' has no object '{}'", scene.name, printable(name)), name, {});
    }
    return std::optional(found.front());
}

}  // namespace

Result<SceneExtent> measure_scene(const Renderer& renderer, const std::string& object,
                                  const std::stop_token& stop) {
    const ProbedScene probed(renderer);
    const scene::Scene& scene = probed.scene();
    const auto wanted = find_object(scene, object);
    if (!wanted) {
        return wanted.diagnostics;
    }
    Box box;
    for_each_edge(scene, *wanted, [&box](const V3d& a, const V3d&) { box.extendBy(a); });
    if (box.isEmpty() || !std::isfinite(box.size().length())) {
        return error(object.empty()
                         ? std::string("the scene has no finite size, so no camera fits it")
                         : fmt::format("'{}' has no finite size, so no camera fits it", object),
                     {}, "correct the coordinates of the scene");
    }
    if (const auto main = box_of_main_objects(scene); main && object.empty()) {
        box = turned_box(*main, scene.axes);
    }
    const V3d center = 0.5 * (box.min + box.max);
    SceneExtent extent;
    Profile profile(box);
    for_each_edge(scene, *wanted, [&](V3d a, V3d b) {
        // The surroundings of the main objects are not part of the profile.
        if (box.intersects(a) && box.intersects(b)) {
            profile.add(a, b);
            extent.radius = std::max(extent.radius, std::hypot(a.x - center.x, a.y - center.y));
        }
    });
    extent.bounds = thickened(box, extent.radius);
    extent.profile = profile.points(1e-3 * std::max(extent.radius, 1e-9));
    extent.revolution = find_revolution(scene, *wanted, box);
    const Viewer viewer(probed);
    extent.inside = *wanted ? place_before(scene, viewer, **wanted, box, stop)
                            : Inside(scene, viewer, box, stop).find();
    if (stop.stop_requested()) {
        return stopped();
    }
    return extent;
}

}  // namespace balcony::render
