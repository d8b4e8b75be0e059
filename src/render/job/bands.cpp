// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/bands.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

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
            fmt::format("a picture of {} x {} pixels is too large", window.width, window.height),
            {}, fmt::format("render at most {:.0f} pixels at once", max_pixels))};
    }
    if (settings.sampling.noise > 0.0 && !settings.sampling.white) {
        return {error("a noise level in a picture that is rendered in bands needs to know white",
                      {}, "set the exposure")};
    }
    return {};
}

}  // namespace

std::size_t band_height(const FilmLayout& layout, double bytes) {
    const Region window = window_of(layout);
    FilmLayout row = layout;
    row.window = Region{window.x, window.y, window.width, tile_height};
    const double rows = std::floor(bytes / film_bytes(row));
    const double all = static_cast<double>(window.height / tile_height + 1);
    return tile_height * static_cast<std::size_t>(std::clamp(rows, 1.0, all));
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
        total.layers[i].camera_rays += part.layers[i].camera_rays;
        total.layers[i].invalid_rays += part.layers[i].invalid_rays;
        total.layers[i].hits += part.layers[i].hits;
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

Result<Summary> render_in_bands(const Renderer& renderer, const camera::Picture& picture,
                                const Settings& settings, const FilmLayout& layout,
                                std::size_t rows, const std::filesystem::path& file,
                                const ProgressCallback& progress, std::stop_token stop) {
    const Region window = window_of(layout);
    if (Diagnostics found = check(settings, window); !found.empty()) {
        return found;
    }
    Result<Summary> total{Summary{}};
    BandedFile output(file, window);
    Progress shown;
    shown.passes = settings.samples;
    for (std::size_t first = 0; first < window.height; first += rows) {
        FilmLayout part = layout;
        part.window =
            Region{window.x, window.y + first, window.width, std::min(rows, window.height - first)};
        Result<Film> film = make_film(part);
        if (!film) {
            return std::move(film.diagnostics);
        }
        Result<Job> job = Job::make(renderer, picture, settings, *film);
        if (!job) {
            return std::move(job.diagnostics);
        }
        const double before = static_cast<double>(first) / static_cast<double>(window.height);
        const double share =
            static_cast<double>(part.window->height) / static_cast<double>(window.height);
        const auto on_progress = [&](const Progress& state) {
            // Of the whole picture, in parts of a band's tiles.
            constexpr double parts = 1e6;
            const double done = static_cast<double>(state.tiles_done) /
                                static_cast<double>(std::max<std::size_t>(state.tiles, 1));
            shown.pass = state.pass;
            shown.tiles = static_cast<std::size_t>(parts);
            shown.tiles_done = static_cast<std::size_t>(parts * (before + share * done));
            shown.seconds = total->seconds + state.seconds;
            if (progress) {
                progress(shown);
            }
        };
        Result<Summary> summary = job->run(on_progress, stop);
        total.diagnostics.insert(total.diagnostics.end(), summary.diagnostics.begin(),
                                 summary.diagnostics.end());
        if (!summary) {
            return std::move(total.diagnostics);
        }
        add(*total, *summary);
        if (Diagnostics found = output.add(*film); has_errors(found)) {
            return found;
        }
    }
    if (Diagnostics found = output.commit(); has_errors(found)) {
        return found;
    }
    return total;
}

}  // namespace balcony::render
