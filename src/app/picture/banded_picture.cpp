// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/picture/banded_picture.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "app/picture/findings.hpp"
#include "app/picture/paused_run.hpp"
#include "app/words.hpp"
#include "balcony/bands.hpp"

namespace balcony::app {

namespace {

// More memory would not make rendering faster, but checkpoints larger.
constexpr double enough_for_a_band = 0x1p28;

/// The bands of a picture, its file, and the checkpoint of the band in progress.
class BandedRun {
public:
    BandedRun(const Request& request, const Loaded& loaded, const render::Region& window,
              const Observer& observer, render::BandedRender& bands)
        : request_(request),
          window_(window),
          bands_(bands),
          observer_(observer),
          checkpoint_(request.output, request.given, loaded.files(), loaded.since) {}

    [[nodiscard]] const CheckpointFile& checkpoint() const { return checkpoint_; }

    /// Begins the file, or continues it if that is asked for and there is a checkpoint.
    [[nodiscard]] Diagnostics begin() {
        if (request_.job.resume && checkpoint_.exists()) {
            return resume();
        }
        tell(observer_, checkpoint_.replaced());
        return of_kind(Kind::environment,
                       take(render::TiledFile::create(request_.output, bands_.film(), window_)));
    }

    /// Renders all bands.
    [[nodiscard]] Result<render::Summary> run(const std::stop_token& stop) {
        Result<render::Summary> total{render::Summary{}};
        do {
            Result<render::Summary> band = run_band(total->seconds, stop);
            add(total.diagnostics, band.diagnostics);
            if (!band) {
                return std::move(total.diagnostics);
            }
            render::add(*total, *band);
            if (total->interrupted) {
                save();
                return total;
            }
            if (Diagnostics found = file_->add(bands_.film()); has_errors(found)) {
                return of_kind(Kind::environment, std::move(found));
            }
        } while (bands_.next());
        if (Diagnostics found = file_->commit(); has_errors(found)) {
            return of_kind(Kind::environment, std::move(found));
        }
        checkpoint_.remove();
        return total;
    }

private:
    using Clock = std::chrono::steady_clock;

    [[nodiscard]] double since_saved() const {
        return std::chrono::duration<double>(Clock::now() - saved_).count();
    }

    [[nodiscard]] Diagnostics take(Result<render::TiledFile> file) {
        file_ = std::move(file.value);
        return std::move(file.diagnostics);
    }

    [[nodiscard]] Diagnostics resume() {
        const auto rows = checkpoint_.rows();
        if (!rows) {
            return rows.diagnostics;
        }
        if (!bands_.go_to(rows->first, rows->second)) {
            return {error(fmt::format("'{}' cannot be resumed: it is of another picture",
                                      checkpoint_.file().string()),
                          {}, "render without --resume to begin anew")};
        }
        if (Diagnostics found = checkpoint_.load(bands_.film()); has_errors(found)) {
            return found;
        }
        return take(render::TiledFile::reopen(request_.output, bands_.film(), window_));
    }

    [[nodiscard]] Result<render::Summary> run_band(double seconds_before,
                                                   const std::stop_token& stop) {
        TraceLimits limits;
        limits.remedy = checkpoint_.remedy("restore it");
        if (const auto every = request_.job.checkpoint_every) {
            limits.pauses.push_back(
                {*every, [this] { save(); }, std::max(*every - since_saved(), 0.0)});
        }
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
        return trace(bands_.job(), bands_.film(), checkpoint_, limits, on_progress, stop);
    }

    void save() {
        Diagnostics found = file_->flush();
        for (Diagnostic& diagnostic : found) {
            diagnostic.severity = Severity::warning;
            diagnostic.remedy = "make room or allow writing there; the next attempt follows";
        }
        tell(observer_, found.empty() ? checkpoint_.save(bands_.film()) : found);
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
    if (request.job.save_every || request.job.time_limit) {
        constexpr double giga = 1e9;
        add(report.diagnostics,
            {error(Kind::usage,
                   fmt::format("the picture takes {:.1f} GB and is rendered in bands, which "
                               "--save-every and --time-limit cannot do",
                               render::film_bytes(layout) / giga),
                   "raise --film-memory, omit layers with --layers, or omit these options")});
        return;
    }
    const double bytes = std::min(request.job.film_bytes(), enough_for_a_band);
    Result<render::BandedRender> bands = render::BandedRender::make(
        *loaded.renderer, picture, loaded.settings, layout, render::band_height(layout, bytes));
    add(report.diagnostics, bands.diagnostics);
    if (!bands) {
        return;
    }
    const render::Region window =
        layout.window.value_or(render::Region{0, 0, layout.width, layout.height});
    BandedRun run(request, loaded, window, observer, *bands);
    if (const Diagnostics found = run.begin(); has_errors(found)) {
        add(report.diagnostics, found);
        return;
    }
    Result<render::Summary> summary = run.run(stop);
    if (!summary && run.checkpoint().is_used()) {
        summary.diagnostics.back().remedy = run.checkpoint().remedy("correct that");
    }
    add(report.diagnostics, summary.diagnostics);
    if (!summary) {
        return;
    }
    describe(report, loaded, picture, {window, loaded.settings.background.has_value()}, *summary);
    report.in_bands = true;
    report.done = bands->done(0.0);
    if (summary->interrupted) {
        report.checkpoint = run.checkpoint().file();
    } else {
        report.output = request.output;
    }
}

}  // namespace balcony::app
