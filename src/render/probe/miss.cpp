// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "balcony/probe.hpp"
#include "render/job/camera_rays.hpp"
#include "render/job/coarse_rays.hpp"
#include "render/probe/probed_scene.hpp"

namespace balcony::render {

namespace {

using Imath::V3d;
using Imath::V3f;

struct Line {
    V3d origin;
    V3d direction;
};

// Rays on a coarse grid of the picture.
std::vector<Line> lines_of(const rays::RayProgram& program, const ProbeSettings& settings) {
    constexpr double points = 4096.0;
    rays::Scratch scratch;
    rays::RayBatch batch;
    program.run(coarse_grid(settings.width, settings.height, points, settings.time), scratch,
                batch);
    std::vector<Line> lines;
    for (std::size_t i = 0; i < batch.size(); ++i) {
        if (traceable(batch, i)) {
            lines.push_back({batch.origin(i), batch.direction(i)});
        }
    }
    return lines;
}

// The largest distance of a corner from the origin along an axis.
double max_coordinate(const Imath::Box3d& box) {
    double largest = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        largest = std::max({largest, std::abs(box.min[axis]), std::abs(box.max[axis])});
    }
    return largest;
}

// What these rays would meet.
Miss::Attempt attempt_of(RayChange change, double factor, const std::vector<Line>& lines,
                         const ProbedScene& scene) {
    std::vector<bool> met(scene.scene().objects.size());
    std::size_t hits = 0;
    for (const Line& line : lines) {
        if (!embree::in_range(line.origin)) {
            continue;
        }
        const embree::Hit hit =
            scene.shown().intersect(scene.ray(V3f(line.origin), V3f(line.direction)));
        if (hit.any()) {
            met[scene.object(hit)] = true;
            ++hits;
        }
    }
    return {
        change, factor, static_cast<std::size_t>(std::count(met.begin(), met.end(), true)),
        static_cast<double>(hits) / static_cast<double>(std::max<std::size_t>(lines.size(), 1))};
}

}  // namespace

Result<Miss> explain_miss(const Renderer& renderer, const camera::Camera& camera,
                          const ProbeSettings& settings, const std::stop_token& stop) {
    const Result<ProbedScene> probed = ProbedScene::make(renderer, settings);
    if (!probed) {
        return probed.diagnostics;
    }
    const scene::Scene& scene = probed->scene();
    const Result<rays::RayProgram> program = compile(camera, settings, scene.axes, stop);
    if (!program) {
        return program.diagnostics;
    }
    const std::vector<Line> lines = lines_of(*program, settings);

    Miss miss;
    for (const Line& line : lines) {
        miss.origins.extendBy(line.origin);
    }
    const auto bounds = scene.bounds();
    miss.bounds = {V3d(bounds.min), V3d(bounds.max)};
    if (camera.parts().bend) {
        return miss;  // The other rays that are tried would be straight.
    }
    const auto attempt = [&](RayChange change, double factor, auto changed) {
        std::vector<Line> others;
        others.reserve(lines.size());
        std::transform(lines.begin(), lines.end(), std::back_inserter(others), changed);
        const Miss::Attempt made = attempt_of(change, factor, others, *probed);
        if (made.objects > 0) {
            miss.attempts.push_back(made);
        }
    };
    attempt(RayChange::reversed, 1.0, [](const Line& line) {
        return Line{line.origin, -line.direction};
    });
    attempt(RayChange::other_axes, 1.0, [&](const Line& line) {
        // As if the other axes had been declared: the conversion to the scene's is undone or added.
        const Axes other = camera.parts().axes == Axes::z_up ? Axes::y_up : Axes::z_up;
        const auto declared = [&](const V3d& v) {
            return turned(turned(v, scene.axes, camera.parts().axes), other, scene.axes);
        };
        return Line{declared(line.origin), declared(line.direction)};
    });
    const double ratio = max_coordinate(miss.origins) / max_coordinate(miss.bounds);
    for (const double factor : {1e-3, 1e3}) {
        // The scaled camera must have about the size of the scene.
        if (!(0.1 < factor * ratio && factor * ratio < 10.0)) {
            continue;
        }
        attempt(RayChange::scaled, factor, [factor](const Line& line) {
            return Line{factor * line.origin, line.direction};
        });
    }
    return miss;
}

}  // namespace balcony::render
