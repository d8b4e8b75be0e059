// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Path tracing (Kajiya 1986) with next-event estimation and multiple importance sampling.
//
// The paths of a tile advance together, bounce by bounce: Áfra et al., "Local Shading Coherence
// Extraction for SIMD-Efficient Path Tracing on CPUs" (HPG 2016). The rays of a bounce are traced
// in an order in which neighbours are similar.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "render/integrators/integrator.hpp"
#include "render/integrators/lamp_weights.hpp"
#include "render/integrators/path_state.hpp"
#include "render/integrators/prefetch.hpp"
#include "render/integrators/ray_order.hpp"
#include "render/integrators/shadow_rays.hpp"
#include "render/integrators/shared_tails.hpp"
#include "render/sampling/sample_block.hpp"
#include "render/tracing/bsdf_block.hpp"
#include "shading/materials/footprint.hpp"

namespace balcony::render {

namespace {

// A ray to an emissive triangle ends before it by more than the rounding error of the point where
// it meets the triangle, also at a grazing angle.
constexpr float before_emitter = 1.0F - 1e-4F;

class PathTracer final : public Integrator {
public:
    PathTracer(const TracedScene& traced, const Settings& settings)
        : tracer_(traced),
          settings_(&settings),
          weights_{settings.path.lamp_sampling},
          footprint_scale_(1.0F / std::sqrt(static_cast<float>(settings.samples))),
          textured_(traced.materials.has_textures()),
          shares_(SharedTails::can_share(traced, settings.path)) {}

    void trace(std::span<const CameraRay> rays, std::span<Seen> seen) override {
        start(rays, seen);
        while (!active_.empty()) {
            shadowed_.clear();
            advance_all(seen);
            add_shadowed_light(seen);
            trace_next();
        }
        if (shares_) {
            tails_.add_light(tracer_, settings_->path.clamp_indirect, seen);
        }
    }

private:
    static constexpr std::size_t block_size = SampleBlock::size;
    static_assert(block_size == BsdfBlock::size);

    void start(std::span<const CameraRay> rays, std::span<Seen> seen);
    void trace_next();
    void advance_all(std::span<Seen> seen);
    void draw_numbers(std::size_t first);
    void find_surfaces(std::size_t first);
    void add_shadowed_light(std::span<Seen> seen);

    // What becomes of a path where its ray ends.
    enum class Encounter : std::uint8_t { ends, passes, scatters };
    [[nodiscard]] Encounter meet(Path& path, std::size_t place, Seen& seen);
    void add_distant_light(const Path& path, Seen& seen);
    void add_emission(const Path& path, const Interaction& at, Seen& seen);
    [[nodiscard]] LaneBits scatter_all(std::size_t first, LaneBits scattering);
    [[nodiscard]] bool choose_light(std::size_t place);
    void add_lamp(const Path& path, std::size_t place, bool alone);
    [[nodiscard]] bool scatter(Path& path, std::size_t place);
    void end_head(Path& path, std::size_t place);
    void begin_tail(Path& path, std::size_t place);
    void go_on_from_tail(Path& path, const BsdfSample& sample);
    void receive(const Path& path, Seen& seen, const Color3f& light);
    void add(Seen& seen, const Color3f& light, std::size_t bounces) const;

    SceneTracer tracer_;
    const Settings* settings_;
    LampWeights weights_;
    float footprint_scale_;
    bool textured_;
    bool shares_;
    // Of one batch; kept for their memory.
    std::vector<Path> paths_;
    std::vector<std::uint32_t> active_;  // Indices of the paths that go on.
    ShadowRays shadowed_;
    std::vector<RayOrder::Key> keys_;
    std::vector<std::uint32_t> unordered_;
    RayOrder order_;
    SharedTails tails_;
    // Of one block of paths.
    SampleBlock numbers_;
    std::array<std::optional<SampleReader>, block_size> readers_;
    std::array<std::optional<Interaction>, block_size> surfaces_;
    std::array<LitPoint, block_size> points_;
    std::array<float, block_size> choices_{};  // They select lobes.
    std::array<std::optional<LightSample>, block_size> lamps_;
    BsdfBlock bsdfs_;
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
                          .packet = one.packet,
                          .part = shares_ ? Part::head : Part::whole});
    }
    if (shares_) {
        tails_.begin(rays);
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
// surfaces, then what these reflect, since the processor computes the same of several paths at
// once.
void PathTracer::advance_all(std::span<Seen> seen) {
    std::size_t kept = 0;
    for (std::size_t first = 0; first < active_.size(); first += block_size) {
        draw_numbers(first);
        find_surfaces(first);
        bsdfs_.clear();
        LaneBits scattering = 0;
        LaneBits going_on = 0;
        const std::size_t count = std::min(block_size, active_.size() - first);
        for (std::size_t place = 0; place < count; ++place) {
            Path& path = paths_[active_[first + place]];
            switch (meet(path, place, seen[path.index])) {
                case Encounter::ends: break;
                case Encounter::passes: going_on |= lane_bit(place); break;
                case Encounter::scatters: scattering |= lane_bit(place); break;
            }
        }
        going_on |= scatter_all(first, scattering);
        for_each_lane(going_on,
                      [&](std::size_t place) { active_[kept++] = active_[first + place]; });
    }
    active_.resize(kept);
}

// Lights the paths of a block that are scattered, and finds their next rays. Returns those that go
// on.
LaneBits PathTracer::scatter_all(std::size_t first, LaneBits scattering) {
    const auto path_at = [&](std::size_t place) -> Path& { return paths_[active_[first + place]]; };
    bsdfs_.set_views();
    LaneBits lit = 0;
    LaneBits alone = 0;  // No other method than sampling lamps finds their light.
    for_each_lane(scattering, [&](std::size_t place) {
        const Path& path = path_at(place);
        const bool ends = path.bounces.all >= settings_->path.bounces.all &&
                          bsdfs_.material(place).is_rough() &&
                          settings_->path.lamp_sampling != LampSampling::surfaces;
        alone |= ends ? lane_bit(place) : 0;
        lit |= choose_light(place) ? lane_bit(place) : 0;
    });
    bsdfs_.evaluate(lit);
    for_each_lane(lit, [&](std::size_t place) {
        add_lamp(path_at(place), place, (alone & lane_bit(place)) != 0);
    });
    const LaneBits going_on = scattering & ~alone;
    for_each_lane(going_on, [&](std::size_t place) {
        const Imath::V2f at_lobe = readers_[place]->next_pair();
        bsdfs_.set_numbers(place, {choices_[place], at_lobe.x, at_lobe.y});
    });
    bsdfs_.sample(going_on);
    LaneBits scattered = 0;
    for_each_lane(going_on, [&](std::size_t place) {
        scattered |= scatter(path_at(place), place) ? lane_bit(place) : 0;
    });
    return scattered;
}

// Of a block of active paths.
void PathTracer::draw_numbers(std::size_t first) {
    std::array<const Sampler*, SampleBlock::size> samplers{};
    const std::size_t count = std::min(SampleBlock::size, active_.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
        samplers[i] = &paths_[active_[first + i]].sampler;
    }
    numbers_.fill(std::span(samplers).first(count));
    for (std::size_t i = 0; i < count; ++i) {
        readers_[i].emplace(numbers_, i, paths_[active_[first + i]].sampler);
    }
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
    shadowed_.trace(tracer_, [&](const ShadowedLight& one, float transmittance) {
        const Color3f light = transmittance * one.light;
        switch (one.part) {
            case Part::tail: tails_.tail(one.index).lamp.radiance += light; break;
            case Part::onward: tails_.tail(one.index).onward.radiance += light; break;
            default: add(seen[one.index], light, one.direct ? 1 : 2);
        }
    });
}

void PathTracer::add(Seen& seen, const Color3f& light, std::size_t bounces) const {
    Color3f added = light;
    if (bounces > 1 && settings_->path.clamp_indirect > 0.0F) {
        added *= std::min(1.0F, settings_->path.clamp_indirect / largest(light));
    }
    seen.radiance += Color4f(added.x, added.y, added.z, 0.0F);
    if (bounces == 0) {
        seen.parts.emission += added;
    } else if (bounces == 1) {
        seen.parts.direct += added;
    }
}

// Adds what the path meets at the end of its ray.
PathTracer::Encounter PathTracer::meet(Path& path, std::size_t place, Seen& seen) {
    if (!path.hit.any()) {
        add_distant_light(path, seen);
        return Encounter::ends;
    }
    const Interaction& at = *surfaces_[place];
    const Appearance& appearance = at.appearance();
    const bool seen_directly = path.bounces.all == 0;
    if (seen_directly && !seen.visible.any && appearance.opacity > 0.0F) {
        seen.visible = tracer_.visible(at);
    }
    if (appearance.opacity < 1.0F && path.crossings < max_crossings &&
        readers_[place]->next() >= appearance.opacity) {
        path.ray.origin = at.surface.start(path.ray.direction);
        path.ray.differentials.origin_x = at.moved.along_x;
        path.ray.differentials.origin_y = at.moved.along_y;
        ++path.crossings;
        path.transmittance *= 1.0F - appearance.opacity;
        return Encounter::passes;
    }
    if (seen_directly) {
        seen.radiance.a = 1.0F;
        seen.coverage.add(tracer_.visible(at), 1.0F);
    }
    absorb(path, at.surface.position);
    add_emission(path, at, seen);
    if (path.is_last || appearance.unlit) {
        return Encounter::ends;
    }
    const V3f to_viewer = -path.ray.direction;
    bsdfs_.add(place, at, to_viewer);
    points_[place] = {at.surface.position,
                      tracer_.lights().are_at_eye() && !seen_directly
                          ? (path.eye - at.surface.position).normalized()
                          : to_viewer,
                      bsdfs_.lit_side(place), path.ray.time};
    if (path.part == Part::between) {
        begin_tail(path, place);
    }
    return Encounter::scatters;
}

void PathTracer::add_distant_light(const Path& path, Seen& seen) {
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
            ? weights_.of_scattered(path.pdf, lights.pdf_of_distant(path.from, path.ray.direction))
            : 1.0F;
    receive(path, seen, weight * path.throughput * arriving);
    if (seen_directly) {
        seen.radiance.a = 1.0F;
    }
}

void PathTracer::add_emission(const Path& path, const Interaction& at, Seen& seen) {
    const Appearance& appearance = at.appearance();
    const Color3f emitted =
        appearance.unlit ? appearance.base_color : at.emission(path.ray.direction);
    if (is_black(emitted)) {
        return;
    }
    const float distance = (at.surface.position - path.from.position).length();
    const float weight = path.pdf > 0.0F && !appearance.unlit
                             ? weights_.of_scattered(
                                   path.pdf, tracer_.lights().pdf_of_emitter(
                                                 path.from, path.ray.direction, distance, path.hit))
                             : 1.0F;
    receive(path, seen, weight * path.throughput * emitted);
}

// Chooses a light. False if none arrives.
bool PathTracer::choose_light(std::size_t place) {
    const Imath::V2f choices = readers_[place]->next_pair();
    const Imath::V2f at_light = readers_[place]->next_pair();
    choices_[place] = choices.y;
    std::optional<LightSample>& sample = lamps_[place];
    sample = tracer_.lights().sample(points_[place], {choices.x, at_light.x, at_light.y});
    if (!sample || !(sample->pdf > 0.0F)) {
        return false;
    }
    bsdfs_.set_light(place, sample->to_light);
    return true;
}

// Adds what arrives from the chosen light, if nothing is in its way. `alone` says that no other
// method samples light at this surface.
void PathTracer::add_lamp(const Path& path, std::size_t place, bool alone) {
    const Bsdf::Value value = bsdfs_.value(place);
    if (is_black(value.reflected)) {
        return;
    }
    const std::optional<LightSample>& sample = lamps_[place];
    Color3f arriving = sample->radiance;
    if (sample->emitter.any()) {
        arriving *= tracer_.emission(sample->emitter, sample->to_light, path.ray.time);
    }
    const float weight = sample->delta || alone ? 1.0F : weights_.of_lamp(sample->pdf, value.pdf);
    Color3f unshadowed = weight / sample->pdf * path.throughput * arriving;
    if (path.part == Part::tail) {
        tails_.tail(path.index).lamp = {sample->to_light, Color3f(0.0F), value.reflected};
    } else {
        unshadowed *= value.reflected;
    }
    if (is_black(unshadowed)) {
        return;
    }
    const bool is_direct = path.bounces.all == 0;
    const Surface& surface = surfaces_[place]->surface;
    float distance = sample->distance;
    if (distance <= 0.0F) {
        distance = (path.eye - surface.position).length();
    } else if (!sample->delta) {
        distance *= before_emitter;
    }
    shadowed_.add({SceneTracer::shadow_ray(surface, sample->to_light, distance, path.ray.time),
                   unshadowed, path.index, path.packet, is_direct, path.part});
}

// Finds the next ray. False where the path ends.
bool PathTracer::scatter(Path& path, std::size_t place) {
    if (path.part == Part::head && SharedTails::can_end_head(bsdfs_.material(place))) {
        end_head(path, place);
    }
    const std::optional<BsdfSample> sample = bsdfs_.sampled(place);
    if (!sample) {
        return false;
    }
    if (sample->delta && path.part == Part::between) {
        path.part = Part::whole;
    }
    if (path.part == Part::tail) {
        go_on_from_tail(path, *sample);
    } else {
        path.throughput *= sample->weight;
    }
    count_bounce(path, sample->lobe, settings_->path.bounces);
    if (!survives(path, *readers_[place])) {
        return false;
    }
    const Interaction& at = *surfaces_[place];
    if (textured_) {
        path.ray.differentials = after_sample(path.ray, at.moved, *sample, footprint_scale_);
    }
    path.from = points_[place];
    path.transmittance = 1.0F;
    path.pdf = sample->delta ? 0.0F : sample->pdf;
    path.ray.origin =
        sample->transmitted ? at.surface.start(sample->to_light) : at.surface.start_to_light();
    path.ray.direction = sample->to_light;
    if (sample->transmitted && !at.appearance().thin_walled) {
        path.absorption = at.surface.entering ? at.appearance().absorption : Color3f(0.0F);
    }
    return true;
}

// A head receives the light of tails whether its own ray finds one or not. No tail is shared where
// light is absorbed on its way, or where a limit is reached.
void PathTracer::end_head(Path& path, std::size_t place) {
    const Bounces& bounces = path.bounces;
    const BounceLimits& limits = settings_->path.bounces;
    path.part = Part::whole;
    if (!is_black(path.absorption) || bounces.all >= limits.all ||
        bounces.diffuse >= limits.diffuse || bounces.glossy >= limits.glossy) {
        return;
    }
    const Surface& surface = surfaces_[place]->surface;
    tails_.set_head(path.index,
                    {.surface = {bsdfs_.material(place), surface.normal, surface.smooth_normal},
                     .to_viewer = -path.ray.direction,
                     .start = surface.start_to_light(),
                     .throughput = path.throughput,
                     .time = path.ray.time,
                     .bounces = bounces});
    path.part = Part::between;
}

void PathTracer::begin_tail(Path& path, std::size_t place) {
    const Surface& surface = surfaces_[place]->surface;
    path.part = Part::whole;
    if (SharedTails::can_begin_tail(bsdfs_.material(place), surface, -path.ray.direction)) {
        tails_.set_tail(path, bsdfs_.material(place), surface);
        path.before_tail = std::exchange(path.throughput, Color3f(1.0F));
        path.part = Part::tail;
    }
}

// A mirror reflection is the path's own.
void PathTracer::go_on_from_tail(Path& path, const BsdfSample& sample) {
    if (sample.delta) {
        path.throughput = std::exchange(path.before_tail, Color3f(1.0F)) * sample.weight;
        path.part = Part::whole;
        return;
    }
    const Color3f reflected = sample.pdf * sample.weight;
    tails_.tail(path.index).onward = {sample.to_light, Color3f(0.0F), reflected};
    path.before_tail *= reflected;
    path.throughput = Color3f(1.0F / sample.pdf);
    path.part = Part::onward;
}

void PathTracer::receive(const Path& path, Seen& seen, const Color3f& light) {
    if (path.part == Part::onward) {
        tails_.tail(path.index).onward.radiance += light;
    } else {
        add(seen, light, path.bounces.all);
    }
}

}  // namespace

Diagnostics check_path(const Settings& settings) {
    const BounceLimits& limits = settings.path.bounces;
    if (std::max({limits.all, limits.diffuse, limits.glossy, limits.transmission}) >
        BounceLimits::most) {
        return {error("a limit of bounces is out of range", {},
                      fmt::format("give numbers from 0 to {}", BounceLimits::most))};
    }
    return {};
}

std::unique_ptr<Integrator> make_path(const TracedScene& traced, const Settings& settings) {
    return std::make_unique<PathTracer>(traced, settings);
}

}  // namespace balcony::render
