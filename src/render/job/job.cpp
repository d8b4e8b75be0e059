// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <new>

#include <fmt/format.h>

#include "balcony/probe.hpp"
#include "base/stopwatch.hpp"
#include "film/sums/film_arrays.hpp"
#include "film/sums/layer_rows.hpp"
#include "render/job/check_settings.hpp"
#include "render/job/coarse_rays.hpp"
#include "render/job/distant_probes.hpp"
#include "render/job/lighting.hpp"
#include "render/job/patch_probes.hpp"
#include "render/job/point_blender.hpp"
#include "render/job/renderer_state.hpp"
#include "render/job/run.hpp"

namespace balcony::render {

namespace {

// The error of a film that a job cannot continue.
Diagnostics check_to_continue(const Film& film) {
    if (!film.noisy.empty()) {
        return {error("the film is denoised, so no samples can be added to it", {},
                      "denoise a copy of the film")};
    }
    for (const LayerRow& row : layer_rows()) {
        if (film.layer_set.contains(row.info.id) && !row.complete(film)) {
            return {error(
                Kind::internal,
                fmt::format("the film does not have the vector of its layer {}", row.info.name),
                "create the film with make_film()")};
        }
    }
    return check_sizes(film);
}

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

// Gives some of the inputs other values. An unknown one is an error, and nothing is set then.
Diagnostics set(std::vector<camera::KnownInput>& inputs,
                std::span<const camera::KnownInput> values) {
    std::vector<camera::KnownInput> changed = inputs;
    for (const camera::KnownInput& value : values) {
        const auto input =
            std::find_if(changed.begin(), changed.end(),
                         [&](const camera::KnownInput& one) { return one.name == value.name; });
        if (input == changed.end()) {
            return {error(fmt::format("the picture has no input '{}'", printable(value.name)))};
        }
        input->value = value.value;
    }
    inputs = std::move(changed);
    return {};
}

Result<PictureInputs> inputs_of(const camera::Picture& picture, const scene::Scene& scene,
                                const Settings& settings) {
    Result<LensFocus> focus = lenses_of(picture, scene);
    if (!focus) {
        return std::move(focus.diagnostics);
    }
    PictureInputs made{std::move(*focus), parameters_of(picture)};
    if (Diagnostics found = set(made.parameters, settings.inputs); !found.empty()) {
        return found;
    }
    return made;
}

void measure_focus(PictureInputs& inputs, const JobParts& parts, const Film& film) {
    if (parts.central) {
        PictureRays rays(*parts.central, parts.shown, parts.traced.interval,
                         {{}, inputs.parameters});
        inputs.focus.distances =
            distances_to(inputs.focus.objects, parts.traced, rays, film, parts.settings.time);
    }
}

PictureForm form_of(const Film& film, const TracedScene& traced) {
    const bool magnification = film.layers && !film.layers->magnification.empty();
    return {{film.width, film.height},
            traced.materials.has_textures() || magnification,
            film.layers && !film.layers->parameters.empty()};
}

// Compiles the rays of all layers, and the central ones if a lens is focused on an object.
Diagnostics compile(const camera::Picture& picture, const PictureInputs& inputs,
                    const std::stop_token& stop, JobParts& parts) {
    const auto width = static_cast<double>(parts.form.size[0]);
    const auto height = static_cast<double>(parts.form.size[1]);
    const Axes axes = parts.traced.scene->axes;
    Result<rays::CompiledPicture> all = rays::compile(picture, width, height,
                                                      {.axes = axes,
                                                       .footprints = parts.form.footprints,
                                                       .parameters = parts.form.parameters,
                                                       .bends = true,
                                                       .inputs = declared(inputs)},
                                                      stop);
    if (!all) {
        return std::move(all.diagnostics);
    }
    parts.picture = std::move(*all);
    if (inputs.focus.objects.empty()) {
        return {};
    }
    Result<rays::CompiledPicture> central = rays::compile(
        picture, width, height,
        {.axes = axes, .bends = true, .inputs = declared({{}, inputs.parameters})}, stop);
    if (!central) {
        return std::move(central.diagnostics);
    }
    parts.central = std::move(*central);
    return {};
}

// Chooses what the settings leave open of the light.
void choose_light(JobParts& parts, PictureRays& rays, const Film& film,
                  const std::stop_token& stop) {
    Settings& settings = parts.settings;
    if (parts.integrator->traces_environment) {
        Lighting lighting = lighting_of(parts.traced, rays, film, settings);
        parts.traced.lights = std::move(lighting.lights);
        parts.light = std::move(lighting.description);
        parts.substitute = lighting.substitute;
        settings.ambient = Color3f(0.0F);
        if (settings.path.probes_windows) {
            parts.traced.lights = parts.traced.lights.with(
                distant_visibility(parts.traced, rays, film, settings, stop));
        }
        if (settings.path.probes_patches) {
            parts.traced.patches = bright_patches(parts.traced, rays, film, settings, stop);
        }
        if (!settings.path.exact) {
            parts.levels = LightLevels(parts.traced, settings, *parts.integrator, rays, film, stop);
        }
        parts.common_light = common_light(parts.traced, settings, *parts.integrator, rays, film);
    } else if (!settings.ambient) {
        settings.ambient = ambient_of(parts.traced, rays, film, settings.time);
    }
}

template <class Named>
std::vector<std::string> names_of(const std::vector<Named>& all) {
    std::vector<std::string> names;
    for (const Named& one : all) {
        names.push_back(one.name);
    }
    return names;
}

std::shared_ptr<Supersampling> supersampling_of(const JobParts& parts) {
    return std::make_shared<Supersampling>(parts.traced, parts.settings, parts.form.size,
                                           parts.common_light);
}

// The names and colours of a picture, and the sums that it needs.
void prepare(Film& film, const JobParts& parts) {
    const scene::Scene& scene = *parts.traced.scene;
    film.objects = names_of(scene.objects);
    film.materials = names_of(scene.materials);
    film.picture_layers = names_of(parts.picture.layers());
    film.background = parts.settings.background;
    film.ambient = *parts.settings.ambient;
    const std::size_t pixels = film.window.size();
    if (film.display.empty() && paints(parts.picture.elements())) {
        film.display.assign(pixels, Color4d(0.0));
    }
    const SamplingSettings& sampling = parts.settings.sampling;
    if (sampling.noise > 0.0 && film.pixel_passes.empty()) {
        film.pixel_passes.assign(pixels, 0);
        film.first_half.assign(pixels, Color4d(0.0));
        film.white = sampling.white.value_or(0.0);
    }
    const auto shows_mirrors = parts.integrator->shows_mirrors;
    if (film.mirrored.empty() && shows_mirrors != nullptr && shows_mirrors(scene)) {
        film.mirrored.assign(pixels, Color4d(0.0));
    }
}

}  // namespace

struct Job::State {
    std::shared_ptr<const Renderer::State> renderer;
    camera::Picture picture;
    std::shared_ptr<const JobParts> parts;
    PictureInputs inputs;
    std::shared_ptr<Film> film;
    std::shared_ptr<Supersampling> supersampling;  // Of these inputs.
};

Result<Job> Job::make(const Renderer& renderer, const camera::Picture& picture,
                      const Settings& settings, std::shared_ptr<Film> film,
                      const std::stop_token& stop) {
    return make(renderer, picture, settings, std::move(film), nullptr, stop);
}

Result<Job> Job::again(const Renderer& renderer, const Settings& settings,
                       std::shared_ptr<Film> film, const std::stop_token& stop) const {
    if (!has_parts_of(*renderer.state_->traced.scene, *state_->renderer->traced.scene)) {
        return error(Kind::usage, "a job is made again for another time of its own scene only",
                     "make another job");
    }
    return make(renderer, state_->picture, settings, std::move(film), state_.get(), stop);
}

Result<Job> Job::make(const Renderer& renderer, const camera::Picture& picture,
                      const Settings& settings, std::shared_ptr<Film> shared, const State* previous,
                      const std::stop_token& stop) {
    if (Diagnostics found = check(settings); !found.empty()) {
        return found;
    }
    if (!shared) {
        return error(Kind::internal, "a job needs a film");
    }
    Film& film = *shared;
    if (Diagnostics found = check_to_continue(film); !found.empty()) {
        return found;
    }
    try {
        const Stopwatch watch;
        auto parts = std::make_shared<JobParts>(
            JobParts{renderer.state_->traced, form_of(film, renderer.state_->traced), settings,
                     find_integrator(settings.integrator)});
        const TracedScene& traced = parts->traced;
        if (Diagnostics found = check_objects(picture, *traced.scene); !found.empty()) {
            return found;
        }
        Result<PictureInputs> inputs = inputs_of(picture, *traced.scene, settings);
        if (!inputs) {
            return std::move(inputs.diagnostics);
        }
        if (previous != nullptr && previous->parts->form == parts->form) {
            parts->picture = previous->parts->picture;
            parts->central = previous->parts->central;
        } else if (Diagnostics found = compile(picture, *inputs, stop, *parts); !found.empty()) {
            return found;
        }
        Result<std::vector<ShownObjects>> shown = shown_objects(parts->picture, traced);
        if (!shown) {
            return std::move(shown.diagnostics);
        }
        parts->shown = std::move(*shown);
        measure_focus(*inputs, *parts, film);
        PictureRays rays(parts->picture, parts->shown, traced.interval, *inputs);
        if (!renderer.state_->textures_on_demand) {
            read_visible_textures(traced, rays, film, settings.time, stop);
        }
        if (stop.stop_requested()) {
            return stopped();
        }
        choose_light(*parts, rays, film, stop);
        if (stop.stop_requested()) {
            return stopped();
        }
        prepare(film, *parts);
        parts->motion = motion_of(traced, parts->picture, settings, film);
        parts->compile_seconds = watch.seconds();
        auto supersampling = supersampling_of(*parts);
        return Job(std::make_shared<const State>(State{renderer.state_, picture, std::move(parts),
                                                       std::move(*inputs), std::move(shared),
                                                       std::move(supersampling)}));
    } catch (const std::bad_alloc&) {
        return out_of_memory();
    }
}

Diagnostics Job::set_inputs(std::span<const camera::KnownInput> inputs) {
    try {
        State moved = *state_;
        if (Diagnostics found = set(moved.inputs.parameters, inputs); !found.empty()) {
            return found;
        }
        const JobParts& parts = *moved.parts;
        Film& film = *moved.film;
        measure_focus(moved.inputs, parts, film);
        begin_anew(film, film.window);
        film.white = parts.settings.sampling.white.value_or(0.0);
        moved.supersampling = supersampling_of(parts);
        state_ = std::make_shared<const State>(std::move(moved));
        return {};
    } catch (const std::bad_alloc&) {
        return {out_of_memory()};
    }
}

const std::shared_ptr<Film>& Job::film() const { return state_->film; }

const std::string& Job::light() const { return state_->parts->light; }

std::optional<SubstituteLight> Job::substitute() const { return state_->parts->substitute; }

Result<Summary> Job::run(const ProgressCallback& progress, std::stop_token stop) {
    const std::vector<std::uint32_t> passes(
        state_->film->tile_count(), static_cast<std::uint32_t>(state_->parts->settings.samples));
    return run(passes, progress, std::move(stop));
}

Result<Summary> Job::run(std::span<const std::uint32_t> passes, const ProgressCallback& progress,
                         std::stop_token stop) {
    if (Diagnostics found = check_to_continue(*state_->film); !found.empty()) {
        return found;
    }
    if (passes.size() != state_->film->tile_count()) {
        return error(Kind::internal,
                     fmt::format("the film has {} tiles, but {} numbers of passes are given",
                                 state_->film->tile_count(), passes.size()));
    }
    try {
        const JobParts& parts = *state_->parts;
        return {render::run(parts, state_->inputs, *state_->supersampling, *state_->film, passes,
                            progress, std::move(stop)),
                parts.traced.textures->warnings()};
    } catch (const std::bad_alloc&) {
        return out_of_memory();
    }
}

Result<Summary> render(const Renderer& renderer, const camera::Picture& picture,
                       const Settings& settings, Film& film, const ProgressCallback& progress,
                       std::stop_token stop) {
    // The job does not outlive this call, so it need not own the film.
    const std::shared_ptr<Film> borrowed(std::shared_ptr<Film>(), &film);
    Result<Job> job = Job::make(renderer, picture, settings, borrowed, stop);
    if (!job && kind_of_errors(job.diagnostics) == Kind::interrupted) {
        Summary summary;
        summary.interrupted = true;
        return summary;
    }
    if (!job) {
        return std::move(job.diagnostics);
    }
    return job->run(progress, std::move(stop));
}

}  // namespace balcony::render
