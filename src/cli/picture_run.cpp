// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/picture_run.hpp"

#include <fmt/format.h>

#include "cli/paused_run.hpp"
#include "cli/report/report.hpp"
#include "cli/shard_picture.hpp"

namespace balcony::cli {

PictureRun::PictureRun(const RenderOptions& options, const Request& request,
                       std::vector<std::filesystem::path> files, const PictureOutput& output,
                       render::Film& film)
    : options_(options),
      request_(request),
      output_(output),
      film_(film),
      display_(options.quiet || options.json),
      checkpoint_(request.job.shard ? shard_file(output.file(), *request.job.shard) : output.file(),
                  option_facts(*options.command), std::move(files), request.since) {}

Diagnostics PictureRun::resume() {
    if (request_.job.resume) {
        return checkpoint_.exists() ? checkpoint_.load(film_) : Diagnostics{};
    }
    if (writes_checkpoints() && checkpoint_.exists()) {
        tell({warning(fmt::format("'{}' is left from an interrupted render and will be replaced",
                                  checkpoint_.file().string()),
                      {}, "add --resume to continue that render")});
    }
    return {};
}

Result<render::Summary> PictureRun::run(render::Job& job, const render::ProgressCallback& progress,
                                        const std::stop_token& stop) {
    RunLimits limits{request_.job.time_limit, {}, {}};
    // A texture that vanishes after a checkpoint would spoil the picture.
    limits.gives_up = [this](const Diagnostics& found) {
        return !found.empty() && checkpoint_.is_used();
    };
    if (request_.job.shard) {
        limits.passes = render::passes_of(film_, *request_.job.shard,
                                          static_cast<std::uint32_t>(request_.settings.samples));
    }
    if (request_.job.save_every && !output_.is_stream()) {
        limits.pauses.push_back({*request_.job.save_every, [this] { tell(save()); }});
    }
    if (writes_checkpoints()) {
        limits.pauses.push_back(
            {*request_.job.checkpoint_every, [this] { tell(checkpoint_.save(film_)); }});
    }
    const auto on_progress = [&](const render::Progress& state) {
        display_.show(state);
        progress(state);
    };
    Result<render::Summary> summary = run_with_pauses(job, limits, on_progress, stop);
    display_.clear();
    if (summary && stop.stop_requested() && checkpoint_.is_used()) {
        tell(checkpoint_.save(film_));
    }
    return summary;
}

double PictureRun::exposure() const {
    return request_.exposure                     ? *request_.exposure
           : output_.display_format() != nullptr ? render::automatic_exposure(film_)
                                                 : 0.0;
}

Diagnostics PictureRun::save() const {
    return output_.write(
        film_, {.exposure = exposure(), .view = request_.view, .dither = !options_.film.no_dither});
}

Diagnostics PictureRun::save_shard() {
    const render::Shard& shard = *request_.job.shard;
    render::RenderFacts facts = checkpoint_.facts(film_);
    std::erase_if(facts, [](const render::RenderFact& fact) { return fact.name == "--shard"; });
    return write_shard(film_, shard, facts, output_facts(options_, output_.file()),
                       shard_file(output_.file(), shard));
}

bool PictureRun::writes_checkpoints() const {
    return request_.job.checkpoint_every && !output_.is_stream() && !options_.watch;
}

// At once, because the end may be hours away.
void PictureRun::tell(const Diagnostics& diagnostics) {
    if (!diagnostics.empty()) {
        display_.clear();
        report(diagnostics);
    }
}

}  // namespace balcony::cli
