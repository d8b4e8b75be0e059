// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <fmt/format.h>

#include "balcony/names.hpp"
#include "cli/report/render_report.hpp"

namespace balcony::cli {

namespace {

nlohmann::json facts_of(const app::AnimationReport& report, const app::AnimationRequest& request) {
    nlohmann::json facts = nlohmann::json::object();
    if (!report.is_rendered) {
        return facts;
    }
    facts["pictures"] = nlohmann::json::array();
    for (const app::FrameReport& frame : report.rendered) {
        facts["pictures"].push_back({{"frame", frame.frame},
                                     {"file", frame.file.string()},
                                     {"trace_seconds", frame.trace_seconds},
                                     {"write_seconds", frame.write_seconds},
                                     {"seconds", frame.seconds}});
    }
    facts.update({{"frames", app::text_of(report.frames)},
                  {"rendered", report.rendered.size()},
                  {"skipped", report.skipped},
                  {"exposure", report.exposure},
                  {"width", report.width},
                  {"height", report.height},
                  {"seconds", report.seconds}});
    if (!has_errors(report.diagnostics)) {
        facts["output"] = request.picture.output.string();
    }
    return facts;
}

std::string text_of(const app::AnimationReport& report, const app::AnimationRequest& request) {
    const std::string output = request.picture.output.string();
    const bool in_parts = request.parts_per_frame > 1;
    const std::string done = fmt::format(
        "{} rendered in {}{}", counted(report.rendered.size(), in_parts ? "part" : "frame"),
        duration_text(report.seconds),
        report.skipped > 0 ? fmt::format(", {} finished before", report.skipped) : "");
    if (report.interrupted && !report.is_film_missing) {
        return fmt::format("interrupted: {}; the same command continues\n", done);
    }
    std::string text = fmt::format("{}: frames {} of {} x {} pixels, {}\n", printable(output),
                                   app::text_of(report.frames), report.width, report.height, done);
    if (!request.film && report.frames.size() == 1 && report.frames.front() > 1) {
        text += fmt::format("  that frame alone; --frames 1-{} renders the first {}\n",
                            report.frames.front(), report.frames.front());
    }
    if (!request.picture.exposure && report.exposure != 0.0) {
        text += fmt::format("  exposure {:+} stops, that of frame 1; --exposure sets it\n",
                            report.exposure);
    }
    if (request.shard || in_parts) {
        text += fmt::format("  when all shards are done: balcony merge {}\n",
                            request.film ? output : "'" + output + "'");
    }
    if (report.is_film_missing) {
        text += "  interrupted before the film was made\n";
    }
    return text;
}

}  // namespace

Answer answer_of(const app::AnimationReport& report, const app::AnimationRequest& request) {
    Answer answer{report.diagnostics, report.interrupted, facts_of(report, request)};
    answer.text = has_errors(report.diagnostics) ? "" : text_of(report, request);
    return answer;
}

Answer answer_of(const app::MergedAnimation& merged) {
    Answer answer{merged.diagnostics, merged.interrupted};
    answer.facts["merged"] = merged.merged;
    if (!merged.output.empty()) {
        const std::string frames = app::text_of(merged.frames);
        answer.facts["output"] = merged.output.string();
        answer.facts["frames"] = frames;
        answer.text = fmt::format(
            "{}: frames {}, {} merged from parts\n{}", merged.output.string(), frames,
            merged.merged, merged.interrupted ? "  interrupted before the film was made\n" : "");
    }
    return answer;
}

}  // namespace balcony::cli
