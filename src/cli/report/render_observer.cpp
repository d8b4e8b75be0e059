// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/report/render_observer.hpp"

#include <fmt/format.h>

#include "cli/report/report.hpp"

namespace balcony::cli {

RenderObserver::RenderObserver(const Manner& manner) : display_(manner.quiet || manner.json) {
    observer_.progress = [this](const render::Progress& state) { display_.show(state); };
    observer_.tell = [this](const Diagnostics& diagnostics) {
        display_.clear();
        report(diagnostics);
    };
    observer_.step = [this](app::Step step, double part) {
        display_.show_step(step == app::Step::reading ? "reading the scene" : "preparing the scene",
                           part);
    };
    observer_.bytes = [](std::span<const std::uint8_t> bytes) { print_bytes(bytes); };
    observer_.frame = [this](std::size_t frame, std::size_t index, std::size_t count) {
        display_.begin_frame(frame, index, count);
    };
    observer_.film = [this](std::size_t picture, std::size_t count) {
        if (picture < count) {
            display_.show_text(fmt::format("film: picture {} of {}", picture + 1, count));
        } else {
            display_.clear();
        }
    };
}

}  // namespace balcony::cli
