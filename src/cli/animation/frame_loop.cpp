// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/animation/frame_loop.hpp"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "balcony/content_hash.hpp"
#include "balcony/motion.hpp"
#include "cli/animation/held_look.hpp"
#include "cli/checkpoint_file.hpp"
#include "cli/denoised_picture.hpp"
#include "cli/frame_pictures.hpp"
#include "cli/paused_run.hpp"
#include "cli/report/report.hpp"
#include "cli/shard_picture.hpp"

namespace balcony::cli {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

// With the number of frames if the turn depends on it, and hashes of all files.
render::RenderFacts facts_of(const AnimateOptions& options, const AnimationRequest& animation,
                             const FrameNumbers& frames, const render::FilmLayout& layout,
                             const std::vector<fs::path>& files) {
    render::RenderFacts facts{{"Balcony", BALCONY_VERSION},
                              {"the size", fmt::format("{}x{}", layout.width, layout.height)}};
    const render::RenderFacts asked = frame_facts(options);
    facts.insert(facts.end(), asked.begin(), asked.end());
    if (animation.turntable) {
        facts.push_back({"--frames", text_of(frames)});
    }
    for (const fs::path& file : files) {
        const auto hash = content_hash(file);
        facts.push_back({fmt::format("the file '{}'", file.string()),
                         hash ? fmt::format("#{:016x}", *hash) : "#unreadable"});
    }
    return facts;
}

void fail(RenderReport& outcome, ExitCode code, const Diagnostics& diagnostics = {}) {
    add(outcome, diagnostics);
    outcome.code = code;
}

}  // namespace

std::vector<FrameUnit> units_of(const FrameNumbers& frames, std::size_t parts,
                                const render::Shard& shard) {
    std::vector<FrameUnit> units;
    for (std::size_t i = shard.index; i < frames.size() * parts; i += shard.count) {
        units.push_back({frames[i / parts], {i % parts, parts}});
    }
    return units;
}

FrameLoop::FrameLoop(const AnimateOptions& options, const AnimationRequest& animation,
                     Request request, Loaded& loaded, camera::Picture picture,
                     const render::FilmLayout& layout)
    : options_(options),
      animation_(animation),
      request_(std::move(request)),
      loaded_(loaded),
      wanted_(picture),
      picture_(std::move(picture)),
      layout_(layout),
      seed_(request_.settings.sampling.seed),
      display_(options.render.quiet || options.render.json) {}

fs::path FrameLoop::file_of(const FrameUnit& unit) const {
    const fs::path frame = animation_.pattern->file(unit.frame);
    return unit.part.count > 1 ? shard_file(frame, unit.part) : frame;
}

bool FrameLoop::is_finished(const FrameUnit& unit) const {
    return record_.is_finished(animation_.pattern->file(unit.frame)) ||
           record_.is_finished(file_of(unit));
}

bool FrameLoop::is_displayed() const {
    return PictureOutput(animation_.pattern->file(1)).display_format() != nullptr;
}

// Continues the frames that are there if they are of the same settings.
bool FrameLoop::begin_frames(const FrameNumbers& frames, RenderReport& outcome) {
    const FramePattern& pattern = *animation_.pattern;
    auto before = read_record(pattern);
    if (!before && !animation_.overwrite) {
        fail(outcome, ExitCode::bad_input, before.diagnostics);
        return false;
    }
    record_ = {facts_of(options_, animation_, frames, layout_, loaded_.files()),
               frames,
               options_.render.shutter.fps,
               options_.words.crf,
               {}};
    const bool has_record = before && before->has_value();
    Diagnostics found;
    if (has_record && !animation_.overwrite) {
        const std::string why = (*before)->difference_from(record_.facts);
        if (!why.empty()) {
            fail(outcome, ExitCode::bad_input,
                 {error(fmt::format("the frames at '{}' are of another animation: {}",
                                    pattern.text(), why),
                        {},
                        "restore that to continue them, add --overwrite to replace them, or name "
                        "another output")});
            return false;
        }
        record_.since = (*before)->since;
        const bool same = (*before)->frames == frames && (*before)->fps == record_.fps &&
                          (*before)->crf == record_.crf;
        found = same ? Diagnostics{} : change_record(pattern, record_);
    } else {
        const FrameNumbers there = animation_.overwrite ? FrameNumbers{} : pattern.existing();
        const auto in_the_way =
            std::find_first_of(there.begin(), there.end(), frames.begin(), frames.end());
        if (in_the_way != there.end()) {
            fail(outcome, ExitCode::bad_input,
                 {error(fmt::format("'{}' is there already, and nothing tells how it was rendered",
                                    pattern.file(*in_the_way).string()),
                        {}, "add --overwrite to replace such frames, or name another output")});
            return false;
        }
        found = begin_record(pattern, record_);
    }
    if (has_errors(found)) {
        fail(outcome, ExitCode::environment, found);
        return false;
    }
    return true;
}

// The warnings of one frame stand for those of all.
void FrameLoop::add_once(RenderReport& outcome, const Diagnostics& diagnostics) {
    for (const Diagnostic& one : diagnostics) {
        if (told_.insert(one.message).second) {
            outcome.diagnostics.push_back(one);
        }
    }
}

// At once, because the end may be hours away.
void FrameLoop::tell(const Diagnostics& diagnostics) {
    if (!diagnostics.empty()) {
        display_.clear();
        report(diagnostics);
    }
}

// What stands still is not prepared again.
bool FrameLoop::go_to(std::size_t frame, RenderReport& outcome) {
    render::Settings& settings = request_.settings;
    settings.time = animation_.time_of(frame);
    settings.sampling.seed =
        seed_ + (animation_.same_noise ? 0U : static_cast<std::uint32_t>(frame));
    const Diagnostics not_moved = scene::move_to(*loaded_.scene, settings.time);
    if (!not_moved.empty() && !std::exchange(warned_of_motion_, true)) {
        add(outcome, not_moved);
    }
    if (has_moving_camera(options_.render, *loaded_.scene)) {
        const Result<camera::Picture> moved =
            picture_at(options_.render, *loaded_.scene, wanted_, settings.time);
        add_once(outcome, moved.diagnostics);
        if (!moved) {
            outcome.code = ExitCode::bad_input;
            return false;
        }
        picture_ = *moved;
        job_.reset();
    }
    RenderReport found;
    const bool moved = move_along(settings, picture_, loaded_, found);
    if (moved && layout_.layers.contains(render::LayerId::motion)) {
        add(found, add_frames(options_.render, *loaded_.scene, picture_,
                              {layout_.width, layout_.height}, settings));
    }
    add_once(outcome, found.diagnostics);
    outcome.code = moved ? outcome.code : ExitCode::bad_input;
    return moved;
}

Result<render::Summary> FrameLoop::trace(const FrameUnit& unit, render::Film& film,
                                         CheckpointFile& checkpoint, const std::stop_token& stop) {
    Result<render::Job> job =
        job_ ? job_->again(*loaded_.renderer, request_.settings, film)
             : render::Job::make(*loaded_.renderer, picture_, request_.settings, film);
    if (!job) {
        return std::move(job.diagnostics);
    }
    job_ = *job;
    if (checkpoint.exists() && !animation_.overwrite) {
        Diagnostics found = checkpoint.load(film);
        for (Diagnostic& one : found) {
            one.severity = Severity::warning;
            one.remedy = "the frame begins anew";
        }
        tell(found);
    }
    RunLimits limits;
    limits.gives_up = [&checkpoint](const Diagnostics& found) {
        return !found.empty() && checkpoint.is_used();
    };
    if (unit.part.count > 1) {
        limits.passes = render::passes_of(film, unit.part,
                                          static_cast<std::uint32_t>(request_.settings.samples));
    }
    if (request_.job.checkpoint_every) {
        limits.pauses.push_back(
            {*request_.job.checkpoint_every, [&] { tell(checkpoint.save(film)); }});
    }
    Result<render::Summary> summary = run_with_pauses(
        *job_, limits, [this](const render::Progress& state) { display_.show(state); }, stop);
    if (summary && summary->interrupted && stop.stop_requested()) {
        tell(checkpoint.save(film));
    }
    return summary;
}

Diagnostics FrameLoop::write(const FrameUnit& unit, render::Film& film,
                             const render::RenderFacts& facts, RenderReport& outcome) {
    if (animation_.film && !film.background) {
        film.background = render::Color3f(0.0F);
    }
    const fs::path frame = animation_.pattern->file(unit.frame);
    const double exposure = request_.exposure.value_or(0.0);
    if (unit.part.count > 1) {
        render::RenderFacts output = output_facts(options_.render, frame);
        for (render::RenderFact& fact : output) {
            fact.value = fact.name == "exposure" ? fmt::format("{}", exposure) : fact.value;
        }
        return write_shard(film, unit.part, facts, output, file_of(unit));
    }
    if (request_.denoise) {
        RenderReport found;
        denoise(request_, film, found);
        add_once(outcome, found.diagnostics);
    }
    return PictureOutput(frame).write(
        film,
        {.exposure = exposure, .view = request_.view, .dither = !options_.render.film.no_dither});
}

void FrameLoop::describe_first(const FrameUnit& unit, const render::Film& film,
                               const render::Summary& summary, RenderReport& outcome) {
    if (std::exchange(described_, true) || unit.part.count > 1) {
        return;
    }
    const PictureOutput output(animation_.pattern->file(unit.frame));
    RenderReport found;
    describe(found, output, picture_, film, summary);
    describe_misses(found, *loaded_.scene, picture_, request_.settings, film, summary);
    warn_of_lost_alpha(found, film, output);
    for (Diagnostic& one : found.diagnostics) {
        one.message = fmt::format("frame {}: {}", unit.frame, one.message);
    }
    add(outcome, found.diagnostics);
}

void FrameLoop::render(const FrameUnit& unit, RenderReport& outcome, const std::stop_token& stop) {
    const Clock::time_point begin = Clock::now();
    if (!go_to(unit.frame, outcome)) {
        return;
    }
    Result<render::Film> film = make_film(layout_, request_);
    if (!film) {
        return fail(outcome, ExitCode::bad_input, film.diagnostics);
    }
    render::RenderFacts facts = record_.facts;
    facts.push_back({std::string(frame_fact), fmt::format("{}", unit.frame)});
    const fs::path file = file_of(unit);
    CheckpointFile checkpoint(file, facts, {}, request_.since);
    const Result<render::Summary> summary = trace(unit, *film, checkpoint, stop);
    if (!summary) {
        return fail(outcome, ExitCode::bad_input, summary.diagnostics);
    }
    add_once(outcome, summary.diagnostics);
    if (summary->interrupted) {
        return stop.stop_requested()
                   ? fail(outcome, ExitCode::interrupted)
                   : fail(outcome, ExitCode::environment,
                          {error("a texture cannot be read any more, so the render ends", {},
                                 "restore it and give the same command again")});
    }
    describe_first(unit, *film, *summary, outcome);
    const Clock::time_point traced = Clock::now();
    if (Diagnostics found = write(unit, *film, facts, outcome); has_errors(found)) {
        found.front().remedy =
            "correct that and give the same command again; the frames before "
            "this one are finished";
        return fail(outcome, ExitCode::environment, found);
    }
    checkpoint.remove();
    outcome.facts["pictures"].push_back({{"frame", unit.frame},
                                         {"file", file.string()},
                                         {"trace_seconds", summary->seconds},
                                         {"write_seconds", seconds_since(traced)},
                                         {"seconds", seconds_since(begin)}});
}

RenderReport FrameLoop::run(RenderReport outcome, const FrameNumbers& frames,
                            const std::stop_token& stop) {
    const Clock::time_point begin = Clock::now();
    if (!begin_frames(frames, outcome)) {
        return outcome;
    }
    const std::vector<FrameUnit> all =
        units_of(frames, animation_.parts_per_frame, animation_.shard.value_or(render::Shard{}));
    std::vector<FrameUnit> units = all;
    std::erase_if(units, [this](const FrameUnit& unit) { return is_finished(unit); });
    outcome.facts["pictures"] = nlohmann::json::array();
    if (!units.empty() &&
        !hold_look(request_, loaded_, picture_, layout_, is_displayed(), outcome, stop)) {
        outcome.code = ExitCode::bad_input;
    }
    for (std::size_t i = 0; i < units.size() && outcome.code == ExitCode::done; ++i) {
        if (stop.stop_requested()) {
            outcome.code = ExitCode::interrupted;
            break;
        }
        display_.begin_frame(units[i].frame, i, units.size());
        render(units[i], outcome, stop);
    }
    display_.clear();
    outcome.facts["frames"] = text_of(frames);
    outcome.facts["rendered"] = outcome.facts["pictures"].size();
    outcome.facts["skipped"] = all.size() - units.size();
    outcome.facts["exposure"] = request_.exposure.value_or(0.0);
    outcome.facts["width"] = layout_.width;
    outcome.facts["height"] = layout_.height;
    outcome.facts["seconds"] = seconds_since(begin);
    return outcome;
}

}  // namespace balcony::cli
