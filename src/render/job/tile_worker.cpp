// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/tile_worker.hpp"

#include <algorithm>

#include "base/stopwatch.hpp"
#include "render/job/adaptive.hpp"
#include "render/job/pass_grid.hpp"
#include "render/sampling/pixel_groups.hpp"

namespace balcony::render {

namespace {

// The part of a tile whose rays are traced so that the results in the window are the same as in the
// whole picture. Rays are traced in pairs of packets, and if two triangles are equally near, the
// other rays of a pair may determine which one is found; groups of pixels share paths.
Region traced_part(const Region& tile, const Region& window) {
    constexpr std::size_t step = PixelGroups::block_side;
    static_assert(step % (2 * embree::Packet::side) == 0 && tile_width % step == 0 &&
                  tile_height % step == 0);
    const auto part = [](std::size_t begin, std::size_t side, std::size_t from, std::size_t to) {
        const std::size_t first = from > begin ? (from - begin) / step * step : 0;
        const std::size_t last =
            to < begin + side ? std::min((to - begin + step - 1) / step * step, side) : side;
        return std::pair(begin + first, last - first);
    };
    const auto [x, width] = part(tile.x, tile.width, window.x, window.x + window.width);
    const auto [y, height] = part(tile.y, tile.height, window.y, window.y + window.height);
    return {x, y, width, height};
}

}  // namespace

void WorkCounts::add(const WorkCounts& other) {
    layers.resize(std::max(layers.size(), other.layers.size()));
    for (std::size_t i = 0; i < other.layers.size(); ++i) {
        layers[i].add(other.layers[i]);
    }
    invalid_pixels += other.invalid_pixels;
    repaired += other.repaired;
    motion.unknown += other.motion.unknown;
    motion.ambiguous += other.motion.ambiguous;
    camera_seconds += other.camera_seconds;
    seconds += other.seconds;
}

TileWorker::TileWorker(const JobParts& parts, const PictureInputs& inputs, Film& film)
    : settings_(&parts.settings),
      motion_(parts.motion.get()),
      film_(&film),
      filter_(find_pixel_filter(parts.settings.sampling.filter)),
      compositor_(parts.picture, PictureRays(parts.picture, parts.traced.interval, inputs),
                  TileTracer(parts.traced, parts.settings, *parts.integrator, parts.levels)) {}

bool TileWorker::render(std::size_t tile) {
    const Stopwatch watch;
    const Pass& pass = this->pass(film_->first_pass + film_->passes[tile]);
    const Region region = traced_part(film_->tile(tile), film_->window);
    const bool adaptive = !film_->pixel_passes.empty();
    if (adaptive && !find_active(*film_, tile, region, settings_->sampling, active_)) {
        seconds_ += watch.seconds();
        return false;
    }
    const Compositor::Wanted wanted{.data = pass.number == 0 && film_->layers.has_value(),
                                    .display = !film_->display.empty(),
                                    .mirrored = !film_->mirrored.empty(),
                                    .contributions = film_->means.any()};
    const TilePoints points{
        region, pass.number, pass.numbers,
        pass_grid(region, pass.offset, film_->width, film_->height,
                  settings_->shutter.moment(settings_->time, pass_moment(pass.number))),
        adaptive ? &active_ : nullptr};
    TileImage& image = compositor_.sample(points, film_->window, wanted);
    if (adaptive) {
        image.active = active_;
    }
    if (wanted.data && motion_ != nullptr) {
        motion_->find(region, film_->window, image.data, motion_counts_);
    }
    add_pass(*film_, tile, image);
    seconds_ += watch.seconds();
    return true;
}

const TileWorker::Pass& TileWorker::pass(std::size_t number) {
    if (!pass_ || pass_->number != number) {
        pass_ = Pass{number, pass_offset(*filter_, number),
                     PassNumbers(number, settings_->sampling.seed)};
    }
    return *pass_;
}

WorkCounts TileWorker::counts() const {
    return {compositor_.ray_counts(), compositor_.invalid_pixels(), compositor_.repaired(),
            motion_counts_,           compositor_.camera_seconds(), seconds_};
}

}  // namespace balcony::render
