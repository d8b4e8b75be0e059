// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/animation/frame_loop.hpp"

#include <algorithm>
#include <span>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "app/animation/frame_file.hpp"
#include "app/animation/held_look.hpp"
#include "app/picture/checkpoint_file.hpp"
#include "app/picture/findings.hpp"
#include "app/picture/paused_run.hpp"
#include "app/picture/picture_facts.hpp"
#include "app/words.hpp"
#include "balcony/content_hash.hpp"
#include "balcony/motion.hpp"

namespace balcony::app {

namespace {

namespace fs = std::filesystem;
// What all frames depend on: the number of frames if the turn does, and hashes of all files.
render::RenderFacts frame_facts(const AnimationRequest& animation, const FrameNumbers& frames,
                                const render::FilmLayout& layout, bool is_displayed,
                                const std::vector<fs::path>& files) {
    render::RenderFacts facts{{"Balcony", BALCONY_VERSION},
                              {"the size", fmt::format("{}x{}", layout.width, layout.height)},
                              {"--start-time", fmt::format("{}", animation.start_time)},
                              {"--turntable", animation.turntable ? "true" : ""},
                              {"--around", animation.around},
                              {"--same-noise", animation.same_noise ? "true" : ""}};
    const render::RenderFacts options = facts_of(
        animation.picture, is_displayed ? FactsOf::display : FactsOf::exr, /*is_frame=*/true);
    facts.insert(facts.end(), options.begin(), options.end());
    if (animation.turntable) {
        facts.push_back({"--frames", text_of(frames)});
    }
    if (animation.identity) {
        ContentHash hash;
        hash.add(std::as_bytes(std::span(*animation.identity)));
        facts.push_back({"the camera", fmt::format("#{:016x}", hash.value())});
    }
    const render::RenderFacts hashes = facts_of(files);
    facts.insert(facts.end(), hashes.begin(), hashes.end());
    return facts;
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

FrameLoop::FrameLoop(const AnimationRequest& animation, Loaded& loaded, camera::Picture picture,
                     const render::FilmLayout& layout, const Observer& observer,
                     AnimationReport& report)
    : animation_(animation),
      request_(animation.picture),
      loaded_(loaded),
      wanted_(picture),
      picture_(std::move(picture)),
      layout_(layout),
      observer_(observer),
      report_(report),
      inverses_(request_, {layout.width, layout.height}),
      seed_(request_.settings.sampling.seed) {}

bool FrameLoop::fails(const Diagnostics& found) { return add(report_.diagnostics, found); }

fs::path FrameLoop::file_of(const FrameUnit& unit) const {
    const fs::path frame = animation_.pattern.file(unit.frame);
    return unit.part.count > 1 ? shard_file(frame, unit.part) : frame;
}

bool FrameLoop::is_finished(const FrameUnit& unit) {
    const auto is_whole = [&](const fs::path& file, const auto& damage_of) {
        if (!record_.is_finished(file)) {
            return false;
        }
        const std::optional<Diagnostic> damage = damage_of(file);
        if (damage) {
            add_once({warning(fmt::format("frame {}: '{}' is damaged and is rendered again: {}",
                                          unit.frame, file.string(), damage->message))});
            return false;
        }
        // A process that is killed between the two leaves both.
        CheckpointFile(file, {}, {}, loaded_.since).remove();
        return true;
    };
    const auto damage_of_frame = [](const fs::path& file) {
        return why_damaged(file, FramePart::end);
    };
    const auto damage_of_part = [](const fs::path& file) {
        return render::is_whole_shard(file) ? std::nullopt
                                            : std::optional(error("it is truncated"));
    };
    return is_whole(animation_.pattern.file(unit.frame), damage_of_frame) ||
           (unit.part.count > 1 && is_whole(file_of(unit), damage_of_part));
}

bool FrameLoop::is_displayed() const {
    return render::display_format(animation_.pattern.file(1)) != nullptr;
}

// Continues the frames that are there if they are of the same settings.
bool FrameLoop::begin_frames(const FrameNumbers& frames) {
    const FramePattern& pattern = animation_.pattern;
    auto before = read_record(pattern);
    if (!before && !animation_.overwrite) {
        return !fails(before.diagnostics);
    }
    record_ = {frame_facts(animation_, frames, layout_, is_displayed(), loaded_.files()),
               frames,
               request_.shutter.rate,
               animation_.film ? animation_.film->crf : std::nullopt,
               {}};
    const bool has_record = before && before->has_value();
    Diagnostics found;
    if (has_record && !animation_.overwrite) {
        const std::string why = (*before)->difference_from(record_.facts);
        if (!why.empty()) {
            return !fails({error(
                Kind::input,
                fmt::format("the frames at '{}' are of another animation: {}", pattern.text(), why),
                "restore that to continue them, add --overwrite to replace them, or name "
                "another output")});
        }
        record_.since = (*before)->since;
        const bool same = (*before)->frames == frames && (*before)->rate == record_.rate &&
                          (*before)->crf == record_.crf;
        found = same ? Diagnostics{} : change_record(pattern, record_);
    } else {
        const FrameNumbers there = animation_.overwrite ? FrameNumbers{} : pattern.existing();
        const auto in_the_way =
            std::find_first_of(there.begin(), there.end(), frames.begin(), frames.end());
        if (in_the_way != there.end()) {
            return !fails(
                {error(Kind::input,
                       fmt::format("'{}' is there already, and nothing tells how it was rendered",
                                   pattern.file(*in_the_way).string()),
                       "add --overwrite to replace such frames, or name another output")});
        }
        found = begin_record(pattern, record_);
    }
    return !fails(found);
}

// The warnings of one frame stand for those of all. A stop is no mistake, wherever it comes:
// AnimationReport::interrupted tells it.
void FrameLoop::add_once(const Diagnostics& diagnostics) {
    for (const Diagnostic& one : diagnostics) {
        if (one.kind != Kind::interrupted && told_.insert(one.message).second) {
            report_.diagnostics.push_back(one);
        }
    }
}

// What stands still is not prepared again.
bool FrameLoop::go_to(std::size_t frame, const std::stop_token& stop) {
    render::Settings& settings = loaded_.settings;
    settings.time = animation_.time_of(frame);
    settings.sampling.seed =
        seed_ + (animation_.same_noise ? 0U : static_cast<std::uint32_t>(frame));
    Diagnostics found;
    if (loaded_.scene->motion) {
        Result<scene::Scene> moved = scene::moved_to(*loaded_.scene, settings.time);
        loaded_.scene = std::make_shared<const scene::Scene>(std::move(*moved));
        if (!moved.diagnostics.empty() && !std::exchange(warned_of_motion_, true)) {
            add(report_.diagnostics, moved.diagnostics);
        }
    }
    if (has_moving_camera(request_, *loaded_.scene)) {
        const Result<camera::Picture> moved =
            picture_at(request_, *loaded_.scene, wanted_, settings.time);
        add_once(moved.diagnostics);
        if (!moved) {
            return false;
        }
        picture_ = *moved;
        job_.reset();
    }
    bool moved = move_along(picture_, loaded_, stop, found);
    moved = moved && !add(found, pass_starts(request_.inside, picture_,
                                             {layout_.width, layout_.height}, loaded_, stop));
    if (moved && layout_.layers.contains(render::LayerId::motion)) {
        moved = !add(found, inverses_.add_to(settings, *loaded_.scene, picture_, stop));
    }
    add_once(found);
    return moved;
}

Result<render::Summary> FrameLoop::trace_unit(const FrameUnit& unit,
                                              const std::shared_ptr<render::Film>& shared,
                                              CheckpointFile& checkpoint,
                                              const std::stop_token& stop) {
    Result<render::Job> job =
        job_ ? job_->again(*loaded_.renderer, loaded_.settings, shared, stop)
             : render::Job::make(*loaded_.renderer, picture_, loaded_.settings, shared, stop);
    if (!job) {
        return std::move(job.diagnostics);
    }
    job_ = *job;
    render::Film& film = *shared;
    if (checkpoint.exists() && !animation_.overwrite) {
        Diagnostics found = checkpoint.load(film);
        for (Diagnostic& one : found) {
            one.severity = Severity::warning;
            one.remedy = "the frame begins anew";
        }
        tell(observer_, found);
    }
    return trace(*job_, film, checkpoint,
                 {.checkpoint_every = request_.job.checkpoint_every,
                  .save_checkpoint = [&] { tell(observer_, checkpoint.save(film)); },
                  .shard = unit.part.count > 1 ? std::optional(unit.part) : std::nullopt,
                  .samples = loaded_.settings.samples,
                  .remedy = "restore it and give the same command again"},
                 observer_.progress, stop);
}

Diagnostics FrameLoop::write_unit(const FrameUnit& unit, render::Film& film) {
    if (animation_.film && !film.background) {
        film.background = render::Color3f(0.0F);
    }
    Finish finish = finish_of(request_);
    finish.output = animation_.pattern.file(unit.frame);
    if (unit.part.count > 1) {
        return render::write_shard(
            film,
            {.shard = unit.part, .facts = record_.facts, .frame = unit.frame, .finish = finish},
            file_of(unit));
    }
    Diagnostics found;
    static_cast<void>(try_to_denoise(finish, film, found));
    add_once(found);
    return write(finish, film, observer_);
}

void FrameLoop::describe_first(const FrameUnit& unit, const render::Film& film,
                               const render::Summary& summary) {
    if (std::exchange(described_, true) || unit.part.count > 1) {
        return;
    }
    Finish finish = finish_of(request_);
    finish.output = animation_.pattern.file(unit.frame);
    Report found;
    describe(found, loaded_, picture_, {film.window, film.background.has_value()}, summary);
    describe_sight(found, loaded_, picture_, {film.width, film.height}, {});
    add(found.diagnostics, warn_of_lost_alpha(film, finish));
    for (Diagnostic& one : found.diagnostics) {
        one.message = fmt::format("frame {}: {}", unit.frame, one.message);
    }
    add(report_.diagnostics, found.diagnostics);
}

bool FrameLoop::render(const FrameUnit& unit, const std::stop_token& stop) {
    const Clock::time_point begin = Clock::now();
    if (!go_to(unit.frame, stop)) {
        report_.interrupted = stop.stop_requested();
        return false;
    }
    Result<render::Film> made = make_film(layout_, request_);
    if (fails(made.diagnostics)) {
        return false;
    }
    const auto film = std::make_shared<render::Film>(std::move(*made));
    render::RenderFacts facts = record_.facts;
    facts.push_back({"the frame", fmt::format("{}", unit.frame)});
    const fs::path file = file_of(unit);
    CheckpointFile checkpoint(file, {.sums = facts}, {}, loaded_.since);
    const Result<render::Summary> summary = trace_unit(unit, film, checkpoint, stop);
    add_once(summary.diagnostics);
    if (!summary || summary->interrupted) {
        report_.interrupted =
            summary.value.has_value() || kind_of_errors(summary.diagnostics) == Kind::interrupted;
        return false;
    }
    describe_first(unit, *film, *summary);
    const Clock::time_point traced = Clock::now();
    if (Diagnostics found = write_unit(unit, *film); has_errors(found)) {
        found.front().remedy =
            "correct that and give the same command again; the frames before "
            "this one are finished";
        return !fails(found);
    }
    checkpoint.remove();
    report_.rendered.push_back(
        {unit.frame, file, summary->seconds, seconds_since(traced), seconds_since(begin)});
    return true;
}

void FrameLoop::run(const FrameNumbers& frames, const std::stop_token& stop) {
    const Clock::time_point begin = Clock::now();
    if (!begin_frames(frames)) {
        return;
    }
    const std::vector<FrameUnit> all =
        units_of(frames, animation_.parts_per_frame, animation_.shard.value_or(render::Shard{}));
    std::vector<FrameUnit> units = all;
    std::erase_if(units, [this](const FrameUnit& unit) { return is_finished(unit); });
    bool good = units.empty() || hold_look(request_, loaded_, picture_, layout_, is_displayed(),
                                           report_.diagnostics, stop);
    for (std::size_t i = 0; i < units.size() && good; ++i) {
        if (stop.stop_requested()) {
            report_.interrupted = true;
            break;
        }
        if (observer_.frame) {
            observer_.frame(units[i].frame, i, units.size());
        }
        good = render(units[i], stop);
    }
    report_.is_rendered = true;
    report_.frames = frames;
    report_.skipped = all.size() - units.size();
    report_.exposure = request_.exposure.value_or(0.0);
    report_.width = layout_.width;
    report_.height = layout_.height;
    report_.seconds = seconds_since(begin);
}

}  // namespace balcony::app
