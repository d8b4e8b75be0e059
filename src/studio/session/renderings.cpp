// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "studio/session/renderings.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "lsp/rpc.hpp"
#include "studio/session/view_messages.hpp"

namespace balcony::studio {

using nlohmann::json;
using Clock = std::chrono::steady_clock;

namespace {

constexpr std::size_t most_samples = 1'000'000;
constexpr std::chrono::milliseconds least_pause(200);  // Between two messages of progress.

// What a page asks for, in the scene and the light of the studio.
app::Request request_of(const Options& options, const json& asked) {
    app::Request made = options.request;
    made.size.width = count_of(asked.at("width"), app::max_side, "a width");
    made.size.height = count_of(asked.at("height"), app::max_side, "a height");
    if (asked.contains("samples")) {
        made.samples = count_of(asked["samples"], most_samples, "a number of samples");
    }
    made.denoise = asked.value("denoise", false);
    made.job.checkpoint_every.reset();
    return made;
}

std::string ending_of(const json& asked) {
    const std::string format = asked.value("output", "png");
    if (format != "png" && format != "exr") {
        throw lsp::Refusal{lsp::invalid_params, "an output is 'png' or 'exr'"};
    }
    return fmt::format(".{}", format);
}

int number_of(const json& asked) {
    const json& id = asked.at("id");
    return id.is_number_integer() ? id.get<int>() : 0;
}

// Not more often than a page can show it.
render::ProgressCallback telling_progress(int number, Server& server,
                                          const std::function<void(const json&)>& tell) {
    return [number, &server, &tell,
            last = std::make_shared<Clock::time_point>()](const render::Progress& progress) {
        const Clock::time_point now = Clock::now();
        if (now - *last < least_pause) {
            return;
        }
        *last = now;
        const double done =
            static_cast<double>(progress.tiles_done) / static_cast<double>(progress.tiles);
        server.post([message = lsp::notification(
                         "render/progress",
                         {{"id", number}, {"done", done}, {"seconds", progress.seconds}}),
                     &tell] { tell(message); });
    };
}

}  // namespace

Renderings::Renderings(Server& server, const live::View& view, const Options& options,
                       std::function<void(const json&)> tell)
    : server_(server),
      view_(view),
      options_(options),
      tell_(std::move(tell)),
      inspection_(view, options.file.parent_path()) {}

Renderings::~Renderings() {
    for (auto& [number, rendering] : renderings_) {
        rendering.stop.request_stop();
    }
}

json Renderings::start(const json& asked) {
    if (options_.is_read_only) {
        throw lsp::Refusal{lsp::request_failed,
                           "this studio shows only: start it without --read-only to render"};
    }
    const std::optional<live::Shown> shown = view_.shown();
    if (!shown) {
        throw lsp::Refusal{lsp::request_failed, "no picture is shown yet: ask again later"};
    }
    app::Request request = request_of(options_, asked);
    request.output = unused_file(ending_of(asked));
    const int number = last_number_ + 1;
    const std::stop_source stop;
    inspection_.ask(
        [this, number, request, stop](const auto& inspector, const std::stop_token&) {
            auto report = std::make_shared<app::Report>();
            const auto refusal = lsp::refusal_of([&] {
                *report = inspector().render(request,
                                             {.progress = telling_progress(number, server_, tell_)},
                                             stop.get_token());
            });
            if (refusal) {
                report->diagnostics = {error(refusal->message)};
            }
            server_.post([this, number, report] { end(number, *report); });
        },
        shown);
    last_number_ = number;
    renderings_[number] = {request.output, stop};
    return {{"id", number}, {"file", request.output.string()}};
}

void Renderings::stop(const json& asked) {
    const auto found = renderings_.find(number_of(asked));
    if (found == renderings_.end()) {
        throw lsp::Refusal{lsp::request_failed, "there is no such rendering: it may have ended"};
    }
    found->second.stop.request_stop();
}

// my.png, or my-2.png if that is there: no picture is replaced.
std::filesystem::path Renderings::unused_file(const std::string& ending) const {
    std::filesystem::path file = options_.file;
    const auto is_used = [&] {
        std::error_code ignored;
        return std::filesystem::exists(file, ignored) ||
               std::any_of(renderings_.begin(), renderings_.end(),
                           [&](const auto& one) { return one.second.file == file; });
    };
    file.replace_extension(ending);
    for (int i = 2; is_used(); ++i) {
        file = options_.file.parent_path() /
               fmt::format("{}-{}{}", options_.file.stem().string(), i, ending);
    }
    return file;
}

void Renderings::end(int number, const app::Report& report) {
    renderings_.erase(number);
    tell_(lsp::notification(
        "render/done",
        {{"id", number},
         {"file", report.output.empty() ? json(nullptr) : json(report.output.string())},
         {"stopped", report.interrupted},
         {"samples", report.samples ? report.samples->most : report.summary.passes},
         {"seconds", report.summary.seconds},
         {"diagnostics", told_of(report.diagnostics)}}));
}

}  // namespace balcony::studio
