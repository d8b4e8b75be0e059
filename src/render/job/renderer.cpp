// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>
#include <new>

#include <OpenImageIO/sysutil.h>
#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "render/film/film.hpp"
#include "render/job/fork_and_join.hpp"
#include "render/job/tile_worker.hpp"

namespace balcony::render {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

struct IntegratorName {
    Integrator integrator;
    std::string_view name;
};
constexpr std::array integrator_names = {IntegratorName{Integrator::preview, "preview"},
                                         IntegratorName{Integrator::direct, "direct"}};

constexpr std::size_t max_side = std::size_t{1} << 20;
constexpr std::size_t max_samples = std::size_t{1} << 24;
constexpr std::size_t max_threads = 4096;

bool is_finite(const Color3f& c) {
    return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z);
}

Diagnostics check(const Settings& settings) {
    Diagnostics found;
    const auto within = [&](std::size_t value, std::size_t minimum, std::size_t maximum,
                            std::string_view what) {
        if (value < minimum || value > maximum) {
            found.push_back(error(fmt::format("{} {} is out of range", what, value), {},
                                  fmt::format("give a number from {} to {}", minimum, maximum)));
        }
    };
    within(settings.width, 1, max_side, "the picture's width");
    within(settings.height, 1, max_side, "the picture's height");
    within(settings.samples, 1, max_samples, "the number of samples");
    within(settings.threads, 0, max_threads, "the number of threads");
    if (!std::isfinite(settings.time) || !is_finite(settings.ambient) ||
        !is_finite(settings.background.value_or(Color3f(0.0F)))) {
        found.push_back(error("time, ambient light and background must be finite numbers"));
    }
    const auto memory = static_cast<double>(OIIO::Sysutil::physical_memory());
    if (found.empty() && memory > 0.0 && film_bytes(settings) > memory) {
        found.push_back(error(
            fmt::format("a film of {} x {} pixels takes {:.1f} GB, this machine has {:.1f} GB",
                        settings.width, settings.height, film_bytes(settings) / 1e9, memory / 1e9),
            {}, "make the picture smaller, or leave out the data layers"));
    }
    return found;
}

std::vector<PixelTile> cut_into_tiles(std::size_t width, std::size_t height) {
    std::vector<PixelTile> tiles;
    for (std::size_t y = 0; y < height; y += tile_height) {
        for (std::size_t x = 0; x < width; x += tile_width) {
            tiles.push_back(
                {x, y, std::min(tile_width, width - x), std::min(tile_height, height - y)});
        }
    }
    return tiles;
}

// All passes over all tiles on a number of threads.
class Rendering {
public:
    Rendering(const TracedScene& traced, const rays::CompiledPicture& picture,
              const Settings& settings, Film& film, const ProgressCallback& progress,
              std::stop_token stop)
        : settings_(settings),
          tiles_(cut_into_tiles(settings.width, settings.height)),
          workers_([&traced, &picture, &settings, &film] {
              return TileWorker(traced, picture, settings, film);
          }),
          picture_(picture),
          progress_(progress),
          stop_(std::move(stop)) {}

    Summary run() {
        // More threads than the machine has would not run at once.
        const int all = tbb::info::default_concurrency();
        tbb::task_arena arena(
            settings_.threads == 0 ? all : std::min(static_cast<int>(settings_.threads), all));
        Summary summary;
        while (summary.passes < settings_.samples && render_pass(arena, summary.passes)) {
            ++summary.passes;
        }
        WorkCounts counts;
        for (const TileWorker& worker : workers_) {
            counts.add(worker.counts());
        }
        counts.layers.resize(picture_.layers().size());
        for (std::size_t i = 0; i < picture_.layers().size(); ++i) {
            const RayCounts& layer = counts.layers[i];
            summary.layers.push_back(
                {picture_.layers()[i].name, layer.camera_rays, layer.invalid_rays});
            summary.camera_rays += layer.camera_rays;
            summary.invalid_rays += layer.invalid_rays;
        }
        summary.invalid_pixels = counts.invalid_pixels;
        summary.repaired = counts.repaired;
        summary.interrupted = summary.passes < settings_.samples;
        summary.seconds = seconds_since(begin_);
        summary.camera_share = counts.seconds > 0.0 ? counts.camera_seconds / counts.seconds : 0.0;
        return summary;
    }

private:
    // Whether the pass was completed.
    bool render_pass(tbb::task_arena& arena, std::size_t pass) {
        std::atomic<bool> complete = true;
        const auto render_tile = [&](std::size_t i) {
            fork_and_join::before_each();
            if (stop_.stop_requested()) {
                complete = false;
            } else {
                workers_.local().render(tiles_[i], pass);
                report(pass);
            }
            fork_and_join::after_each();
        };
        fork_and_join::before_all();
        arena.execute([&] { tbb::parallel_for(std::size_t{0}, tiles_.size(), render_tile); });
        fork_and_join::after_all();
        return complete;
    }

    void report(std::size_t pass) {
        if (!progress_) {
            return;
        }
        const std::lock_guard lock(progress_mutex_);
        ++tiles_done_;
        progress_({pass, settings_.samples, tiles_done_, tiles_.size() * settings_.samples,
                   seconds_since(begin_)});
    }

    const Settings& settings_;
    std::vector<PixelTile> tiles_;
    tbb::enumerable_thread_specific<TileWorker> workers_;
    const rays::CompiledPicture& picture_;
    const ProgressCallback& progress_;
    std::stop_token stop_;
    Clock::time_point begin_ = Clock::now();
    std::mutex progress_mutex_;
    std::size_t tiles_done_ = 0;
};

}  // namespace

std::string_view name_of(Integrator integrator) {
    return integrator_names[static_cast<std::size_t>(integrator)].name;
}

std::optional<Integrator> find_integrator(std::string_view name) {
    for (const IntegratorName& row : integrator_names) {
        if (row.name == name) {
            return row.integrator;
        }
    }
    return std::nullopt;
}

struct Renderer::State {
    TracedScene traced;
    Preparation preparation;
};

Result<Renderer> Renderer::make(std::shared_ptr<const scene::Scene> scene) {
    assert(scene);
    const Clock::time_point begin = Clock::now();
    Result<embree::Accelerator> accelerator = embree::Accelerator::build(*scene);
    if (!accelerator) {
        return accelerator.diagnostics;
    }
    Diagnostics warnings;
    const double build_seconds = seconds_since(begin);
    auto textures = std::make_unique<const TextureLibrary>(*scene, warnings);
    SurfaceFinder surfaces(*scene);
    const Preparation preparation{build_seconds, seconds_since(begin) - build_seconds};
    const bool textured =
        std::any_of(scene->materials.begin(), scene->materials.end(), has_textures);
    TracedScene traced{std::move(scene), std::move(*accelerator), std::move(surfaces),
                       std::move(textures), textured};
    return {Renderer(std::make_shared<const State>(State{std::move(traced), preparation})),
            std::move(warnings)};
}

const Renderer::Preparation& Renderer::preparation() const { return state_->preparation; }

Result<Picture> Renderer::render(const camera::Picture& picture, const Settings& settings,
                                 const ProgressCallback& progress, std::stop_token stop) const {
    if (Diagnostics found = check(settings); !found.empty()) {
        return found;
    }
    try {
        const TracedScene& traced = state_->traced;
        const Clock::time_point begin = Clock::now();
        // Footprints are of use to textures alone.
        const Result<rays::CompiledPicture> compiled = rays::compile(
            picture, static_cast<double>(settings.width), static_cast<double>(settings.height),
            {.axes = traced.scene->axes, .footprints = traced.textured});
        if (!compiled) {
            return compiled.diagnostics;
        }
        const double compile_seconds = seconds_since(begin);
        Picture made{make_film(settings, *traced.scene), {}};
        for (const rays::CompiledPicture::CameraLayer& layer : compiled->layers()) {
            made.film.picture_layers.push_back(layer.name);
        }
        made.summary =
            Rendering(traced, *compiled, settings, made.film, progress, std::move(stop)).run();
        made.summary.compile_seconds = compile_seconds;
        return {std::move(made), traced.textures->failures()};
    } catch (const std::bad_alloc&) {
        return error("memory ran out while rendering", {},
                     "make the picture smaller, or leave out the data layers");
    }
}

}  // namespace balcony::render
