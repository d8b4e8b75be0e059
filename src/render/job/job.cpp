// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <new>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "base/fork_and_join.hpp"
#include "base/stopwatch.hpp"
#include "film/sums/layer_rows.hpp"
#include "render/integrators/direct.hpp"
#include "render/job/adaptive.hpp"
#include "render/job/ambient.hpp"
#include "render/job/lighting.hpp"
#include "render/job/point_blender.hpp"
#include "render/job/renderer_state.hpp"
#include "render/job/tile_worker.hpp"
#include "render/job/visible_textures.hpp"

namespace balcony::render {

namespace {

constexpr std::size_t max_samples = std::size_t{1} << 24;
constexpr std::size_t max_threads = 4096;

bool is_finite(const Color3f& c) {
    return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z);
}

template <class Info>
Diagnostic unknown(std::string_view kind, const std::string& name, std::span<const Info> known) {
    std::vector<std::string> names;
    for (const Info& info : known) {
        names.emplace_back(info.name);
    }
    return error(
        fmt::format("unknown {} '{}'", kind, name), {},
        did_you_mean(name, names, fmt::format("the {}s are {}", kind, fmt::join(names, ", "))));
}

Diagnostics check(const Settings& settings) {
    Diagnostics found;
    const auto within = [&](std::size_t value, std::size_t minimum, std::size_t maximum,
                            std::string_view what) {
        if (value < minimum || value > maximum) {
            found.push_back(error(fmt::format("{} {} is out of range", what, value), {},
                                  fmt::format("give a number from {} to {}", minimum, maximum)));
        }
    };
    within(settings.samples, 1, max_samples, "the number of samples");
    within(settings.threads, 0, max_threads, "the number of threads");
    if (!std::isfinite(settings.time) || !is_finite(settings.ambient.value_or(Color3f(0.0F))) ||
        !is_finite(settings.background.value_or(Color3f(0.0F)))) {
        found.push_back(error("time, ambient light and background must be finite numbers"));
    }
    if (!(settings.shutter.duration >= 0.0) || !std::isfinite(settings.shutter.duration)) {
        found.push_back(error("the shutter is open for a time that is not a number of seconds", {},
                              "give a duration of at least 0"));
    }
    const double sun_angle = settings.light.sun_angle.value_or(0.0);
    if (!(sun_angle >= 0.0 && sun_angle <= std::numbers::pi)) {
        found.push_back(
            error("the angle of suns is out of range", {}, "give radians from 0 to pi"));
    }
    if (!(settings.frames.duration > 0.0) || !std::isfinite(settings.frames.duration)) {
        found.push_back(error("the time from frame to frame is not a number of seconds", {},
                              "give a duration above 0, such as 1/24"));
    }
    if (find_integrator(settings.integrator) == nullptr) {
        found.push_back(unknown("integrator", settings.integrator, integrators()));
    }
    if (!(settings.sampling.noise >= 0.0) || !std::isfinite(settings.sampling.noise)) {
        found.push_back(error("the noise level must be a finite number, 0 or more"));
    }
    if (find_pixel_filter(settings.sampling.filter) == nullptr) {
        found.push_back(unknown("pixel filter", settings.sampling.filter, pixel_filters()));
    }
    return found;
}

// Whether the sizes of a film's vectors match its window.
bool holds_together(const Film& film) {
    const std::size_t pixels = film.window.size();
    const bool layers =
        std::all_of(layer_rows().begin(), layer_rows().end(), [&film](const LayerRow& row) {
            return !film.layer_set.contains(row.info.id) || row.complete(film);
        });
    const auto fits = [pixels](const std::vector<Color4d>& sums) {
        return sums.empty() || sums.size() == pixels;
    };
    const bool further = fits(film.sum_of_squares) && fits(film.display) && fits(film.mirrored);
    return pixels > 0 && film.sum.size() == pixels && layers && further &&
           film.window.x + film.window.width <= film.width &&
           film.window.y + film.window.height <= film.height &&
           film.passes.size() == film.tile_count();
}

// All passes over all tiles on a number of threads.
class Run {
public:
    Run(const JobParts& parts, Film& film, std::span<const std::uint32_t> passes,
        const ProgressCallback& progress, std::stop_token stop)
        : parts_(parts),
          film_(film),
          passes_(passes),
          last_pass_(*std::max_element(passes.begin(), passes.end())),
          tiles_(tiles_missing()),
          workers_([&parts, &film] { return TileWorker(parts, film); }),
          progress_(progress),
          stop_(std::move(stop)) {}

    Summary operator()() {
        // More threads than the machine has would not run at the same time.
        const auto all = static_cast<std::size_t>(tbb::info::default_concurrency());
        const std::size_t asked = parts_.settings.threads;
        tbb::task_arena arena(static_cast<int>(asked == 0 ? all : std::min(asked, all)));
        bool complete = true;
        for (std::uint32_t pass = fewest_passes(); complete && pass < last_pass_; ++pass) {
            if (is_adaptive() && film_.white == 0.0 &&
                pass >= first_judgement(parts_.settings.sampling)) {
                film_.white = white_of(film_);
            }
            complete = add_pass(arena, pass);
        }
        return summary(complete);
    }

private:
    [[nodiscard]] std::size_t tiles_missing() const {
        std::size_t missing = 0;
        for (std::size_t tile = 0; tile < passes_.size(); ++tile) {
            missing += passes_[tile] - std::min(passes_[tile], film_.passes[tile]);
        }
        return missing;
    }

    [[nodiscard]] bool is_adaptive() const { return !film_.pixel_passes.empty(); }

    [[nodiscard]] std::uint32_t fewest_passes() const {
        return *std::min_element(film_.passes.begin(), film_.passes.end());
    }

    // Adds one pass to the tiles that have this number of passes and need more. Returns whether the
    // pass was completed.
    bool add_pass(tbb::task_arena& arena, std::uint32_t pass) {
        std::vector<std::size_t> tiles;
        for (std::size_t tile = 0; tile < passes_.size(); ++tile) {
            if (film_.passes[tile] == pass && passes_[tile] > pass) {
                tiles.push_back(tile);
            }
        }
        std::atomic<bool> complete = true;
        const auto render_tile = [&](std::size_t i) {
            fork_and_join::before_each();
            if (stop_.stop_requested()) {
                complete = false;
            } else {
                const bool sampled = workers_.local().render(tiles[i]);
                report(pass, sampled, sampled ? 1 : passes_[tiles[i]] - pass);
            }
            fork_and_join::after_each();
        };
        fork_and_join::before_all();
        arena.execute([&] { tbb::parallel_for(std::size_t{0}, tiles.size(), render_tile); });
        fork_and_join::after_all();
        return complete;
    }

    // A tile that needs no more samples is done with all passes; that alone is no progress.
    void report(std::size_t pass, bool sampled, std::size_t passes_done) {
        if (!progress_) {
            return;
        }
        const std::lock_guard lock(progress_mutex_);
        tiles_done_ += passes_done;
        if (!sampled) {
            return;
        }
        progress_({film_.first_pass + pass, film_.first_pass + last_pass_, tiles_done_, tiles_,
                   watch_.seconds()});
    }

    [[nodiscard]] Summary summary(bool complete) const {
        WorkCounts counts;
        for (const TileWorker& worker : workers_) {
            counts.add(worker.counts());
        }
        Summary summary;
        counts.layers.resize(parts_.picture.layers().size());
        for (std::size_t i = 0; i < counts.layers.size(); ++i) {
            const RayCounts& layer = counts.layers[i];
            summary.layers.push_back({parts_.picture.layers()[i].name, layer.camera_rays,
                                      layer.invalid_rays, layer.hits});
            summary.camera_rays += layer.camera_rays;
            summary.invalid_rays += layer.invalid_rays;
        }
        summary.invalid_pixels = counts.invalid_pixels;
        summary.repaired = counts.repaired;
        summary.unknown_motion = counts.motion.unknown;
        summary.ambiguous_motion = counts.motion.ambiguous;
        summary.ambient = *parts_.settings.ambient;
        summary.light = parts_.light;
        summary.substitute = parts_.substitute;
        summary.passes = fewest_passes();
        summary.interrupted = !complete;
        summary.seconds = watch_.seconds();
        summary.compile_seconds = parts_.compile_seconds;
        summary.camera_share = counts.seconds > 0.0 ? counts.camera_seconds / counts.seconds : 0.0;
        return summary;
    }

    const JobParts& parts_;
    Film& film_;
    std::span<const std::uint32_t> passes_;  // The target, by tile.
    std::uint32_t last_pass_;
    std::size_t tiles_;  // The total number, over all passes.
    tbb::enumerable_thread_specific<TileWorker> workers_;
    const ProgressCallback& progress_;
    std::stop_token stop_;
    Stopwatch watch_;
    std::mutex progress_mutex_;
    std::size_t tiles_done_ = 0;
};

// The motion of what is seen, if the film has a layer for it. All data are of pass 0.
std::shared_ptr<const FrameMotion> motion_of(const TracedScene& traced,
                                             const rays::CompiledPicture& picture,
                                             const Settings& settings, const Film& film) {
    if (!film.layers || film.layers->motion.empty()) {
        return nullptr;
    }
    const auto& layers = picture.layers();
    const bool own_times = std::any_of(layers.begin(), layers.end(),
                                       [](const auto& layer) { return layer.rays.has_times(); });
    const double time = settings.shutter.moment(settings.time, pass_moment(0));
    return std::make_shared<const FrameMotion>(
        *traced.scene, settings.frames,
        own_times ? traced.interval : scene::TimeInterval{time, time});
}

Diagnostic out_of_memory() {
    return error("out of memory while rendering", {},
                 "make the picture smaller, or omit the data layers");
}

}  // namespace

struct Job::State {
    std::shared_ptr<const Renderer::State> renderer;
    camera::Picture picture;
    bool footprints;                  // Whether it was compiled with them,
    bool parameters;                  // with these,
    std::array<std::size_t, 2> size;  // and for which size in pixels.
    JobParts parts;
    Film* film;
};

Result<Job> Job::make(const Renderer& renderer, const camera::Picture& picture,
                      const Settings& settings, Film& film) {
    return make(renderer, picture, settings, film, nullptr);
}

Result<Job> Job::again(const Renderer& renderer, const Settings& settings, Film& film) const {
    return make(renderer, state_->picture, settings, film, state_.get());
}

Result<Job> Job::make(const Renderer& renderer, const camera::Picture& picture,
                      const Settings& settings, Film& film, const State* previous) {
    if (Diagnostics found = check(settings); !found.empty()) {
        return found;
    }
    if (!film.noisy.empty()) {
        return error("the film is denoised, so no samples can be added to it", {},
                     "denoise a copy of the film");
    }
    if (!holds_together(film)) {
        return error("the film's vectors do not have the size of its window", {},
                     "create the film with make_film()");
    }
    try {
        TracedScene traced = renderer.state_->traced;
        const Stopwatch watch;
        const bool with_magnification = film.layers && !film.layers->magnification.empty();
        Result<LensFocus> focus = focus_of(traced, picture, film, settings.time);
        if (!focus) {
            return std::move(focus.diagnostics);
        }
        const bool footprints = traced.materials.has_textures() || with_magnification;
        const bool parameters = film.layers && !film.layers->parameters.empty();
        const std::array size{film.width, film.height};
        Result<rays::CompiledPicture> compiled =
            previous != nullptr && previous->size == size && previous->footprints == footprints &&
                    previous->parameters == parameters
                ? Result<rays::CompiledPicture>(previous->parts.picture)
                : rays::compile(picture, static_cast<double>(film.width),
                                static_cast<double>(film.height),
                                {.axes = traced.scene->axes,
                                 .footprints = footprints,
                                 .parameters = parameters,
                                 .inputs = lens_inputs(*focus)});
        if (!compiled) {
            return std::move(compiled.diagnostics);
        }
        film.objects.clear();
        for (const scene::Object& object : traced.scene->objects) {
            film.objects.push_back(object.name);
        }
        film.materials.clear();
        for (const scene::Material& material : traced.scene->materials) {
            film.materials.push_back(material.name);
        }
        film.picture_layers.clear();
        for (const rays::CompiledPicture::CameraLayer& layer : compiled->layers()) {
            film.picture_layers.push_back(layer.name);
        }
        Settings complete = settings;
        PictureRays picture_rays(*compiled, traced.interval, *focus);
        if (!renderer.state_->textures_on_demand) {
            read_visible_textures(traced, picture_rays, film, settings.time);
        }
        std::string light;
        std::optional<SubstituteLight> substitute;
        if (traces_environment(settings.integrator)) {
            Lighting lighting = lighting_of(traced, picture_rays, film, settings);
            traced.lights = std::move(lighting.lights);
            light = std::move(lighting.description);
            substitute = lighting.substitute;
            complete.ambient = Color3f(0.0F);
        } else if (!complete.ambient) {
            complete.ambient = ambient_of(traced, picture_rays, film, settings.time);
        }
        film.background = complete.background;
        film.ambient = *complete.ambient;
        if (film.display.empty() && paints(compiled->elements())) {
            film.display.assign(film.window.size(), Color4d(0.0));
        }
        if (settings.sampling.noise > 0.0 && film.pixel_passes.empty()) {
            film.pixel_passes.assign(film.window.size(), 0);
            film.first_half.assign(film.window.size(), Color4d(0.0));
            film.white = settings.sampling.white.value_or(0.0);
        }
        const auto& materials = traced.scene->materials;
        if (film.mirrored.empty() &&
            std::any_of(materials.begin(), materials.end(), may_be_mirror)) {
            film.mirrored.assign(film.window.size(), Color4d(0.0));
        }
        auto motion = motion_of(traced, *compiled, settings, film);
        return Job(std::make_shared<const State>(
            State{renderer.state_,
                  picture,
                  footprints,
                  parameters,
                  size,
                  {std::move(traced), std::move(*compiled), std::move(*focus), complete,
                   find_integrator(settings.integrator), std::move(light), substitute,
                   std::move(motion), watch.seconds()},
                  &film}));
    } catch (const std::bad_alloc&) {
        return out_of_memory();
    }
}

const std::string& Job::light() const { return state_->parts.light; }

std::optional<SubstituteLight> Job::substitute() const { return state_->parts.substitute; }

Result<Summary> Job::run(const ProgressCallback& progress, std::stop_token stop) {
    const std::vector<std::uint32_t> passes(
        state_->film->tile_count(), static_cast<std::uint32_t>(state_->parts.settings.samples));
    return run(passes, progress, std::move(stop));
}

Result<Summary> Job::run(std::span<const std::uint32_t> passes, const ProgressCallback& progress,
                         std::stop_token stop) {
    if (!holds_together(*state_->film) || passes.size() != state_->film->tile_count()) {
        return error(fmt::format("the film has {} tiles, but {} numbers of passes are given",
                                 state_->film->tile_count(), passes.size()));
    }
    try {
        Run run(state_->parts, *state_->film, passes, progress, std::move(stop));
        return {run(), state_->parts.traced.textures->warnings()};
    } catch (const std::bad_alloc&) {
        return out_of_memory();
    }
}

Result<Summary> render(const Renderer& renderer, const camera::Picture& picture,
                       const Settings& settings, Film& film, const ProgressCallback& progress,
                       std::stop_token stop) {
    Result<Job> job = Job::make(renderer, picture, settings, film);
    if (!job) {
        return std::move(job.diagnostics);
    }
    return job->run(progress, std::move(stop));
}

}  // namespace balcony::render
