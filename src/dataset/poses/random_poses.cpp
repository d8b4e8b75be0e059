// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <fmt/format.h>

#include "balcony/clearance.hpp"
#include "balcony/names.hpp"
#include "balcony/probe.hpp"
#include "balcony/progress.hpp"
#include "dataset/poses/poses.hpp"

namespace balcony::dataset {

namespace {

// Candidates for each pose that is wanted, before a scene is said to have no room.
constexpr std::size_t tries_per_pose = 1000;
constexpr std::size_t tries_at_once = 64;
// The places from which a candidate may be in sight: where one stands well, and the nearest others.
constexpr std::size_t most_views = 16;

/// Random numbers whose bits the standard defines, so that they are the same everywhere.
class Numbers {
public:
    Numbers(std::uint32_t seed, std::uint32_t stream) {
        std::seed_seq sequence{seed, stream};
        engine_.seed(sequence);
    }
    /// From `least` to below `most`.
    [[nodiscard]] double between(double least, double most) {
        constexpr int unused_bits = 11;
        const double part = static_cast<double>(engine_() >> unused_bits) * 0x1p-53;
        return least + part * (most - least);
    }

private:
    std::mt19937_64 engine_;
};

/// Finds places in the open of a scene. All points are in axes with z up.
class OpenPlaces {
public:
    OpenPlaces(const scene::Scene& scene, const render::Renderer& renderer, const V3d& inside,
               const std::stop_token& stop)
        : scene_(scene), renderer_(renderer), inside_(inside), stop_(stop) {}

    /// For each place, how far surfaces are.
    [[nodiscard]] Result<std::vector<double>> clearances(std::span<const V3d> places) const {
        return render::clearances(scene_, places, Axes::z_up, stop_);
    }

    /// Whether a place that is clear is one of them, which it then joins.
    [[nodiscard]] Result<bool> take(const V3d& place) {
        const Result<bool> seen = is_seen(place);
        if (seen && *seen) {
            taken_.push_back(place);
        }
        return seen;
    }

private:
    [[nodiscard]] Result<bool> is_seen(const V3d& place) const {
        std::vector<V3d> near = taken_;
        const std::size_t count = std::min(near.size(), most_views);
        std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count),
                          near.end(), [&](const V3d& a, const V3d& b) {
                              return (a - place).length2() < (b - place).length2();
                          });
        near.resize(count);
        near.push_back(inside_);
        std::vector<render::SightLine> lines;
        for (const V3d& from : near) {
            lines.push_back({.from = from, .to = place});
        }
        const auto found = render::find_obstacles(renderer_, lines, Axes::z_up, stop_);
        if (!found) {
            return found.diagnostics;
        }
        return std::any_of(found->begin(), found->end(),
                           [](const auto& obstacle) { return !obstacle; });
    }

    const scene::Scene& scene_;
    const render::Renderer& renderer_;
    V3d inside_;
    std::stop_token stop_;
    std::vector<V3d> taken_;
};

Imath::Box3d box_of(const RandomPoses& wanted, const render::SceneExtent& extent, Axes axes) {
    if (!wanted.box) {
        return extent.bounds;
    }
    Imath::Box3d box;
    box.extendBy(turned((*wanted.box)[0], axes, Axes::z_up));
    box.extendBy(turned((*wanted.box)[1], axes, Axes::z_up));
    return box;
}

struct Candidate {
    V3d place{0.0};
    double yaw = 0.0, pitch = 0.0, roll = 0.0;
};

std::vector<Candidate> drawn(const RandomPoses& wanted, const Imath::Box3d& box, Numbers& numbers) {
    std::vector<Candidate> made(tries_at_once);
    for (Candidate& one : made) {
        for (int axis = 0; axis < 3; ++axis) {
            one.place[axis] = numbers.between(box.min[axis], box.max[axis]);
        }
        one.yaw = numbers.between(wanted.yaw.least, wanted.yaw.most);
        one.pitch = numbers.between(wanted.pitch.least, wanted.pitch.most);
        one.roll = numbers.between(wanted.roll.least, wanted.roll.most);
    }
    return made;
}

}  // namespace

camera::Pose pose_at(const V3d& place, double yaw, double pitch, double roll) {
    const V3d ahead(std::cos(pitch) * std::cos(yaw), std::cos(pitch) * std::sin(yaw),
                    std::sin(pitch));
    const V3d level(-std::sin(yaw), std::cos(yaw), 0.0);  // To the left.
    const V3d above = ahead.cross(level);
    const V3d left = std::cos(roll) * level + std::sin(roll) * above;
    const V3d up = std::cos(roll) * above - std::sin(roll) * level;
    camera::Pose pose{.rotation = {}, .position = {place.x, place.y, place.z}};
    for (int i = 0; i < 3; ++i) {
        pose.rotation[static_cast<std::size_t>(i)] = {ahead[i], left[i], up[i]};
    }
    return pose;
}

Result<std::vector<camera::Pose>> random_poses(const RandomPoses& wanted, const scene::Scene& scene,
                                               const render::Renderer& renderer, std::uint32_t seed,
                                               std::uint32_t stream, const std::stop_token& stop) {
    const auto extent = render::measure_scene(renderer, {}, stop);
    if (!extent) {
        return extent.diagnostics;
    }
    const Imath::Box3d box = box_of(wanted, *extent, scene.axes);
    constexpr double usual_part = 1.0 / 50.0;  // Of the width of the scene.
    const V3d size = extent->bounds.size();
    const double clearance = wanted.clearance.value_or(usual_part * std::hypot(size.x, size.y));
    Numbers numbers(seed, stream);
    OpenPlaces open(scene, renderer, extent->inside, stop);
    std::vector<camera::Pose> made;
    for (std::size_t tried = 0; tried < wanted.count * tries_per_pose; tried += tries_at_once) {
        const std::vector<Candidate> candidates = drawn(wanted, box, numbers);
        std::vector<V3d> places;
        for (const Candidate& one : candidates) {
            places.push_back(one.place);
        }
        const auto clearances = open.clearances(places);
        if (!clearances) {
            return clearances.diagnostics;
        }
        for (std::size_t i = 0; i < candidates.size() && made.size() < wanted.count; ++i) {
            const Candidate& one = candidates[i];
            const Result<bool> is_open =
                (*clearances)[i] >= clearance ? open.take(one.place) : Result<bool>(false);
            if (!is_open) {
                return is_open.diagnostics;
            }
            if (*is_open) {
                made.push_back(pose_at(one.place, one.yaw, one.pitch, one.roll));
            }
        }
        if (made.size() == wanted.count) {
            return made;
        }
    }
    return error(Kind::usage,
                 fmt::format("'{}' has room for {} at random, not for {}, {} from all surfaces",
                             scene.name, counted(made.size(), "pose"), wanted.count, clearance),
                 "make the clearance smaller, or give a box in the open");
}

}  // namespace balcony::dataset
