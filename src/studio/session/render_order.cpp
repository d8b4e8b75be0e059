// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "studio/session/render_order.hpp"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "lsp/rpc.hpp"
#include "studio/session/view_messages.hpp"

namespace balcony::studio {

using nlohmann::json;
namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_samples = 1'000'000;
constexpr std::size_t most_frames = 1'000'000;

app::Request picture_of(const Options& options, const json& asked) {
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

// From the time 0 on, as the line of time counts its frames.
app::AnimationRequest film_of(app::Request picture, const json& asked) {
    app::AnimationRequest made;
    made.frames.emplace(count_of(asked.at("frames"), most_frames, "a number of frames"));
    std::iota(made.frames->begin(), made.frames->end(), 1);
    made.turntable = asked.value("turntable", false);
    made.picture = std::move(picture);
    return made;
}

std::string ending_of(const json& asked) {
    std::vector<std::string> names{"png", "exr"};
    for (const std::string& film : app::film_extensions()) {
        names.push_back(film.substr(1));
    }
    const std::string name = asked.value("output", names.front());
    if (std::find(names.begin(), names.end(), name) == names.end()) {
        throw lsp::Refusal{lsp::invalid_params,
                           fmt::format("an output is one of {}", fmt::join(names, ", "))};
    }
    return "." + name;
}

double part_of(const render::Progress& progress) {
    return static_cast<double>(progress.tiles_done) / static_cast<double>(progress.tiles);
}

Rendered make(live::Inspector& inspector, const app::Request& picture,
              const std::function<void(double, double)>& tell, const std::stop_token& stop) {
    const app::Report report = inspector.render(
        picture,
        {.progress = [&](const auto& progress) { tell(part_of(progress), progress.seconds); }},
        stop);
    return {report.output, report.interrupted,
            report.samples ? report.samples->most : report.summary.passes, report.summary.seconds,
            report.diagnostics};
}

// A frame is as far as its tiles are.
Rendered make(live::Inspector& inspector, const app::AnimationRequest& film,
              const std::function<void(double, double)>& tell, const std::stop_token& stop) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    if (Diagnostics found = app::prepare_output(film); has_errors(found)) {
        return {.diagnostics = std::move(found)};
    }
    double before = 0.0;
    double frame = 1.0;
    app::Observer observer;
    observer.frame = [&](std::size_t, std::size_t index, std::size_t count) {
        frame = 1.0 / static_cast<double>(count);
        before = static_cast<double>(index) * frame;
    };
    observer.progress = [&](const render::Progress& progress) {
        tell(before + frame * part_of(progress),
             std::chrono::duration<double>(Clock::now() - begin).count());
    };
    const app::AnimationReport report = inspector.animate(film, observer, stop);
    std::error_code ignored;
    fs::remove(film.pattern.folder(), ignored);  // If it has no frames.
    return {report.film, report.interrupted, film.picture.samples.value_or(app::default_samples),
            report.seconds, report.diagnostics};
}

}  // namespace

RenderOrder::RenderOrder(const Options& options, const json& asked)
    : ending_(ending_of(asked)), order_(picture_of(options, asked)) {
    if (app::is_film("film" + ending_)) {  // Which wants the name of a file.
        order_ = film_of(std::get<app::Request>(std::move(order_)), asked);
    }
}

bool RenderOrder::is_used(const fs::path& file) const {
    std::error_code ignored;
    return fs::exists(file, ignored) || (std::holds_alternative<app::AnimationRequest>(order_) &&
                                         fs::exists(app::pattern_of_film(file).folder(), ignored));
}

void RenderOrder::write_to(const fs::path& file) {
    if (auto* const picture = std::get_if<app::Request>(&order_)) {
        picture->output = file;
        return;
    }
    auto& film = std::get<app::AnimationRequest>(order_);
    film.picture.output = file;
    film.pattern = app::pattern_of_film(file);
    film.film = {file, film.picture.shutter.rate};
    if (const Diagnostics found = app::check_output(film); has_errors(found)) {
        throw lsp::Refusal{lsp::request_failed, to_text(found)};
    }
}

Rendered RenderOrder::carry_out(live::Inspector& inspector,
                                const std::function<void(double, double)>& tell,
                                const std::stop_token& stop) const {
    return std::visit([&](const auto& order) { return make(inspector, order, tell, stop); },
                      order_);
}

}  // namespace balcony::studio
