// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/bands.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "film/sums/film_arrays.hpp"

namespace balcony::render {

namespace {

// 2^17 x 2^17: days of work and hundreds of gigabytes.
constexpr double max_pixels = 0x1p34;

Region window_of(const FilmLayout& layout) {
    return layout.window.value_or(Region{0, 0, layout.width, layout.height});
}

Diagnostics check(const Settings& settings, const Region& window) {
    const double pixels = static_cast<double>(window.width) * static_cast<double>(window.height);
    if (pixels > max_pixels) {
        return {error(
            Kind::usage,
            fmt::format("a picture of {} x {} pixels is too large", window.width, window.height),
            fmt::format("render at most {:.0f} pixels at once", max_pixels))};
    }
    if (settings.sampling.noise > 0.0 && !settings.sampling.white) {
        return {error(Kind::usage,
                      "a noise level in a picture that is rendered in bands needs to know white",
                      "set the exposure")};
    }
    return {};
}

}  // namespace

std::size_t band_height(const FilmLayout& layout, double bytes) {
    const Region window = window_of(layout);
    FilmLayout row = layout;
    row.window = Region{window.x, window.y, window.width, file_tile_side};
    const double rows = std::floor(bytes / film_bytes(row));
    const double all = static_cast<double>(window.height / file_tile_side + 1);
    return file_tile_side * static_cast<std::size_t>(std::clamp(rows, 1.0, all));
}

void add(Summary& total, const Summary& part) {
    const double seconds = total.seconds + part.seconds;
    if (seconds > 0.0) {
        total.camera_share =
            (total.camera_share * total.seconds + part.camera_share * part.seconds) / seconds;
    }
    total.layers.resize(part.layers.size());
    for (std::size_t i = 0; i < part.layers.size(); ++i) {
        total.layers[i].name = part.layers[i].name;
        total.layers[i].add(part.layers[i]);
    }
    total.camera_rays += part.camera_rays;
    total.invalid_rays += part.invalid_rays;
    total.invalid_pixels += part.invalid_pixels;
    total.repaired += part.repaired;
    total.unknown_motion += part.unknown_motion;
    total.ambiguous_motion += part.ambiguous_motion;
    total.ambient = part.ambient;
    total.light = part.light;
    total.passes = part.passes;
    total.interrupted = part.interrupted;
    total.seconds = seconds;
    total.compile_seconds = part.compile_seconds;
}

Result<BandedRender> BandedRender::make(const Renderer& renderer, const camera::Picture& picture,
                                        const Settings& settings, const FilmLayout& layout,
                                        std::size_t rows, const std::stop_token& stop) {
    if (rows == 0 || rows % file_tile_side != 0) {
        return error(Kind::internal, "the rows of a band are no multiple of file_tile_side");
    }
    const Region window = window_of(layout);
    if (Diagnostics found = check(settings, window); !found.empty()) {
        return found;
    }
    FilmLayout first = layout;
    first.window = Region{window.x, window.y, window.width, std::min(rows, window.height)};
    Result<Film> made = make_film(first);
    if (!made) {
        return std::move(made.diagnostics);
    }
    Result<Job> job =
        Job::make(renderer, picture, settings, std::make_shared<Film>(std::move(*made)), stop);
    if (!job) {
        return std::move(job.diagnostics);
    }
    return {BandedRender(window, rows, std::move(*job)), std::move(job.diagnostics)};
}

bool BandedRender::next() {
    const Region& band = job_.film()->window;
    return begin_at(band.y + band.height);
}

bool BandedRender::begin_at(std::size_t first_row) {
    const std::size_t end = window_.y + window_.height;
    return first_row < end && go_to(first_row, std::min(rows_, end - first_row));
}

bool BandedRender::go_to(std::size_t first_row, std::size_t rows) {
    const std::size_t end = window_.y + window_.height;
    const auto at_tile = [&](std::size_t row) { return (row - window_.y) % file_tile_side == 0; };
    if (first_row < window_.y || first_row >= end || rows == 0 || rows > end - first_row ||
        !at_tile(first_row) || !(at_tile(first_row + rows) || first_row + rows == end)) {
        return false;
    }
    begin_anew(*job_.film(), {window_.x, first_row, window_.width, rows});
    return true;
}

double BandedRender::done(double part_of_band) const {
    const Region& band = job_.film()->window;
    return (static_cast<double>(band.y - window_.y) +
            part_of_band * static_cast<double>(band.height)) /
           static_cast<double>(window_.height);
}

}  // namespace balcony::render
