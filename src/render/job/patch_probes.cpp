// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/patch_probes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "base/parallel_for.hpp"
#include "images/luminance.hpp"
#include "render/integrators/path_state.hpp"
#include "render/job/coarse_rays.hpp"
#include "render/job/point_boxes.hpp"
#include "render/sampling/even_pairs.hpp"
#include "render/sampling/sampler.hpp"
#include "shading/geometry/frame.hpp"

namespace balcony::render {

namespace {

constexpr float pi = std::numbers::pi_v<float>;

// Light is bright from so many times the mean on that surfaces see of each other.
constexpr float bright = 8.0F;

/// A surface on a path from the camera, with the side that the path comes from.
struct Vertex {
    Surface surface;
    V3f normal;
    float time = 0.0F;
    float albedo = 0.0F;    ///< Of its diffuse part.
    float light = 0.0F;     ///< The direct light that this scatters: an estimate.
    float next = 0.0F;      ///< The same of the next surface on the path,
    float arriving = 0.0F;  ///< and with what arrives there by way of others.
    bool is_first = false;
    bool goes_on = false;  ///< Its path does, if the ray meets something.
};

class Look {
public:
    explicit Look(const TracedScene& traced) : tracer_(traced) {}

    [[nodiscard]] float direct_light(const Vertex& at, const V3f& random) const;
    void follow(DifferentialRay ray, Sampler sampler, std::vector<Vertex>& found) const;
    [[nodiscard]] float visible(const Vertex& from, const BrightPoint& point) const;

private:
    SceneTracer tracer_;
};

float Look::direct_light(const Vertex& at, const V3f& random) const {
    const V3f& position = at.surface.position;
    const auto sample = tracer_.lights().sample({position, at.normal, at.normal, at.time}, random);
    if (!sample || !(sample->pdf > 0.0F) || !(sample->to_light.dot(at.normal) > 0.0F)) {
        return 0.0F;
    }
    constexpr float nearly_all = 0.999F;
    Color3f arriving =
        tracer_.transmittance(at.surface, sample->to_light, nearly_all * sample->distance, at.time);
    arriving *= sample->radiance / sample->pdf;
    if (sample->emitter.any()) {
        arriving *= tracer_.emission(sample->emitter, sample->to_light, at.time);
    }
    return luminance(arriving) * sample->to_light.dot(at.normal) * at.albedo / pi;
}

// Every surface scatters evenly.
void Look::follow(DifferentialRay ray, Sampler sampler, std::vector<Vertex>& found) const {
    constexpr std::size_t on_path = 4;
    constexpr std::size_t panes = 8;
    const std::size_t begin = found.size();
    ray.differentials = {};
    std::size_t passed = 0;
    while (found.size() < begin + on_path) {
        const embree::Hit hit = tracer_.nearest(ray);
        if (!hit.any()) {
            break;
        }
        const Interaction at = tracer_.interaction(ray, hit);
        if (!is_black(at.straight(ray.direction)) && passed++ < panes) {
            ray.origin = at.surface.start(ray.direction);
            continue;
        }
        Vertex vertex{at.surface, at.surface.geometric_normal, ray.time};
        vertex.albedo = luminance(at.bsdf().material().diffuse);
        vertex.is_first = found.size() == begin;
        vertex.goes_on = found.size() + 1 < begin + on_path;
        const Imath::V2f choice = sampler.next_pair();
        const Imath::V2f at_light = sampler.next_pair();
        if (vertex.albedo > 0.0F) {
            vertex.light = direct_light(vertex, {choice.x, at_light.x, at_light.y});
        }
        found.push_back(vertex);
        const Imath::V2f numbers = sampler.next_pair();
        ray.direction = Frame(vertex.normal).to_world(sample_cosine(numbers.x, numbers.y));
        ray.origin = at.surface.start(ray.direction);
    }
    for (std::size_t i = found.size(); i-- > begin + 1;) {
        found[i - 1].next = found[i].light;
        found[i - 1].arriving = found[i].light + found[i].albedo * found[i].arriving;
    }
}

// The irradiance by a point, up to a factor; 0 if it is not seen.
float Look::visible(const Vertex& from, const BrightPoint& point) const {
    constexpr float nearly_all = 0.999F;
    const V3f way = point.position - from.surface.position;
    const float distance = way.length();
    const V3f direction = way.normalized();
    const float cosines =
        std::max(0.0F, direction.dot(from.normal)) * std::max(0.0F, -direction.dot(point.normal));
    return cosines > 0.0F && !is_black(tracer_.transmittance(from.surface, direction,
                                                             nearly_all * distance, from.time))
               ? cosines
               : 0.0F;
}

std::vector<Vertex> vertices_of(const TracedScene& traced, const Look& look, PictureRays& rays,
                                const Film& film, const Settings& settings,
                                const std::stop_token& stop) {
    constexpr std::size_t paths_at_point = 4;
    constexpr std::uint32_t seed = 1;
    const rays::Tile grid = coarse_grid(film, settings.time);
    std::vector<Vertex> vertices;
    TileRays coarse;
    for (std::size_t layer = 0; layer < rays.layer_count(); ++layer) {
        rays.find_rays(layer, grid, coarse);
        std::vector<std::vector<Vertex>> rows(grid.height);
        const auto look_along = [&](std::size_t row) {
            for (std::size_t i = 0; i < paths_at_point && !stop.stop_requested(); ++i) {
                const PassNumbers numbers(i, seed);
                for (std::size_t x = 0; x < grid.width; ++x) {
                    const std::size_t at = row * grid.width + x;
                    if (traceable(coarse.all, at)) {
                        look.follow(coarse_ray(traced, grid, coarse, at), {x, row, numbers},
                                    rows[row]);
                    }
                }
            }
        };
        parallel_for(grid.height, look_along, settings.threads);
        for (const std::vector<Vertex>& row : rows) {
            vertices.insert(vertices.end(), row.begin(), row.end());
        }
    }
    return vertices;
}

// Of what surfaces see of each other.
float mean_arriving(const std::vector<Vertex>& vertices) {
    double sum = 0.0;
    std::size_t count = 0;
    for (const Vertex& vertex : vertices) {
        sum += vertex.goes_on ? double{vertex.arriving} : 0.0;
        count += vertex.goes_on ? 1 : 0;
    }
    return count > 0 ? static_cast<float>(sum / static_cast<double>(count)) : 0.0F;
}

// Those that surfaces see, and that are bright by a second estimate, too: the first has chosen
// them.
std::vector<BrightPoint> bright_points(const std::vector<Vertex>& vertices, const Look& look,
                                       float least) {
    constexpr std::size_t estimates = 8;
    std::vector<BrightPoint> found;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Vertex& vertex = vertices[i];
        if (vertex.is_first || !(vertex.light > least)) {
            continue;
        }
        float light = 0.0F;
        for (std::size_t k = estimates * i; k < estimates * (i + 1); ++k) {
            const Imath::V2f at_light = even_pair(k);
            const float choice = (static_cast<float>(k % estimates) + 0.5F) / estimates;
            light += look.direct_light(vertex, {choice, at_light.x, at_light.y}) / estimates;
        }
        if (light > 0.5F * least) {
            found.push_back({vertex.surface.position, vertex.normal, light});
        }
    }
    return found;
}

// With room for what is between the points and around them.
BrightBox box_around(const PointBox& points, std::size_t all_seen) {
    const V3f sides = points.high - points.low;
    const auto count = static_cast<float>(points.points.size());
    const float longest = std::max({sides.x, sides.y, sides.z});
    const V3f& far = points.high.length2() > points.low.length2() ? points.high : points.low;
    const float thickness = std::max(0.01F * longest, 1e-4F * far.length());
    const V3f margin = sides * (0.5F / std::sqrt(count)) + V3f(thickness);
    float light = 0.0F;
    for (const BrightPoint& point : points.points) {
        light += point.light;
    }
    return {points.low - margin, points.high + margin, pi * light / static_cast<float>(all_seen)};
}

PatchProbe probe_of(const Vertex& vertex, float mean) {
    // At least half of the mean is everywhere, as surfaces scatter it.
    const float others = vertex.arriving - (vertex.next > bright * mean ? vertex.next : 0.0F);
    return {vertex.surface.position, pi * (0.5F * mean + others)};
}

LaneFloats seen_from(const Vertex& vertex, const std::vector<PointBox>& boxes, std::size_t number,
                     const Look& look) {
    LaneFloats seen{};
    for (std::size_t k = 0; k < boxes.size(); ++k) {
        const std::vector<BrightPoint>& points = boxes[k].points;
        const BrightPoint& point = points[number % points.size()];
        const float diagonal = (boxes[k].high - boxes[k].low).length();
        const float distance = (point.position - vertex.surface.position).length();
        seen[k] = look.visible(vertex, point) / (distance * distance + 0.1F * diagonal * diagonal);
    }
    return seen;
}

}  // namespace

std::shared_ptr<const BrightPatches> bright_patches(const TracedScene& traced, PictureRays& rays,
                                                    const Film& film, const Settings& settings,
                                                    const std::stop_token& stop) {
    constexpr std::size_t fewest_points = 16;
    constexpr std::size_t vertices_to_look = 7;  // No multiple of those of a path.
    if (traced.lights.are_at_eye() || counts_by_surface(settings.path.bounces)) {
        return nullptr;
    }
    const Look look(traced);
    const std::vector<Vertex> vertices = vertices_of(traced, look, rays, film, settings, stop);
    const float mean = mean_arriving(vertices);
    std::vector<BrightPoint> points = bright_points(vertices, look, bright * mean);
    if (points.size() < fewest_points || stop.stop_requested()) {
        return nullptr;
    }
    const auto all_seen = std::count_if(vertices.begin(), vertices.end(),
                                        [](const Vertex& one) { return !one.is_first; });
    const std::vector<PointBox> groups = point_boxes(std::move(points), BrightPatches::most);
    std::vector<BrightBox> boxes;
    for (const PointBox& group : groups) {
        boxes.push_back(box_around(group, static_cast<std::size_t>(all_seen)));
    }
    std::vector<PatchProbe> probes(vertices.size());
    const auto probe = [&](std::size_t i) {
        probes[i] = probe_of(vertices[i], mean);
        if (i % vertices_to_look == 0 && !stop.stop_requested()) {
            probes[i].seen = seen_from(vertices[i], groups, i / vertices_to_look, look);
        }
    };
    parallel_for(vertices.size(), probe, settings.threads);
    return std::make_shared<const BrightPatches>(boxes, std::move(probes));
}

}  // namespace balcony::render
