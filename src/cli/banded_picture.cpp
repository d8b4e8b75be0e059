// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/banded_picture.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "balcony/bands.hpp"
#include "cli/interruption.hpp"
#include "cli/paused_run.hpp"
#include "cli/report/report.hpp"

namespace balcony::cli {

namespace {

// More memory would not make rendering faster, but checkpoints larger.
constexpr double enough_for_a_band = 0x1p28;

/// The bands of a picture, its file, and the checkpoint of the band in progress.
class BandedRun {
public:
    BandedRun(const RenderOptions& options, const Request& request,
              std::vector<std::filesystem::path> files, const render::Region& window,
              const PictureOutput& output, render::BandedRender& bands)
        : request_(request),
          window_(window),
          picture_(output.file()),
          bands_(bands),
          display_(options.quiet || options.json),
          checkpoint_(output.file(), option_facts(*options.command), std::move(files),
                      request.since) {}

    [[nodiscard]] const CheckpointFile& checkpoint() const { return checkpoint_; }

    /// Begins the file, or continues it if that is asked for and there is a checkpoint.
    [[nodiscard]] Diagnostics begin() {
        if (request_.job.resume && checkpoint_.exists()) {
            return resume();
        }
        if (checkpoint_.exists()) {
            tell(
                {warning(fmt::format("'{}' is left from an interrupted render and will be replaced",
                                     checkpoint_.file().string()),
                         {}, "add --resume to continue that render")});
        }
        return take(render::TiledFile::create(picture_, bands_.film(), window_));
    }

    /// Renders all bands. A run that is interrupted without a stop ended because a texture
    /// vanished.
    [[nodiscard]] Result<render::Summary> run(const std::stop_token& stop) {
        Result<render::Summary> total{render::Summary{}};
        do {
            Result<render::Summary> band = run_band(total->seconds, stop);
            total.diagnostics.insert(total.diagnostics.end(), band.diagnostics.begin(),
                                     band.diagnostics.end());
            if (!band) {
                return std::move(total.diagnostics);
            }
            render::add(*total, *band);
            if (total->interrupted) {
                if (stop.stop_requested()) {
                    save();
                }
                return total;
            }
            if (const Diagnostics found = file_->add(bands_.film()); has_errors(found)) {
                return found;
            }
        } while (bands_.next());
        if (const Diagnostics found = file_->commit(); has_errors(found)) {
            return found;
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
        return take(render::TiledFile::reopen(picture_, bands_.film(), window_));
    }

    [[nodiscard]] Result<render::Summary> run_band(double seconds_before,
                                                   const std::stop_token& stop) {
        RunLimits limits;
        limits.gives_up = [this](const Diagnostics& found) {
            return !found.empty() && checkpoint_.is_used();
        };
        if (const auto every = request_.job.checkpoint_every) {
            limits.pauses.push_back(
                {*every, [this] { save(); }, std::max(*every - since_saved(), 0.0)});
        }
        const auto on_progress = [&](const render::Progress& state) {
            // Of the whole picture, in parts of a band's tiles.
            constexpr double parts = 1e6;
            const double done = static_cast<double>(state.tiles_done) /
                                static_cast<double>(std::max<std::size_t>(state.tiles, 1));
            render::Progress shown = state;
            shown.tiles = static_cast<std::size_t>(parts);
            shown.tiles_done = static_cast<std::size_t>(parts * bands_.done(done));
            shown.seconds = seconds_before + state.seconds;
            display_.show(shown);
        };
        Result<render::Summary> summary = run_with_pauses(bands_.job(), limits, on_progress, stop);
        display_.clear();
        return summary;
    }

    void save() {
        Diagnostics found = file_->flush();
        for (Diagnostic& diagnostic : found) {
            diagnostic.severity = Severity::warning;
            diagnostic.remedy = "make room or allow writing there; the next attempt follows";
        }
        tell(found.empty() ? checkpoint_.save(bands_.film()) : found);
        saved_ = Clock::now();
    }

    // At once, because the end may be hours away.
    void tell(const Diagnostics& diagnostics) {
        if (!diagnostics.empty()) {
            display_.clear();
            report(diagnostics);
        }
    }

    const Request& request_;
    render::Region window_;
    std::filesystem::path picture_;
    render::BandedRender& bands_;
    ProgressDisplay display_;
    CheckpointFile checkpoint_;
    std::optional<render::TiledFile> file_;
    Clock::time_point saved_ = Clock::now();
};

}  // namespace

RenderReport make_banded_picture(RenderReport outcome, const RenderOptions& options,
                                 const Request& request, const Loaded& loaded,
                                 const camera::Picture& picture, const render::FilmLayout& layout,
                                 const PictureOutput& output) {
    if (request.job.save_every || request.job.time_limit) {
        constexpr double giga = 1e9;
        return failed(
            std::move(outcome), ExitCode::wrong_usage,
            {error(fmt::format("the picture takes {:.1f} GB and is rendered in bands, which "
                               "--save-every and --time-limit cannot do",
                               render::film_bytes(layout) / giga),
                   {}, "raise --film-memory, omit layers with --layers, or omit these options")});
    }
    const double bytes = std::min(request.job.film_bytes(), enough_for_a_band);
    Result<render::BandedRender> bands = render::BandedRender::make(
        *loaded.renderer, picture, request.settings, layout, render::band_height(layout, bytes));
    add(outcome, bands.diagnostics);
    if (!bands) {
        return failed(std::move(outcome), ExitCode::bad_input, {});
    }
    const render::Region window =
        layout.window.value_or(render::Region{0, 0, layout.width, layout.height});
    const Job interruption;
    BandedRun run(options, request, loaded.files(), window, output, *bands);
    if (const Diagnostics found = run.begin(); has_errors(found)) {
        return failed(std::move(outcome), ExitCode::environment, found);
    }
    const Result<render::Summary> summary = run.run(interruption.token());
    const std::string checkpoint = run.checkpoint().file().string();
    if (!summary) {
        Diagnostics found = summary.diagnostics;
        if (run.checkpoint().is_used()) {
            found.front().remedy =
                fmt::format("correct that and continue with --resume from '{}'", checkpoint);
        }
        return failed(std::move(outcome), ExitCode::environment, found);
    }
    add(outcome, summary.diagnostics);
    if (summary->interrupted && !interruption.token().stop_requested()) {
        return failed(
            std::move(outcome), ExitCode::environment,
            {error("a texture cannot be read any more, so the render ends", {},
                   fmt::format("restore it and continue with --resume from '{}'", checkpoint))});
    }
    // What a report needs of the film.
    render::Film film;
    film.width = layout.width;
    film.height = layout.height;
    film.window = window;
    film.background = request.settings.background;
    describe(outcome, output, picture, film, *summary);
    describe_preparation(outcome, loaded);
    outcome.facts["exposure"] = 0.0;
    if (summary->interrupted) {
        outcome.sentence = fmt::format("interrupted after {:.0f} %; --resume continues from {}\n",
                                       100.0 * bands->done(0.0), checkpoint);
        outcome.code = ExitCode::interrupted;
    } else {
        outcome.facts["output"] = output.file().string();
        outcome.code = ExitCode::done;
    }
    return outcome;
}

}  // namespace balcony::cli
