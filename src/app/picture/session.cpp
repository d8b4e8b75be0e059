// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/picture/session.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "app/inputs/frame_pictures.hpp"
#include "app/picture/banded_picture.hpp"
#include "app/picture/findings.hpp"
#include "app/picture/look.hpp"
#include "app/picture/paused_run.hpp"
#include "app/picture/picture_facts.hpp"
#include "app/picture/remote_display.hpp"
#include "app/words.hpp"
#include "balcony/inputs.hpp"

namespace balcony::app {

namespace {

namespace fs = std::filesystem;

bool has_samples(const render::Film& film) {
    return std::any_of(film.passes.begin(), film.passes.end(),
                       [](std::uint32_t count) { return count > 0; });
}

// The exposure of a picture, and white for a noise level, which is relative to it. Shards may be
// merged to a picture for the display.
Result<double> choose_exposure(const Request& request, const camera::Picture& picture,
                               const render::FilmLayout& layout, Loaded& loaded,
                               const std::stop_token& stop) {
    render::SamplingSettings& sampling = loaded.settings.sampling;
    const bool is_used =
        finish_of(request).display_format() != nullptr || request.job.shard || sampling.noise > 0.0;
    if (request.exposure || !is_used) {
        return request.exposure.value_or(0.0);
    }
    Result<Look> look = look_at(picture, *loaded.renderer, loaded.settings, layout, stop);
    if (!look) {
        return std::move(look.diagnostics);
    }
    sampling.white = std::exp2(-look->exposure);
    return {look->exposure, std::move(look.diagnostics)};
}

/// A picture, or a shard of one, whose film is in memory.
class WholeRun {
public:
    WholeRun(const Request& request, double exposure, const Loaded& loaded,
             std::shared_ptr<render::Film> film, const Observer& observer, const bool& is_outdated,
             Report& report)
        : request_(request),
          loaded_(loaded),
          shared_(std::move(film)),
          film_(*shared_),
          observer_(observer),
          is_outdated_(is_outdated),
          report_(report),
          finish_(finish_of(request)),
          file_(request.job.shard ? shard_file(request.output, *request.job.shard)
                                  : request.output),
          checkpoint_(file_, film_facts(request), loaded.files(), loaded.since) {
        finish_.exposure = exposure;
    }

    void run(const camera::Picture& picture, const std::stop_token& stop) {
        Result<render::Job> job =
            render::Job::make(*loaded_.renderer, picture, loaded_.settings, shared_, stop);
        if (fails(job.diagnostics) || fails(resume())) {
            return;
        }
        open_display();
        const Result<render::Summary> summary =
            trace(*job, film_, checkpoint_, limits(), observer_.progress, stop);
        if (fails(summary.diagnostics) || is_outdated_) {
            return;
        }
        describe(report_, loaded_, picture, {film_.window, film_.background.has_value()}, *summary);
        report_.shard = request_.job.shard;
        if (!request_.job.shard) {
            report_.samples = sample_range(film_);
            report_.has_samples = has_samples(film_);
            if (!summary->interrupted) {
                describe_sight(report_, loaded_, picture, {film_.width, film_.height}, stop);
            }
        }
        write_file();
        show();
    }

private:
    [[nodiscard]] bool fails(const Diagnostics& found) { return add(report_.diagnostics, found); }

    [[nodiscard]] bool has_file() const {
        return !request_.output.empty() && request_.output != "-";
    }
    [[nodiscard]] bool has_checkpoints() const {
        return has_file() && request_.job.checkpoint_every;
    }

    [[nodiscard]] Diagnostics resume() {
        if (!has_file()) {
            return {};
        }
        if (request_.job.resume && checkpoint_.exists()) {
            return checkpoint_.load(film_);
        }
        if (request_.job.resume || request_.job.checkpoint_every) {
            tell(observer_, checkpoint_.begins_anew(request_.job.resume));
        }
        return {};
    }

    // A picture that cannot be shown is rendered nevertheless.
    void open_display() {
        if (request_.job.display) {
            Result<RemoteDisplay> made = RemoteDisplay::connect(
                *request_.job.display, request_.output.filename().string(), film_);
            for (Diagnostic& found : made.diagnostics) {
                tell(observer_, {warning(found.message, {}, found.remedy)});
            }
            if (made) {
                display_.emplace(std::move(*made));
            }
        }
    }

    void show() {
        if (display_) {
            tell(observer_, display_->show(film_));
        }
    }

    [[nodiscard]] TraceLimits limits() {
        TraceLimits made{.seconds = request_.job.time_limit,
                         .save_checkpoint = [this] { save_checkpoint(); },
                         .begins_checkpoint_at_stop = has_checkpoints(),
                         .shard = request_.job.shard,
                         .samples = loaded_.settings.samples,
                         .remedy = checkpoint_.remedy("restore it")};
        if (has_checkpoints()) {
            made.checkpoint_every = request_.job.checkpoint_every;
        }
        if (has_file() && request_.job.save_every) {
            made.pauses.push_back({*request_.job.save_every,
                                   [this] { tell(observer_, write(finish_, film_, observer_)); }});
        }
        if (display_) {
            constexpr double seconds_between = 0.5;
            made.pauses.push_back({seconds_between, [this] { show(); }});
        }
        return made;
    }

    void save_checkpoint() {
        if (has_samples(film_)) {
            tell(observer_, checkpoint_.save(film_));
        }
    }

    // An interrupted shard is none.
    void write_file() {
        const bool is_nothing = request_.job.shard ? report_.interrupted : !report_.has_samples;
        Diagnostics written = is_nothing           ? Diagnostics{}
                              : request_.job.shard ? write_the_shard()
                                                   : write_the_picture();
        if (has_errors(written) && checkpoint_.is_used()) {
            written.front().remedy = checkpoint_.remedy("correct that");
        }
        if (fails(written)) {
            return;
        }
        report_.output = is_nothing ? fs::path() : file_;
        if (!report_.interrupted && (checkpoint_.is_used() || has_checkpoints())) {
            checkpoint_.remove();
        } else if (checkpoint_.is_used()) {
            report_.checkpoint = checkpoint_.file();
        }
    }

    [[nodiscard]] Diagnostics write_the_shard() {
        render::RenderFacts facts = facts_of(request_, FactsOf::exr);
        const render::RenderFacts files = facts_of(loaded_.files());
        facts.insert(facts.end(), files.begin(), files.end());
        return render::write_shard(
            film_, {.shard = *request_.job.shard, .facts = facts, .finish = finish_}, file_);
    }

    [[nodiscard]] Diagnostics write_the_picture() {
        report_.denoised = try_to_denoise(finish_, film_, report_.diagnostics);
        report_.exposure = finish_.exposure;
        report_.is_exposure_chosen = !request_.exposure && finish_.display_format() != nullptr;
        report_.ambient = film_.ambient;
        if (request_.output.empty()) {
            return {};
        }
        add(report_.diagnostics, warn_of_lost_alpha(film_, finish_));
        return write(finish_, film_, observer_);
    }

    const Request& request_;
    const Loaded& loaded_;
    std::shared_ptr<render::Film> shared_;
    render::Film& film_;
    const Observer& observer_;
    const bool& is_outdated_;
    Report& report_;
    Finish finish_;
    fs::path file_;
    CheckpointFile checkpoint_;
    std::optional<RemoteDisplay> display_;
};

}  // namespace

Session::Session() : state_(std::make_unique<State>()) {}
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;
Session::~Session() = default;

std::shared_ptr<const render::Film> Session::film() const { return state_->film; }

// The scene of the last request may serve this one.
void SessionState::prepare(const Request& request) {
    const bool same = last && last->scene == request.scene && last->added == request.added &&
                      last->solid_glass == request.solid_glass &&
                      last->meters_per_unit == request.meters_per_unit &&
                      last->light.lamps == request.light.lamps &&
                      last->light.emission_scale == request.light.emission_scale &&
                      last->settings.time == request.settings.time &&
                      last->texture_memory == request.texture_memory;
    if (!same) {
        loaded.scene.reset();
        loaded.renderer.reset();
    }
    if (!loaded.scene) {
        loaded.since = FileWatch::Time::clock::now();
    }
    last = request;
}

void SessionState::render(const Request& request, const Observer& observer,
                          const std::stop_token& stop, Report& report) {
    film.reset();
    prepare(request);
    const auto fails = [&report](const Diagnostics& found) {
        return add(report.diagnostics, found);
    };
    if (fails(check_request(request)) ||
        !load_settings(request, loaded, stop, report.diagnostics)) {
        return;
    }
    if (const auto picture = load_all(request, loaded, observer, stop, report.diagnostics)) {
        render_picture(*picture, request, observer, stop, report);
    }
}

void SessionState::render_picture(const camera::Picture& loaded_picture, const Request& request,
                                  const Observer& observer, const std::stop_token& stop,
                                  Report& report) {
    const auto fails = [&report](const Diagnostics& found) {
        return add(report.diagnostics, found);
    };
    if (fails(check_overwrites(request.output, loaded.files()))) {
        return;
    }
    const auto picture = stereo_view(request, loaded_picture);
    if (fails(picture.diagnostics)) {
        return;
    }
    const render::DisplayFormat* const format = finish_of(request).display_format();
    const render::FilmLayout layout = film_layout(request, *picture, format != nullptr);
    if (layout.layers.contains(render::LayerId::motion)) {
        FrameInverses inverses(request, {layout.width, layout.height});
        if (fails(inverses.add_to(loaded.settings, *loaded.scene, *picture, stop))) {
            return;
        }
    }
    if (fails(pass_starts(request.inside, *picture, {layout.width, layout.height}, loaded, stop))) {
        return;
    }
    const Result<double> exposure = choose_exposure(request, *picture, layout, loaded, stop);
    if (fails(exposure.diagnostics)) {
        return;
    }
    if (format == nullptr && !request.output.empty() && is_large(layout, request)) {
        if (request.job.shard) {
            fails({too_large("a shard")});
        } else {
            render_in_bands(request, loaded, *picture, layout, observer, stop, report);
        }
        return;
    }
    Result<render::Film> made = make_film(layout, request);
    if (fails(made.diagnostics) ||
        (format != nullptr &&
         fails(render::check_size(*format, made->window.width, made->window.height)))) {
        return;
    }
    const auto kept = std::make_shared<render::Film>(std::move(*made));
    film = kept;
    WholeRun(request, *exposure, loaded, kept, observer, is_outdated, report).run(*picture, stop);
}

Report Session::render(const Request& request, const Observer& observer,
                       const std::stop_token& stop) {
    Report report;
    within_memory(report.diagnostics, [&] { state_->render(request, observer, stop, report); });
    report.interrupted |= kind_of_errors(report.diagnostics) == Kind::interrupted;
    return report;
}

Report render_in(Loaded& scene, const camera::Picture& picture, const Request& request,
                 const Observer& observer, const std::stop_token& stop,
                 std::shared_ptr<const render::Film>& film) {
    Report report;
    film.reset();
    within_memory(report.diagnostics, [&] {
        SessionState state;
        state.loaded = shared(scene);
        if (!add(report.diagnostics, check_request(request)) &&
            load_settings(request, state.loaded, stop, report.diagnostics)) {
            scene.environments = state.loaded.environments;
            state.render_picture(picture, request, observer, stop, report);
            film = state.film;
        }
    });
    report.interrupted |= kind_of_errors(report.diagnostics) == Kind::interrupted;
    return report;
}

std::vector<Request> pictures_of(const Request& request) {
    if (!request.stereo.has_two_files()) {
        return {request};
    }
    std::vector<Request> eyes;
    for (const camera::StereoFormat format : request.stereo.formats) {
        eyes.push_back(request);
        eyes.back().stereo.formats = {format};
        eyes.back().output = file_of_eye(request.output, format);
    }
    return eyes;
}

void hold_look(const Report& first, Request& second) {
    second.exposure = first.exposure;
    // Only light without shadows follows the picture.
    if (!second.settings.ambient && first.ambient != render::Color3f(0.0F)) {
        second.settings.ambient = first.ambient;
    }
}

}  // namespace balcony::app
