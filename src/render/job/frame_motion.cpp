// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/frame_motion.hpp"

#include <algorithm>

namespace balcony::render {

namespace {

using Imath::V2d;

V2d center(const Region& region, std::size_t i) {
    return {static_cast<double>(region.x + i % region.width) + 0.5,
            static_cast<double>(region.y + i / region.width) + 0.5};
}

}  // namespace

FrameMotion::Way::Way(const scene::Scene& scene, const scene::TimeInterval& times)
    : interval(times), movement(scene::movement(scene, times)), steps(scene, movement) {}

FrameMotion::FrameMotion(const scene::Scene& scene, const FrameSettings& frames,
                         const scene::TimeInterval& times)
    : scene_(&scene),
      frames_(frames),
      before_(scene, {times.begin - frames.duration, times.end}),
      after_(scene, {times.begin, times.end + frames.duration}) {}

// The point of the surface at another time.
V3d FrameMotion::moved(const Way& way, const PointData& point, double time) const {
    const VisibleSurface& hit = point.visible;
    if (!hit.any) {
        return point.end;
    }
    const scene::MeshIndex mesh = scene_->instances[hit.instance].mesh;
    if (way.steps.matrices(hit.instance).size() == 1 && way.steps.shape_count(mesh) == 1) {
        return point.end;
    }
    const auto& corners = scene_->meshes[mesh.value()]->triangles[hit.triangle];
    const auto place = [&](double when) {
        const auto part = static_cast<float>(way.interval.part_at(when));
        const auto corner = [&](std::size_t i) {
            return V3d(way.steps.position(mesh, corners[i], part));
        };
        const double u = hit.u;
        const double v = hit.v;
        return ((1.0 - u - v) * corner(0) + u * corner(1) + v * corner(2)) *
               way.steps.matrix(hit.instance, part);
    };
    return point.end + place(time) - place(point.time);
}

// Where another picture shows the points. Points without a ray are found nowhere.
std::vector<rays::ImagePoint> FrameMotion::places(const rays::ImagePointFinder* picture,
                                                  const Way& way, double later,
                                                  const Region& region,
                                                  std::span<const PointData> points) const {
    std::vector<rays::ImagePoint> found(points.size(), rays::ImagePoint{0, V2d(0.0)});
    if (picture == nullptr) {
        return found;
    }
    std::vector<rays::ImagePointQuery> queries;
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i].valid) {
            queries.push_back({moved(way, points[i], points[i].time + later),
                               static_cast<std::size_t>(points[i].layer - 1), center(region, i)});
            indices.push_back(i);
        }
    }
    std::vector<rays::ImagePoint> answers(queries.size());
    picture->find(queries, answers);
    for (std::size_t k = 0; k < indices.size(); ++k) {
        found[indices[k]] = answers[k];
    }
    return found;
}

void FrameMotion::find(const Region& region, const Region& counted, std::span<PointData> points,
                       MotionCounts& counts) const {
    const auto before = places(frames_.previous.get(), before_, -frames_.duration, region, points);
    const auto after = places(frames_.next.get(), after_, frames_.duration, region, points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool counts_here =
            points[i].visible.any &&
            counted.contains(region.x + i % region.width, region.y + i / region.width);
        if (before[i].places == 0 && after[i].places == 0) {
            counts.unknown += counts_here ? 1 : 0;
            continue;
        }
        counts.ambiguous += counts_here && std::max(before[i].places, after[i].places) > 1 ? 1 : 0;
        const V2d here = center(region, i);
        V2d came = before[i].position - here;
        V2d goes = here - after[i].position;
        if (before[i].places == 0) {
            came = goes;
        } else if (after[i].places == 0) {
            goes = came;
        }
        points[i].motion = V4f(static_cast<float>(came.x), static_cast<float>(-came.y),
                               static_cast<float>(goes.x), static_cast<float>(-goes.y));
    }
}

}  // namespace balcony::render
