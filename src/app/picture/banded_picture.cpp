// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/picture/banded_picture.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "app/picture/findings.hpp"
#include "app/picture/paused_run.hpp"
#include "app/picture/picture_facts.hpp"
#include "app/words.hpp"
#include "balcony/bands.hpp"

namespace balcony::app {

namespace {

// More memory would not make rendering faster, but checkpoints larger.
constexpr double enough_for_a_band = 0x1p28;

Request not_denoised(Request request) {
    request.denoise = false;
    request.denoiser = render::Denoiser::automatic;
    return request;
}

/// The bands of a picture, its file, and the checkpoint of the band in progress.
class BandedRun {
public:
    BandedRun(const Request& request, const Loaded& loaded, const render::Region& window,
              const Observer& observer, render::BandedRender& bands)
        : request_(request),
          window_(window),
          bands_(bands),
          observer_(observer),
          checkpoint_(request.output, {.sums = facts_of(not_denoised(request), FactsOf::exr)},
                      loaded.files(), loaded.since) {}

    [[nodiscard]] const CheckpointFile& checkpoint() const { return checkpoint_; }

    /// Begins the file, or continues it if that is asked for and there is a checkpoint.
    [[nodiscard]] Diagnostics begin() {
        if (request_.job.resume && checkpoint_.exists()) {
            return resume();
        }
        tell(observer_, checkpoint_.begins_anew(request_.job.resume));
        return take(render::TiledFile::create(request_.output, bands_.film(), window_));
    }

    /// Renders all bands. What stays after a stop or an error is enough to continue, or nothing.
    [[nodiscard]] Result<render::Summary> run(const std::stop_token& stop) {
        Result<render::Summary> total = run_bands(stop);
        if (total && !total->interrupted) {
            checkpoint_.remove();
        } else if (!checkpoint_.is_used()) {
            file_->remove();
        }
        return total;
    }

private:
    [[nodiscard]] Result<render::Summary> run_bands(const std::stop_token& stop) {
        Result<render::Summary> total{render::Summary{}};
        do {
            Result<render::Summary> band = run_band(total->seconds, stop);
            add(total.diagnostics, band.diagnostics);
            if (!band) {
                return std::move(total.diagnostics);
            }
            render::add(*total, *band);
            if (total->interrupted) {
                return total;
            }
            if (Diagnostics found = file_->add(bands_.film()); !found.empty()) {
                save();
                return found;
            }
        } while (bands_.next());
        if (Diagnostics found = file_->commit(); !found.empty()) {
            save();
            return found;
        }
        return total;
    }

    [[nodiscard]] Diagnostics take(Result<render::TiledFile> file) {
        file_ = std::move(file.value);
        return std::move(file.diagnostics);
    }

    // Another process that writes the picture would change the checkpoint meanwhile.
    [[nodiscard]] Diagnostics resume() {
        Result<WorkFile> part = render::TiledFile::open(request_.output);
        if (kind_of_errors(part.diagnostics) == Kind::usage) {
            return part.diagnostics;
        }
        const auto heading = render::read_checkpoint_heading(checkpoint_.file());
        if (!heading) {
            return heading.diagnostics;
        }
        const render::Region& band = heading->window;
        // Where there is no such band, the checkpoint is refused.
        static_cast<void>(bands_.go_to(band.y, band.height));
        if (Diagnostics found = checkpoint_.load(bands_.film()); !found.empty()) {
            return found;
        }
        if (!part) {
            return part.diagnostics;
        }
        if (Diagnostics found = take(render::TiledFile::reopen(
                std::move(*part), request_.output, bands_.film(), window_, heading->finished));
            !found.empty()) {
            return found;
        }
        const std::size_t first = window_.y + file_->rows() * render::file_tile_side;
        if (first != band.y && bands_.begin_at(first)) {
            tell(observer_, {warning(fmt::format(
                                "'{}' is damaged from row {} on, so these rows are rendered again",
                                render::TiledFile::unfinished(request_.output).string(), first))});
        }
        return {};
    }

    [[nodiscard]] Result<render::Summary> run_band(double seconds_before,
                                                   const std::stop_token& stop) {
        const auto on_progress = [&](const render::Progress& state) {
            if (!observer_.progress) {
                return;
            }
            // Of the whole picture, in parts of a band's tiles.
            constexpr double parts = 1e6;
            const double done = static_cast<double>(state.tiles_done) /
                                static_cast<double>(std::max<std::size_t>(state.tiles, 1));
            render::Progress shown = state;
            shown.tiles = static_cast<std::size_t>(parts);
            shown.tiles_done = static_cast<std::size_t>(parts * bands_.done(done));
            shown.seconds = seconds_before + state.seconds;
            observer_.progress(shown);
        };
        return trace(bands_.job(), bands_.film(), checkpoint_,
                     {.checkpoint_every = request_.job.checkpoint_every,
                      .save_checkpoint = [this] { save(); },
                      .since_checkpoint = seconds_since(saved_),
                      .remedy = checkpoint_.remedy("restore it")},
                     on_progress, stop);
    }

    void save() {
        auto finished = file_->flush(bands_.film());
        tell(observer_, finished ? checkpoint_.save(bands_.film(), *finished)
                                 : as_warnings(std::move(finished.diagnostics)));
        saved_ = Clock::now();
    }

    const Request& request_;
    render::Region window_;
    render::BandedRender& bands_;
    const Observer& observer_;
    CheckpointFile checkpoint_;
    std::optional<render::TiledFile> file_;
    Clock::time_point saved_ = Clock::now();
};

}  // namespace

void render_in_bands(const Request& request, const Loaded& loaded, const camera::Picture& picture,
                     const render::FilmLayout& layout, const Observer& observer,
                     const std::stop_token& stop, Report& report) {
    if (request.job.save_every || request.job.time_limit || request.job.display) {
        constexpr double giga = 1e9;
        report.diagnostics.push_back(
            error(Kind::usage,
                  fmt::format("the picture takes {:.1f} GB and is rendered in bands, which "
                              "--save-every, --time-limit and --display cannot do",
                              render::film_bytes(layout) / giga),
                  "raise --film-memory, omit layers with --layers, or omit these options"));
        return;
    }
    if (request.denoise) {
        tell(observer, {warning("a picture that is rendered in bands is not denoised", {},
                                "raise --film-memory if the machine has more")});
    }
    const double bytes = std::min(request.job.film_bytes(), enough_for_a_band);
    Result<render::BandedRender> bands =
        render::BandedRender::make(*loaded.renderer, picture, loaded.settings, layout,
                                   render::band_height(layout, bytes), stop);
    if (add(report.diagnostics, bands.diagnostics)) {
        return;
    }
    const render::Region window =
        layout.window.value_or(render::Region{0, 0, layout.width, layout.height});
    BandedRun run(request, loaded, window, observer, *bands);
    if (add(report.diagnostics, run.begin())) {
        return;
    }
    Result<render::Summary> summary = run.run(stop);
    if (!summary && run.checkpoint().is_used()) {
        summary.diagnostics.back().remedy = run.checkpoint().remedy("correct that");
    }
    if (add(report.diagnostics, summary.diagnostics)) {
        return;
    }
    describe(report, loaded, picture, {window, loaded.settings.background.has_value()}, *summary);
    report.in_bands = true;
    report.done = bands->done(0.0);
    if (summary->interrupted) {
        report.checkpoint = run.checkpoint().is_used() ? run.checkpoint().file() : "";
    } else {
        report.output = request.output;
    }
}

}  // namespace balcony::app
