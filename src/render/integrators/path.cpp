// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Path tracing (Kajiya 1986) with next-event estimation and multiple importance sampling by the
// power heuristic (Veach 1997).
//
// The paths of a tile advance together, bounce by bounce: Áfra et al., "Local Shading Coherence
// Extraction for SIMD-Efficient Path Tracing on CPUs" (HPG 2016). The rays of a bounce are traced
// in an order in which neighbours are similar. The shadow rays of the first bounce, which start
// near each other, are traced in packets.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "render/integrators/integrator.hpp"
#include "render/integrators/prefetch.hpp"
#include "render/integrators/ray_order.hpp"
#include "render/sampling/sample_block.hpp"
#include "render/shading/bsdf.hpp"
#include "render/shading/footprint.hpp"

namespace balcony::render {

namespace {

constexpr Color3f black(0.0F, 0.0F, 0.0F);

// A ray to an emissive triangle ends before it by more than the rounding error of the point where
// it meets the triangle, also at a grazing angle.
constexpr float before_emitter = 1.0F - 1e-4F;

bool is_black(const Color3f& color) { return !(largest(color) > 0.0F); }

// The weight of a sample with one density, for a direction that a second method of sampling finds
// with another density.
float power_heuristic(float own, float other) {
    const float ratio = other / own;
    return 1.0F / (1.0F + ratio * ratio);
}

// How often the light of a path has been scattered by now.
struct Bounces {
    std::uint8_t all = 0;
    std::uint8_t diffuse = 0;
    std::uint8_t glossy = 0;
    std::uint8_t transmission = 0;
};

// A path in progress, from the camera.
struct Path {
    Ray ray;          // The one to trace next.
    embree::Hit hit;  // Where it ends.
    Color3f throughput{1.0F};
    V3f eye;                              // The origin of the camera ray.
    LitPoint from{V3f(0.0F), V3f(0.0F)};  // Where the light was scattered last.
    // The density with which the ray's direction was chosen there. 0 if no other method of
    // sampling finds it: the camera ray, or a mirror reflection.
    float pdf = 0.0F;
    Color3f absorption{0.0F};  // Of what the ray passes, per scene unit.
    Sampler sampler;
    std::uint32_t index = 0;   // Of its result.
    std::uint32_t packet = 0;  // Of its camera ray.
    Bounces bounces{};
    std::uint8_t crossings = 0;
    bool is_last = false;  // The ray only collects the light that is emitted where it ends.
};

// Light that reaches the camera if nothing is in its way.
struct ShadowedLight {
    embree::Ray ray;
    Color3f light;
    std::uint32_t index = 0;  // Of the path's result.
    std::uint32_t packet = 0;
    bool direct = false;
};

// A point where the light of a path is scattered.
struct Scattering {
    const Interaction& surface;
    const LitPoint& point;
    const Bsdf& bsdf;
    Bsdf::View view;
};

class PathTracer final : public Integrator {
public:
    PathTracer(const TracedScene& traced, const Settings& settings)
        : tracer_(traced),
          settings_(&settings),
          footprint_scale_(1.0F / std::sqrt(static_cast<float>(settings.samples))),
          textured_(traced.materials.has_textures()) {}

    void trace(std::span<const CameraRay> rays, std::span<Seen> seen) override {
        start(rays, seen);
        while (!active_.empty()) {
            shadowed_.clear();
            advance_all(seen);
            add_shadowed_light(seen);
            trace_next();
        }
    }

private:
    void start(std::span<const CameraRay> rays, std::span<Seen> seen);
    void trace_next();
    void advance_all(std::span<Seen> seen);
    void draw_numbers(std::size_t first);
    void find_surfaces(std::size_t first);
    void add_shadowed_light(std::span<Seen> seen);

    [[nodiscard]] bool advance(Path& path, std::size_t place, Seen& seen);
    void add_distant_light(const Path& path, Seen& seen) const;
    void add_emission(const Path& path, const Interaction& at, Seen& seen) const;
    void light(const Path& path, const Scattering& at, const V3f& random, bool alone);
    [[nodiscard]] bool scatter(Path& path, const Scattering& at, float choice,
                               SampleReader& numbers) const;
    [[nodiscard]] RayDifferentials differentials_after(const Path& path, const Interaction& at,
                                                       const BsdfSample& sample) const;
    void count_bounce(Path& path, BsdfLobe lobe) const;
    [[nodiscard]] static bool survives(Path& path, SampleReader& numbers);
    [[nodiscard]] float lamp_weight(float pdf_of_lamp, float pdf_of_surface) const;
    [[nodiscard]] float scattered_weight(float pdf_of_surface, float pdf_of_lamp) const;
    void add(Seen& seen, const Color3f& light, std::size_t bounces) const;

    SceneTracer tracer_;
    const Settings* settings_;
    float footprint_scale_;
    bool textured_;
    // Of one batch; kept for their memory.
    std::vector<Path> paths_;
    std::vector<std::uint32_t> active_;  // Indices of the paths that go on.
    std::vector<ShadowedLight> shadowed_;
    SampleBlock numbers_;
    std::array<std::optional<Interaction>, SampleBlock::size> surfaces_;
    std::vector<RayOrder::Key> keys_;
    std::vector<std::uint32_t> unordered_;
    RayOrder order_;
};

void PathTracer::start(std::span<const CameraRay> rays, std::span<Seen> seen) {
    std::fill(seen.begin(), seen.end(), Seen{});
    paths_.clear();
    active_.clear();
    for (const CameraRay& one : rays) {
        const auto index = static_cast<std::uint32_t>(paths_.size());
        active_.push_back(index);
        paths_.push_back({.ray = one.ray,
                          .hit = one.first,
                          .eye = one.ray.origin,
                          .sampler = one.sampler,
                          .index = index,
                          .packet = one.packet});
    }
}

// Each ray by itself: packets gain nothing for rays that were scattered, and the result of a ray
// then does not depend on the others.
void PathTracer::trace_next() {
    constexpr std::uint32_t bucket_count = 256;
    constexpr std::size_t steps_to_path = 3;  // Tracing takes longer than shading.
    keys_.clear();
    for (const std::uint32_t i : active_) {
        keys_.push_back({paths_[i].ray.origin, paths_[i].ray.direction});
    }
    unordered_.swap(active_);
    active_.clear();
    const std::span<const std::uint32_t> order = order_.sort(keys_);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::uint32_t k = order[i];
        prefetch(paths_[unordered_[order[std::min(i + steps_to_path, order.size() - 1)]]]);
        Path& path = paths_[unordered_[k]];
        path.hit = tracer_.nearest(path.ray);
        active_.push_back(unordered_[k]);
    }
    // Neighbours then have the same material and need the same memory.
    counting_sort<bucket_count>(active_, unordered_, [&](std::uint32_t i) {
        return paths_[i].hit.instance % bucket_count;
    });
}

// Removes the paths that end. Block by block: the numbers of all paths of a block, then their
// surfaces, then the rest, since the processor computes the same of several paths at once.
void PathTracer::advance_all(std::span<Seen> seen) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < active_.size(); ++k) {
        const std::size_t place = k % SampleBlock::size;
        if (place == 0) {
            draw_numbers(k);
            find_surfaces(k);
        }
        Path& path = paths_[active_[k]];
        if (advance(path, place, seen[path.index])) {
            active_[kept++] = active_[k];
        }
    }
    active_.resize(kept);
}

// Of a block of active paths.
void PathTracer::draw_numbers(std::size_t first) {
    std::array<const Sampler*, SampleBlock::size> samplers{};
    const std::size_t count = std::min(SampleBlock::size, active_.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
        samplers[i] = &paths_[active_[first + i]].sampler;
    }
    numbers_.fill(std::span(samplers).first(count));
}

// Memory is requested so many paths early that it has usually arrived.
void PathTracer::find_surfaces(std::size_t first) {
    constexpr std::size_t steps_to_corners = 4;
    constexpr std::size_t steps_to_triangle = 8;
    constexpr std::size_t steps_to_path = 12;
    const auto hit_in = [&](std::size_t place) -> const embree::Hit& {
        return paths_[active_[std::min(place, active_.size() - 1)]].hit;
    };
    const std::size_t count = std::min(SampleBlock::size, active_.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
        prefetch(paths_[active_[std::min(first + i + steps_to_path, active_.size() - 1)]]);
        tracer_.request_triangle(hit_in(first + i + steps_to_triangle));
        tracer_.request_corners(hit_in(first + i + steps_to_corners));
        const Path& path = paths_[active_[first + i]];
        if (path.hit.any()) {
            surfaces_[i].emplace(tracer_.scene(), path.ray, path.hit);
        }
    }
}

void PathTracer::add_shadowed_light(std::span<Seen> seen) {
    const auto receive = [&](const ShadowedLight& one, float transmittance) {
        if (transmittance > 0.0F) {
            add(seen[one.index], transmittance * one.light, one.direct ? 1 : 2);
        }
    };
    constexpr std::size_t packet_size = embree::Accelerator::packet_size;
    std::array<embree::Ray, packet_size> rays;
    std::array<float, packet_size> transmittances{};
    for (std::size_t begin = 0; begin < shadowed_.size();) {
        std::size_t end = begin;
        while (end < shadowed_.size() && shadowed_[end].direct &&
               shadowed_[end].packet == shadowed_[begin].packet && end - begin < packet_size) {
            rays[end - begin] = shadowed_[end].ray;
            ++end;
        }
        if (end == begin) {
            prefetch(seen[shadowed_[begin].index].radiance);
            receive(shadowed_[begin], tracer_.transmittance(shadowed_[begin].ray));
            ++begin;
            continue;
        }
        tracer_.transmittance(std::span(rays).first(end - begin), transmittances);
        for (std::size_t lane = 0; begin < end; ++begin, ++lane) {
            receive(shadowed_[begin], transmittances[lane]);
        }
    }
}

void PathTracer::add(Seen& seen, const Color3f& light, std::size_t bounces) const {
    Color3f added = light;
    if (bounces > 1 && settings_->clamp_indirect > 0.0F) {
        added *= std::min(1.0F, settings_->clamp_indirect / largest(light));
    }
    seen.radiance += Color4f(added.x, added.y, added.z, 0.0F);
    if (bounces == 0) {
        seen.parts.emission += added;
    } else if (bounces == 1) {
        seen.parts.direct += added;
    }
}

// Adds what the path meets at the end of its ray, and finds the next ray. False where the path
// ends.
bool PathTracer::advance(Path& path, std::size_t place, Seen& seen) {
    if (!path.hit.any()) {
        add_distant_light(path, seen);
        return false;
    }
    const Interaction& at = *surfaces_[place];
    SampleReader numbers(numbers_, place, path.sampler);
    if (!is_black(path.absorption)) {
        const float length = (at.surface.position - path.ray.origin).length();
        path.throughput *=
            Color3f(std::exp(-path.absorption.x * length), std::exp(-path.absorption.y * length),
                    std::exp(-path.absorption.z * length));
    }
    const Appearance& appearance = at.appearance();
    const bool seen_directly = path.bounces.all == 0;
    if (seen_directly && !seen.visible.any && appearance.opacity > 0.0F) {
        seen.visible = tracer_.visible(at);
    }
    if (appearance.opacity < 1.0F && path.crossings < max_crossings &&
        numbers.next() >= appearance.opacity) {
        path.ray.origin = at.surface.start(path.ray.direction);
        path.ray.differentials.origin_x = at.moved.along_x;
        path.ray.differentials.origin_y = at.moved.along_y;
        ++path.crossings;
        return true;
    }
    if (seen_directly) {
        seen.radiance.a = 1.0F;
    }
    add_emission(path, at, seen);
    if (path.is_last || appearance.unlit) {
        return false;
    }
    const V3f to_viewer = -path.ray.direction;
    const Bsdf bsdf = at.bsdf();
    const LitPoint point{at.surface.position,
                         tracer_.lights().are_at_eye() && !seen_directly
                             ? (path.eye - at.surface.position).normalized()
                             : to_viewer,
                         bsdf.lit_side(), path.ray.time};
    const Imath::V2f choices = numbers.next_pair();
    const Imath::V2f at_light = numbers.next_pair();
    const bool ends = path.bounces.all >= settings_->bounces.all && bsdf.material().is_rough() &&
                      settings_->lamp_sampling != LampSampling::surfaces;
    const Scattering here{at, point, bsdf, bsdf.view_from(to_viewer)};
    light(path, here, {choices.x, at_light.x, at_light.y}, ends);
    return !ends && scatter(path, here, choices.y, numbers);
}

void PathTracer::add_distant_light(const Path& path, Seen& seen) const {
    const LightSet& lights = tracer_.lights();
    if (!lights.has_distant()) {
        return;
    }
    const bool seen_directly = path.bounces.all == 0;
    const bool shows_background = !settings_->background && settings_->light.visible;
    if (seen_directly && !(shows_background && lights.has_environment())) {
        return;
    }
    const Color3f arriving = lights.radiance_from(path.ray.direction);
    const float weight =
        path.pdf > 0.0F
            ? scattered_weight(path.pdf, lights.pdf_of_distant(path.from, path.ray.direction))
            : 1.0F;
    add(seen, weight * path.throughput * arriving, path.bounces.all);
    if (seen_directly) {
        seen.radiance.a = 1.0F;
    }
}

void PathTracer::add_emission(const Path& path, const Interaction& at, Seen& seen) const {
    const Appearance& appearance = at.appearance();
    const Color3f& emitted = appearance.unlit ? appearance.base_color : appearance.emission;
    if (is_black(emitted)) {
        return;
    }
    const float distance = (at.surface.position - path.from.position).length();
    const float weight =
        path.pdf > 0.0F && !appearance.unlit
            ? scattered_weight(path.pdf, tracer_.lights().pdf_of_emitter(
                                             path.from, path.ray.direction, distance, path.hit))
            : 1.0F;
    add(seen, weight * path.throughput * emitted, path.bounces.all);
}

// The weight of a direction to a lamp.
float PathTracer::lamp_weight(float pdf_of_lamp, float pdf_of_surface) const {
    switch (settings_->lamp_sampling) {
        case LampSampling::both: return power_heuristic(pdf_of_lamp, pdf_of_surface);
        case LampSampling::lamps: return 1.0F;
        case LampSampling::surfaces: return 0.0F;
    }
    return 0.0F;
}

// The weight of a direction that a surface has scattered light to, and in which a lamp was found.
float PathTracer::scattered_weight(float pdf_of_surface, float pdf_of_lamp) const {
    switch (settings_->lamp_sampling) {
        case LampSampling::both: return power_heuristic(pdf_of_surface, pdf_of_lamp);
        case LampSampling::lamps: return pdf_of_lamp > 0.0F ? 0.0F : 1.0F;
        case LampSampling::surfaces: return 1.0F;
    }
    return 0.0F;
}

// Chooses a light and adds what arrives from it, if nothing is in its way. `alone` says that no
// other method samples light at this surface.
void PathTracer::light(const Path& path, const Scattering& at, const V3f& random, bool alone) {
    const std::optional<LightSample> sample = tracer_.lights().sample(at.point, random);
    if (!sample || !(sample->pdf > 0.0F)) {
        return;
    }
    const Bsdf::Value value = at.bsdf.evaluate(at.view, sample->to_light);
    if (is_black(value.reflected)) {
        return;
    }
    Color3f arriving = sample->radiance;
    if (sample->emitter.any()) {
        arriving *= tracer_.emission(sample->emitter);
    }
    const float weight = sample->delta || alone ? 1.0F : lamp_weight(sample->pdf, value.pdf);
    const Color3f unshadowed = weight / sample->pdf * path.throughput * value.reflected * arriving;
    if (is_black(unshadowed)) {
        return;
    }
    const bool is_direct = path.bounces.all == 0;
    const Surface& surface = at.surface.surface;
    float distance = sample->distance;
    if (distance <= 0.0F) {
        distance = (path.eye - surface.position).length();
    } else if (!sample->delta) {
        distance *= before_emitter;
    }
    shadowed_.push_back(
        {SceneTracer::shadow_ray(surface, sample->to_light, distance, path.ray.time), unshadowed,
         path.index, path.packet, is_direct});
}

// Chooses the next ray, by a number that selects the lobe. False where the path ends.
bool PathTracer::scatter(Path& path, const Scattering& at, float choice,
                         SampleReader& numbers) const {
    const Imath::V2f at_lobe = numbers.next_pair();
    const std::optional<BsdfSample> sample =
        at.bsdf.sample(at.view, {choice, at_lobe.x, at_lobe.y});
    if (!sample) {
        return false;
    }
    path.throughput *= sample->weight;
    count_bounce(path, sample->lobe);
    if (!survives(path, numbers)) {
        return false;
    }
    if (textured_) {
        path.ray.differentials = differentials_after(path, at.surface, *sample);
    }
    const Surface& surface = at.surface.surface;
    path.from = at.point;
    path.pdf = sample->delta ? 0.0F : sample->pdf;
    path.ray.origin =
        sample->transmitted ? surface.start(sample->to_light) : surface.start_to_light();
    path.ray.direction = sample->to_light;
    if (sample->transmitted && !at.surface.appearance().thin_walled) {
        path.absorption = surface.entering ? at.surface.appearance().absorption : black;
    }
    return true;
}

RayDifferentials PathTracer::differentials_after(const Path& path, const Interaction& at,
                                                 const BsdfSample& sample) const {
    if (!sample.delta) {
        return after_rough(path.ray, at.moved, sample.to_light, sample.pdf, footprint_scale_);
    }
    return sample.transmitted
               ? after_refraction(path.ray, at.moved, sample.facet_normal, sample.eta)
               : after_mirror(path.ray, at.moved, sample.facet_normal);
}

// After the largest number of bounces a ray still collects the light of lamps that it meets, for
// which sampling the lamps has left a part.
void PathTracer::count_bounce(Path& path, BsdfLobe lobe) const {
    const BounceLimits& limits = settings_->bounces;
    const auto count = [&path](std::uint8_t& bounces, std::size_t limit) {
        path.is_last = path.is_last || ++bounces > limit;
    };
    count(path.bounces.all, limits.all);
    switch (lobe) {
        case BsdfLobe::diffuse: count(path.bounces.diffuse, limits.diffuse); break;
        case BsdfLobe::glossy: count(path.bounces.glossy, limits.glossy); break;
        case BsdfLobe::transmission: count(path.bounces.transmission, limits.transmission); break;
    }
}

// Russian roulette: a path that carries little light ends, or carries more. By the root of the
// light and not by the light itself: the time that is saved by ending more paths is worth less than
// the noise that it adds.
bool PathTracer::survives(Path& path, SampleReader& numbers) {
    const float probability = std::sqrt(largest(path.throughput));
    if (!(probability < 1.0F)) {
        return true;
    }
    if (!(numbers.next() < probability)) {
        return false;
    }
    path.throughput /= probability;
    return true;
}

}  // namespace

std::unique_ptr<Integrator> make_path(const TracedScene& traced, const Settings& settings) {
    return std::make_unique<PathTracer>(traced, settings);
}

}  // namespace balcony::render
