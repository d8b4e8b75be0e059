// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Path tracing (Kajiya 1986) with next-event estimation and multiple importance sampling.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "render/integrators/integrator.hpp"
#include "render/integrators/lamp_weights.hpp"
#include "render/integrators/patch_guide.hpp"
#include "render/integrators/path_batch.hpp"
#include "render/integrators/path_block.hpp"
#include "render/integrators/path_light.hpp"
#include "render/integrators/path_state.hpp"
#include "render/integrators/shown_surface.hpp"
#include "shading/materials/footprint.hpp"

namespace balcony::render {

namespace {

// A ray to an emissive triangle ends before it by more than the rounding error of the point where
// it meets the triangle, also at a grazing angle.
constexpr float before_emitter = 1.0F - 1e-4F;

// Surfaces that are seen by light of roughness 1 are at least so rough, so that lamps are found in
// mirrors and through glass: path regularisation (Kaplanyan and Dachsbacher 2013). The square, the
// width of their highlights, falls with the sixth root of the pass, so that both error and bias go
// to nothing.
float softening(std::uint32_t pass) {
    constexpr float first = 0.5F;
    return first * std::pow(static_cast<float>(pass + 1), -1.0F / 12.0F);
}

// So many mirrors end no path by chance, such that each sample finds the surface that they show.
constexpr std::uint8_t mirrors_without_roulette = 8;

// Whether a surface shows others, in focus, instead of itself.
bool is_clear(const BsdfMaterial& material) {
    constexpr float sharp = 0.1F;
    return material.is_clear() || (material.roughness < sharp && is_black(material.diffuse));
}

bool is_without_extent(const scene::Light& light) {
    return light.kind != scene::LightKind::directional || light.angle == 0.0F;
}

class PathTracer final : public Integrator {
public:
    PathTracer(const TracedScene& traced, const Settings& settings)
        : tracer_(traced),
          settings_(&settings.path),
          weights_{settings.path.lamp_sampling},
          shows_environment_(shows_environment(traced, settings)),
          footprint_scale_(1.0F / std::sqrt(static_cast<float>(settings.samples))),
          textured_(traced.materials.has_textures()),
          guides_(std::any_of(traced.scene->materials.begin(), traced.scene->materials.end(),
                              bends_light)),
          has_points_(std::any_of(traced.scene->lights.begin(), traced.scene->lights.end(),
                                  is_without_extent)),
          light_(traced, settings.path),
          guide_(traced.patches.get()) {}

    void trace(std::span<const CameraRay> rays, const ShownObjects& shown,
               std::span<Seen> seen) override {
        sees_environment_ = shows_environment_ && shown.environment;
        softening_ =
            settings_->exact || rays.empty() ? 0.0F : softening(rays.front().sampler.pass());
        light_.begin(rays, seen);
        paths_.generate(rays, light_.first_part());
        while (!paths_.empty()) {
            paths_.advance_blocks([this](std::size_t first, std::size_t count) {
                block_.begin(paths_, first, count, tracer_);
                return advance(count);
            });
            light_.trace_shadow_rays(tracer_, paths_);
            paths_.intersect(tracer_, shown);
        }
        light_.finish(tracer_);
    }

private:
    // The lanes of the block whose paths go on.
    [[nodiscard]] LaneBits advance(std::size_t count);
    [[nodiscard]] LaneBits chosen_of_cut(LaneBits lanes);

    // What becomes of a path where its ray ends.
    enum class Encounter : std::uint8_t { ends, passes, scatters };
    [[nodiscard]] Encounter meet(std::size_t lane);
    [[nodiscard]] static bool pass_last_pane(Path& path, const Interaction& at);
    void weigh_against_guided(Path& path, const Interaction& at) const;
    void add_distant_light(const Path& path);
    void add_emission(const Path& path, const Interaction& at);

    void light(LaneBits lanes, LaneBits alone);
    [[nodiscard]] bool choose_lamp(std::size_t lane);
    void add_lamp(std::size_t lane, bool alone);
    [[nodiscard]] bool may_guide(std::size_t lane);
    [[nodiscard]] Path guided(std::size_t lane, const Color3f& throughput);

    [[nodiscard]] LaneBits scatter(LaneBits lanes);
    [[nodiscard]] bool scatter(std::size_t lane);
    void turn(Path& path, std::size_t lane, const BsdfSample& sample);

    SceneTracer tracer_;
    const PathSettings* settings_;
    LampWeights weights_;
    bool shows_environment_;
    bool sees_environment_ = false;  // The camera rays at work.
    float footprint_scale_;
    float softening_ = 0.0F;  // Of the pass.
    bool textured_;
    bool guides_;      // Some paths start where shadow rays end.
    bool has_points_;  // Lamps without an extent.
    PathBatch paths_;
    PathLight light_;
    PathBlock block_;
    PatchGuide guide_;
    std::array<std::optional<LightSample>, PathBlock::size> lamps_;
    std::array<float, PathBlock::size> choices_{};  // They select lobes.
};

// Step by step for all lanes, since the processor computes the same of several paths at once.
LaneBits PathTracer::advance(std::size_t count) {
    LaneBits scattering = 0;
    LaneBits passing = 0;
    for (std::size_t lane = 0; lane < count; ++lane) {
        switch (meet(lane)) {
            case Encounter::ends: break;
            case Encounter::passes: passing |= lane_bit(lane); break;
            case Encounter::scatters: scattering |= lane_bit(lane); break;
        }
    }
    block_.bsdfs().set_views();
    LaneBits alone = 0;  // No other method than sampling lamps finds their light.
    for_each_lane(scattering, [&](std::size_t lane) {
        const bool ends = block_.path(lane).bounces.all >= settings_->bounces.all &&
                          block_.bsdfs().material(lane).is_rough() &&
                          settings_->lamp_sampling != LampSampling::surfaces;
        alone |= ends ? lane_bit(lane) : 0;
    });
    light(scattering, alone);
    return passing | scatter((scattering & ~alone) | chosen_of_cut(alone));
}

// Paths that end before their last ray. A few go on, for all, to tell what light is cut off.
LaneBits PathTracer::chosen_of_cut(LaneBits lanes) {
    constexpr float part = 0.125F;
    LaneBits chosen = 0;
    for_each_lane(lanes, [&](std::size_t lane) {
        if (block_.numbers(lane).next() < part) {
            block_.path(lane).is_cut = true;
            block_.path(lane).throughput /= part;
            chosen |= lane_bit(lane);
        }
    });
    return chosen;
}

// Adds what the path meets at the end of its ray.
PathTracer::Encounter PathTracer::meet(std::size_t lane) {
    Path& path = block_.path(lane);
    if (!path.hit.any()) {
        if (path.shows && path.bounces.all > 0) {
            light_.seen(path).shown = {};
        }
        add_distant_light(path);
        return Encounter::ends;
    }
    const Interaction& at = block_.at(lane);
    const Appearance& appearance = at.appearance();
    const bool seen_directly = path.bounces.all == 0;
    if (seen_directly && !light_.seen(path).visible.any && appearance.opacity > 0.0F) {
        light_.seen(path).visible = tracer_.visible(at);
        light_.seen(path).shown = light_.seen(path).visible;
    }
    if (appearance.opacity < 1.0F && path.crossings < max_crossings &&
        block_.numbers(lane).next() >= appearance.opacity) {
        pass_through(path, at);
        return Encounter::passes;
    }
    if (seen_directly) {
        light_.seen(path).radiance.a = 1.0F;
        light_.seen(path).coverage.add(tracer_.visible(at), 1.0F);
        light_.seen(path).end = at.surface.position;
    } else if (path.shows) {
        light_.seen(path).shown = tracer_.visible(at);
    }
    absorb(path, at.surface.position);
    add_emission(path, at);
    if (path.is_last) {
        if (pass_last_pane(path, at)) {
            return Encounter::passes;
        }
        light_.cut(path);
        return Encounter::ends;
    }
    if (appearance.unlit) {
        return Encounter::ends;
    }
    weigh_against_guided(path, at);
    const V3f to_viewer = -path.ray.direction;
    path.is_softened |= block_.bsdfs().add(lane, at, to_viewer, path.least_roughness);
    path.is_clear = path.is_clear && is_clear(block_.bsdfs().material(lane));
    path.shows = path.shows && path.is_clear;
    if (path.shows && block_.bsdfs().material(lane).transmits()) {
        light_.seen(path).shown = shown_by_glass(tracer_, path.ray, at);
        path.shows = false;
    }
    block_.point(lane) = {at.surface.position,
                          tracer_.lights().are_at_eye() && !seen_directly
                              ? (path.eye - at.surface.position).normalized()
                              : to_viewer,
                          block_.bsdfs().lit_side(lane), path.ray.time};
    guide_.find_place(block_, lane);
    light_.begin_tail(block_, lane);
    return Encounter::scatters;
}

// A ray that collects light alone goes on behind panes, like the shadow rays that share this light
// with it.
bool PathTracer::pass_last_pane(Path& path, const Interaction& at) {
    const Color3f straight = at.straight(path.ray.direction);
    if (is_black(straight) || path.crossings >= max_crossings) {
        return false;
    }
    path.throughput *= straight;
    pass_pane(path, at);
    return true;
}

// At glass, where a guided path may have come from the same surface in the same direction. No such
// path sees the glass softened: it would miss a small lamp, which others would find by chance.
// Lamps without an extent are found behind softened glass only.
void PathTracer::weigh_against_guided(Path& path, const Interaction& at) const {
    const V3f& direction = path.ray.direction;
    if (!path.may_be_guided || !bends_light(*at.surface.material) ||
        !is_black(at.straight(direction))) {
        return;
    }
    const float pdf = tracer_.pdf_behind_glass(
        path.from,
        {.origin = at.surface.start(direction), .direction = direction, .time = path.ray.time});
    path.throughput *= weights_.of_scattered(path.pdf, pdf);
    if (pdf > 0.0F || !has_points_) {
        path.least_roughness = 0.0F;
    }
}

void PathTracer::add_distant_light(const Path& path) {
    const LightSet& lights = tracer_.lights();
    const bool seen_directly = path.bounces.all == 0;
    if (!lights.has_distant() || path.is_guided || path.is_cut ||
        (seen_directly && !sees_environment_)) {
        return;
    }
    const Color3f arriving = lights.radiance_from(path.ray.direction);
    const float weight =
        path.pdf > 0.0F
            ? weights_.of_scattered(path.pdf, lights.pdf_of_distant(path.from, path.ray.direction))
            : 1.0F;
    light_.add(path, weight * path.throughput * arriving);
    if (seen_directly) {
        light_.seen(path).radiance.a = 1.0F;
    }
}

void PathTracer::add_emission(const Path& path, const Interaction& at) {
    const Appearance& appearance = at.appearance();
    const Color3f emitted =
        appearance.unlit ? appearance.base_color : at.emission(path.ray.direction);
    if (is_black(emitted) || path.is_guided || path.is_cut) {
        return;
    }
    const float distance = (at.surface.position - path.from.position).length();
    const float weight = path.pdf > 0.0F && !appearance.unlit
                             ? weights_.of_scattered(
                                   path.pdf, tracer_.lights().pdf_of_emitter(
                                                 path.from, path.ray.direction, distance, path.hit))
                             : 1.0F;
    light_.add(path, weight * path.throughput * emitted);
}

void PathTracer::light(LaneBits lanes, LaneBits alone) {
    LaneBits lit = 0;
    for_each_lane(lanes, [&](std::size_t lane) { lit |= choose_lamp(lane) ? lane_bit(lane) : 0; });
    block_.bsdfs().evaluate(lit);
    for_each_lane(lit, [&](std::size_t lane) { add_lamp(lane, (alone & lane_bit(lane)) != 0); });
}

// False if no light arrives.
bool PathTracer::choose_lamp(std::size_t lane) {
    SampleReader& numbers = block_.numbers(lane);
    const Imath::V2f choices = numbers.next_pair();
    const Imath::V2f at_light = numbers.next_pair();
    choices_[lane] = choices.y;
    std::optional<LightSample>& sample = lamps_[lane];
    sample = tracer_.lights().sample(block_.point(lane), {choices.x, at_light.x, at_light.y});
    if (!sample || !(sample->pdf > 0.0F)) {
        return false;
    }
    block_.bsdfs().set_light(lane, sample->to_light);
    return true;
}

// Adds what arrives from the chosen lamp, if nothing is in its way. `alone` says that no other
// method samples light at this surface.
void PathTracer::add_lamp(std::size_t lane, bool alone) {
    const Bsdf::Value value = block_.bsdfs().value(lane);
    if (is_black(value.reflected)) {
        return;
    }
    const Path& path = block_.path(lane);
    const LightSample& sample = *lamps_[lane];
    Color3f arriving = sample.radiance;
    if (sample.emitter.any()) {
        arriving *= tracer_.emission(sample.emitter, sample.to_light, path.ray.time);
    }
    const float weight =
        sample.delta || alone
            ? 1.0F
            : weights_.of_lamp(sample.pdf, guide_.pdf(lane, sample.to_light, value.pdf));
    const Color3f unshadowed = light_.received(
        path, {sample.to_light, weight / sample.pdf * path.throughput * arriving, value.reflected});
    const bool guides = !alone && !sample.delta && weight > 0.0F && may_guide(lane);
    if (is_black(unshadowed) && !guides) {
        return;
    }
    const Surface& surface = block_.at(lane).surface;
    float distance = sample.distance;
    if (distance <= 0.0F) {
        distance = (path.eye - surface.position).length();
    } else if (!sample.delta) {
        distance *= before_emitter;
    }
    const embree::Ray shadow_ray =
        SceneTracer::shadow_ray(surface, sample.to_light, distance, path.ray.time);
    if (!guides) {
        light_.add(path, shadow_ray, unshadowed);
        return;
    }
    const Path onward = guided(
        lane, light_.received(
                  path, {sample.to_light, weight / sample.pdf * path.throughput, value.reflected}));
    light_.add(path, shadow_ray, unshadowed, onward.is_last ? nullptr : &onward);
}

bool PathTracer::may_guide(std::size_t lane) {
    return guides_ && block_.path(lane).part != Part::guided &&
           !block_.bsdfs().material(lane).transmits();
}

// A path of this throughput towards the chosen lamp.
Path PathTracer::guided(std::size_t lane, const Color3f& throughput) {
    const BsdfMaterial& material = block_.bsdfs().material(lane);
    BsdfSample sample;
    sample.to_light = lamps_[lane]->to_light;
    sample.pdf = lamps_[lane]->pdf;
    if (is_black(material.diffuse)) {
        sample.roughness = material.roughness;
    } else {
        sample.lobe = BsdfLobe::diffuse;
    }
    Path made = block_.path(lane);
    turn(made, lane, sample);
    // Roulette judges it like a path that has found the direction by chance: the throughput is
    // small because small lamps are bright.
    const Bsdf::Value value = block_.bsdfs().value(lane);
    made.before_tail *= sample.pdf / value.pdf;
    if (made.part == Part::tail) {
        made.before_tail *= value.reflected;
    }
    count_bounce(made, sample.lobe, settings_->bounces);
    made.throughput = throughput;
    made.pdf = 0.0F;
    made.least_roughness = 0.0F;
    made.may_be_guided = false;
    made.is_guided = true;
    made.is_clear = false;
    made.shows = false;
    made.sampler.branch();
    return made;
}

// Finds the next rays. Returns the lanes whose paths go on.
LaneBits PathTracer::scatter(LaneBits lanes) {
    for_each_lane(lanes, [&](std::size_t lane) {
        const Imath::V2f at_lobe = block_.numbers(lane).next_pair();
        guide_.choose(block_, lane, {choices_[lane], at_lobe.x, at_lobe.y});
    });
    block_.bsdfs().sample(lanes);
    LaneBits scattered = 0;
    for_each_lane(lanes,
                  [&](std::size_t lane) { scattered |= scatter(lane) ? lane_bit(lane) : 0; });
    return scattered;
}

bool PathTracer::scatter(std::size_t lane) {
    Path& path = block_.path(lane);
    light_.end_head(block_, lane, guide_.place(lane));
    std::optional<BsdfSample> sample = block_.bsdfs().sampled(lane);
    if (!sample) {
        return false;
    }
    const float by_chance = guide_.weigh(lane, *sample);
    const Interaction& at = block_.at(lane);
    const bool passes_pane = sample->delta && sample->transmitted && at.appearance().thin_walled;
    // What a pane on the way mirrors, other paths find, with their whole weight.
    if (path.is_guided && !passes_pane && !is_black(at.straight(path.ray.direction))) {
        return false;
    }
    light_.scatter(path, *sample, passes_pane);
    if (!passes_pane || path.bounces.all == 0 || path.crossings >= max_crossings) {
        count_bounce(path, sample->lobe, settings_->bounces);
    }
    const bool in_mirrors = path.shows && path.bounces.all <= mirrors_without_roulette;
    if (!in_mirrors && !survives(path, block_.numbers(lane), by_chance)) {
        return false;
    }
    if (passes_pane) {
        pass_pane(path, at);
        return true;
    }
    turn(path, lane, *sample);
    path.is_guided = false;
    path.may_be_guided = path.pdf > 0.0F && may_guide(lane);
    return true;
}

// From the surface of its lane into the direction of a sample.
void PathTracer::turn(Path& path, std::size_t lane, const BsdfSample& sample) {
    const Interaction& at = block_.at(lane);
    if (textured_) {
        path.ray.differentials = after_sample(path.ray, at.moved, sample, footprint_scale_);
    }
    if (!path.is_clear) {
        ++path.scattered;
    }
    path.from = block_.point(lane);
    path.transmittance = 1.0F;
    path.absorbed = 0.0F;
    path.pdf = sample.delta ? 0.0F : sample.pdf;
    path.least_roughness = std::max(path.least_roughness, softening_ * sample.roughness);
    path.ray.origin =
        sample.transmitted ? at.surface.start(sample.to_light) : at.surface.start_to_light();
    path.ray.direction = sample.to_light;
    if (sample.transmitted && !at.appearance().thin_walled) {
        path.absorption = at.surface.entering ? at.appearance().absorption : Color3f(0.0F);
    }
}

}  // namespace

Diagnostics check_path(const Settings& settings) {
    if (!(settings.path.clamp_indirect >= 0.0F)) {
        return {error("the limit of indirect light is out of range", {}, "give 0 or more")};
    }
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
