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

constexpr std::chrono::milliseconds least_pause(200);  // Between two messages of progress.

int number_of(const json& asked) {
    const json& id = asked.at("id");
    return id.is_number_integer() ? id.get<int>() : 0;
}

// Not more often than a page can show it.
std::function<void(double, double)> telling_progress(int number, Server& server,
                                                     const std::function<void(const json&)>& tell) {
    return [number, &server, &tell, last = std::make_shared<Clock::time_point>()](double done,
                                                                                  double seconds) {
        const Clock::time_point now = Clock::now();
        if (now - *last < least_pause) {
            return;
        }
        *last = now;
        server.post([message = lsp::notification(
                         "render/progress", {{"id", number}, {"done", done}, {"seconds", seconds}}),
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
    RenderOrder order(options_, asked);
    const std::filesystem::path file = unused_file(order);
    order.write_to(file);
    const int number = last_number_ + 1;
    const std::stop_source stop;
    inspection_.ask(
        [this, number, order, stop](const auto& inspector, const std::stop_token&) {
            auto made = std::make_shared<Rendered>();
            const auto refusal = lsp::refusal_of([&] {
                *made = order.carry_out(inspector(), telling_progress(number, server_, tell_),
                                        stop.get_token());
            });
            if (refusal) {
                made->diagnostics = {error(refusal->message)};
            }
            server_.post([this, number, made] { end(number, *made); });
        },
        shown);
    last_number_ = number;
    renderings_[number] = {file, stop};
    return {{"id", number}, {"file", file.string()}};
}

void Renderings::stop(const json& asked) {
    const auto found = renderings_.find(number_of(asked));
    if (found == renderings_.end()) {
        throw lsp::Refusal{lsp::request_failed, "there is no such rendering: it may have ended"};
    }
    found->second.stop.request_stop();
}

// my.png, or my-2.png if that is there: no picture is replaced.
std::filesystem::path Renderings::unused_file(const RenderOrder& order) const {
    std::filesystem::path file = options_.file;
    const auto is_used = [&] {
        return order.is_used(file) ||
               std::any_of(renderings_.begin(), renderings_.end(),
                           [&](const auto& one) { return one.second.file == file; });
    };
    file.replace_extension(order.ending());
    for (int i = 2; is_used(); ++i) {
        file = options_.file.parent_path() /
               fmt::format("{}-{}{}", options_.file.stem().string(), i, order.ending());
    }
    return file;
}

void Renderings::end(int number, const Rendered& made) {
    renderings_.erase(number);
    tell_(lsp::notification("render/done",
                            {{"id", number},
                             {"file", made.file.empty() ? json(nullptr) : json(made.file.string())},
                             {"stopped", made.stopped},
                             {"samples", made.samples},
                             {"seconds", made.seconds},
                             {"diagnostics", told_of(made.diagnostics)}}));
}

}  // namespace balcony::studio
