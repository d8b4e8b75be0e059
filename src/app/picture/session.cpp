// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/picture/session.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "app/inputs/frame_pictures.hpp"
#include "app/picture/banded_picture.hpp"
#include "app/picture/findings.hpp"
#include "app/picture/paused_run.hpp"
#include "app/picture/shard_picture.hpp"
#include "app/words.hpp"
#include "balcony/bands.hpp"
#include "balcony/inputs.hpp"

namespace balcony::app {

namespace {

namespace fs = std::filesystem;

bool has_samples(const render::Film& film) {
    return std::any_of(film.passes.begin(), film.passes.end(),
                       [](std::uint32_t count) { return count > 0; });
}

/// A picture whose film is in memory.
class WholeRun {
public:
    WholeRun(const Request& request, const Loaded& loaded, std::shared_ptr<render::Film> film,
             const Observer& observer, const bool& is_outdated, Report& report)
        : request_(request),
          loaded_(loaded),
          shared_(std::move(film)),
          film_(*shared_),
          observer_(observer),
          is_outdated_(is_outdated),
          report_(report),
          finish_(finish_of(request)),
          checkpoint_(
              request.job.shard ? shard_file(request.output, *request.job.shard) : request.output,
              request.given, loaded.files(), loaded.since) {}

    void run(const camera::Picture& picture, const std::stop_token& stop) {
        Result<render::Job> job =
            render::Job::make(*loaded_.renderer, picture, loaded_.settings, shared_);
        if (fails(job.diagnostics) || fails(resume())) {
            return;
        }
        const Result<render::Summary> summary =
            trace(*job, film_, checkpoint_, limits(), observer_.progress, stop);
        if (fails(summary.diagnostics) || is_outdated_) {
            return;
        }
        if (summary->interrupted && checkpoint_.is_used()) {
            tell(observer_, checkpoint_.save(film_));
        }
        describe(report_, loaded_, picture, {film_.window, film_.background.has_value()}, *summary);
        if (request_.job.shard) {
            write_the_shard();
            return;
        }
        report_.samples = sample_range(film_);
        report_.has_samples = has_samples(film_);
        if (!summary->interrupted) {
            describe_misses(report_, loaded_, picture, {film_.width, film_.height});
        }
        if (report_.has_samples) {
            write_the_picture();
        }
    }

private:
    [[nodiscard]] bool fails(const Diagnostics& found) {
        add(report_.diagnostics, found);
        return has_errors(found);
    }

    [[nodiscard]] bool has_file() const {
        return !request_.output.empty() && request_.output != "-";
    }

    [[nodiscard]] Diagnostics resume() {
        if (!has_file()) {
            return {};
        }
        if (request_.job.resume) {
            return checkpoint_.exists() ? checkpoint_.load(film_) : Diagnostics{};
        }
        if (request_.job.checkpoint_every) {
            tell(observer_, checkpoint_.replaced());
        }
        return {};
    }

    [[nodiscard]] TraceLimits limits() {
        TraceLimits made{.seconds = request_.job.time_limit,
                         .shard = request_.job.shard,
                         .samples = loaded_.settings.samples,
                         .remedy = checkpoint_.remedy("restore it")};
        if (has_file() && request_.job.save_every) {
            made.pauses.push_back({*request_.job.save_every,
                                   [this] { tell(observer_, write(finish_, film_, observer_)); }});
        }
        if (has_file() && request_.job.checkpoint_every) {
            made.pauses.push_back({*request_.job.checkpoint_every,
                                   [this] { tell(observer_, checkpoint_.save(film_)); }});
        }
        return made;
    }

    void write_the_shard() {
        report_.shard = request_.job.shard;
        if (report_.interrupted) {
            report_.checkpoint = checkpoint_.is_used() ? checkpoint_.file() : fs::path();
            return;
        }
        const fs::path file = shard_file(request_.output, *request_.job.shard);
        render::RenderFacts facts = checkpoint_.facts(film_);
        std::erase_if(facts, [](const render::RenderFact& fact) { return fact.name == "--shard"; });
        if (fails(of_kind(Kind::environment, render::write_shard(film_, *request_.job.shard, facts,
                                                                 facts_of(finish_), file)))) {
            return;
        }
        if (checkpoint_.is_used()) {
            checkpoint_.remove();
        }
        report_.output = file;
    }

    void write_the_picture() {
        report_.denoised = try_to_denoise(finish_, film_, report_.diagnostics);
        report_.exposure = finish_.exposure_of(film_);
        report_.is_exposure_chosen = !finish_.exposure;
        report_.ambient = film_.ambient;
        if (request_.output.empty()) {
            return;
        }
        add(report_.diagnostics, warn_of_lost_alpha(film_, finish_));
        Diagnostics written = write(finish_, film_, observer_);
        if (has_errors(written) && checkpoint_.is_used()) {
            written.front().remedy = checkpoint_.remedy("correct that");
        }
        if (fails(written)) {
            return;
        }
        report_.output = request_.output;
        if (!checkpoint_.is_used()) {
            return;
        }
        if (report_.interrupted) {
            report_.checkpoint = checkpoint_.file();
        } else {
            checkpoint_.remove();
        }
    }

    const Request& request_;
    const Loaded& loaded_;
    std::shared_ptr<render::Film> shared_;
    render::Film& film_;
    const Observer& observer_;
    const bool& is_outdated_;
    Report& report_;
    Finish finish_;
    CheckpointFile checkpoint_;
};

// What both eyes see of a picture, or one of them.
std::optional<camera::Picture> stereo_view(const Request& request,
                                           std::optional<camera::Picture> picture,
                                           Diagnostics& found) {
    if (!picture || !request.stereo.is_wanted()) {
        return picture;
    }
    auto views =
        camera::stereo_picture(*picture, request.stereo.formats.front(), request.stereo.pair);
    add(found, views.diagnostics);
    return std::move(views.value);
}

}  // namespace

Session::Session() : state_(std::make_unique<State>()) {}
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;
Session::~Session() = default;

std::shared_ptr<const render::Film> Session::film() const { return state_->film; }

// The scene of the last request may serve this one.
void Session::State::prepare(const Request& request) {
    const bool same = last && last->scene == request.scene && last->added == request.added &&
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

Report Session::render(const Request& request, const Observer& observer,
                       const std::stop_token& stop) {
    Report report;
    Loaded& loaded = state_->loaded;
    state_->film.reset();
    state_->prepare(request);
    const auto fails = [&report](const Diagnostics& found) {
        add(report.diagnostics, found);
        return has_errors(found);
    };
    if (fails(check_request(request)) || !load_settings(request, loaded, report.diagnostics)) {
        return report;
    }
    auto picture = load_all(request, loaded, report.diagnostics);
    if (!picture || fails(check_overwrites(request.output, loaded.files()))) {
        return report;
    }
    picture = stereo_view(request, std::move(picture), report.diagnostics);
    if (!picture) {
        return report;
    }
    const render::DisplayFormat* const format = finish_of(request).display_format();
    const render::FilmLayout layout = film_layout(request, *picture, format != nullptr);
    if (layout.layers.contains(render::LayerId::motion)) {
        FrameInverses inverses(request, {layout.width, layout.height});
        add(report.diagnostics, inverses.add_to(loaded.settings, *loaded.scene, *picture));
    }
    const bool is_large = render::film_bytes(layout) > request.job.film_bytes();
    if (format == nullptr && !request.output.empty() && is_large) {
        if (request.job.shard) {
            fails({error("a shard of this size needs more memory than --film-memory allows", {},
                         "raise --film-memory, or render parts with --crop")});
            return report;
        }
        const Stoppable stoppable(observer);
        render_in_bands(request, loaded, *picture, layout, observer, stop, report);
        return report;
    }
    Result<render::Film> film = make_film(layout, request);
    if (fails(film.diagnostics) ||
        (format != nullptr &&
         fails(render::check_size(*format, film->window.width, film->window.height)))) {
        return report;
    }
    const auto kept = std::make_shared<render::Film>(std::move(*film));
    state_->film = kept;
    const Stoppable stoppable(observer);
    WholeRun(request, loaded, kept, observer, state_->is_outdated, report).run(*picture, stop);
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

Diagnostics check_request(const Request& request) {
    Diagnostics found;
    if (request.camera.empty() && !request.set.empty()) {
        found.push_back(error(Kind::usage, "--set needs a camera whose parameter it sets",
                              "add --camera FILE"));
    }
    if (request.is_fitted() && (request.camera.empty() || is_of_scene(request.camera))) {
        found.push_back(error(Kind::usage, "--fit needs a camera of a file, which it places",
                              "add --camera FILE or the name of a built-in camera"));
    }
    if (request.job.shard && !request.exposure && request.settings.sampling.noise != 0.0) {
        found.push_back(error(Kind::usage,
                              "--shard with --noise needs --exposure, as noise is relative to "
                              "white",
                              "add --exposure 0, or the one that a quick preview reports"));
    }
    return found;
}

}  // namespace balcony::app
