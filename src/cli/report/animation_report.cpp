// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/report/json.hpp"
#include "cli/report/render_report.hpp"
#include "cli/report/report.hpp"

namespace balcony::cli {

namespace {

std::string name_of(const app::AnimationRequest& request) {
    return request.film ? request.film->file.string() : request.picture.output.string();
}

}  // namespace

nlohmann::json report_json(const app::AnimationReport& report,
                           const app::AnimationRequest& request) {
    nlohmann::json facts{{"diagnostics", to_json(report.diagnostics)}};
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
        facts["output"] = name_of(request);
    }
    return facts;
}

std::string report_text(const app::AnimationReport& report, const app::AnimationRequest& request) {
    const bool in_parts = request.parts_per_frame > 1;
    const std::string done = fmt::format(
        "{} rendered in {}{}",
        counted(report.rendered.size(), in_parts ? "part" : "frame", in_parts ? "parts" : "frames"),
        duration_text(report.seconds),
        report.skipped > 0 ? fmt::format(", {} finished before", report.skipped) : "");
    if (report.interrupted && !report.is_film_missing) {
        return fmt::format("interrupted: {}; the same command continues\n", done);
    }
    std::string text =
        fmt::format("{}: frames {} of {} x {} pixels, {}\n", printable(name_of(request)),
                    app::text_of(report.frames), report.width, report.height, done);
    if (!request.picture.exposure && report.exposure != 0.0) {
        text += fmt::format("  exposure {:+} stops, that of frame 1; --exposure sets it\n",
                            report.exposure);
    }
    if (request.shard || in_parts) {
        text += fmt::format("  when all shards are done: balcony merge {}\n",
                            request.film ? name_of(request) : "'" + name_of(request) + "'");
    }
    if (report.is_film_missing) {
        text += "  interrupted before the film was made\n";
    }
    return text;
}

nlohmann::json report_json(const app::MergedAnimation& merged) {
    nlohmann::json facts{{"diagnostics", to_json(merged.diagnostics)}, {"merged", merged.merged}};
    if (!merged.output.empty()) {
        facts["output"] = merged.output.string();
        facts["frames"] = app::text_of(merged.frames);
    }
    return facts;
}

std::string report_text(const app::MergedAnimation& merged) {
    if (merged.output.empty()) {
        return {};
    }
    return fmt::format("{}: frames {}, {} merged from parts\n{}", merged.output.string(),
                       app::text_of(merged.frames), merged.merged,
                       merged.interrupted ? "  interrupted before the film was made\n" : "");
}

}  // namespace balcony::cli
