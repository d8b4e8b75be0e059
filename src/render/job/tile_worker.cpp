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

// The marks of a part of a region, where the part's points are active, or all if no flags are
// given.
Mask within(const Region& part, const Region& region, const Mask& marked, const Mask& active) {
    Mask found(part.size(), 0);
    for_each_pixel(part, [&](std::size_t i, std::size_t x, std::size_t y) {
        const bool marks = marked[(y - region.y) * region.width + x - region.x] != 0;
        found[i] = marks && (active.empty() || active[i] != 0) ? 1 : 0;
    });
    return found;
}

// The least part of a region that has all blocks of pixels that share paths with a marked one;
// without pixels if none is marked.
Region blocks_of(const Region& region, const Mask& marked) {
    constexpr std::size_t step = PixelGroups::block_side;
    std::size_t left = region.x + region.width;
    std::size_t top = region.y + region.height;
    std::size_t right = 0;
    std::size_t bottom = 0;
    for_each_pixel(region, [&](std::size_t i, std::size_t x, std::size_t y) {
        if (marked[i] != 0) {
            left = std::min(left, x / step * step);
            top = std::min(top, y / step * step);
            right = std::max(right, x / step * step + step);
            bottom = std::max(bottom, y / step * step + step);
        }
    });
    return right == 0 ? Region{}
                      : Region{left, top, right - left, bottom - top}.intersection(region);
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

TileWorker::TileWorker(const JobParts& parts, const PictureInputs& inputs,
                       Supersampling& supersampling, Film& film)
    : settings_(&parts.settings),
      motion_(parts.motion.get()),
      film_(&film),
      filter_(find_pixel_filter(parts.settings.sampling.filter)),
      supersampling_(&supersampling),
      rays_(parts.picture, parts.shown, parts.traced.interval, inputs),
      compositor_(parts.picture,
                  PictureRays(parts.picture, parts.shown, parts.traced.interval, inputs),
                  TileTracer(parts.traced, parts.settings, *parts.integrator, parts.levels)) {}

bool TileWorker::render(std::size_t tile) {
    const Stopwatch watch;
    const std::size_t number = film_->first_pass + film_->passes[tile];
    const Region whole = film_->tile(tile);
    const Region region = traced_part(whole, film_->window);
    const bool adaptive = !film_->pixel_passes.empty();
    if (!adaptive) {
        active_.assign(region.size(), 1);
    } else if (!find_active(*film_, tile, region, settings_->sampling, active_)) {
        seconds_ += watch.seconds();
        return false;
    }
    const std::shared_ptr<const Mask> marked = supersampling_->of(whole, rays_);
    TileImage& image = marked
                           ? sample_more(region, number, within(region, whole, *marked, active_))
                           : sample(region, number, adaptive ? &active_ : nullptr, film_->window);
    if (adaptive) {
        image.active = active_;
    }
    if (!image.data.empty() && motion_ != nullptr) {
        motion_->find(region, film_->window, image.data, motion_counts_);
    }
    add_pass(*film_, tile, image);
    seconds_ += watch.seconds();
    return true;
}

TileImage& TileWorker::sample(const Region& region, std::size_t number, const Mask* active,
                              const Region& counted) {
    const Pass& pass = this->pass(number);
    const Compositor::Wanted wanted{.data = number == 0 && film_->layers.has_value(),
                                    .display = !film_->display.empty(),
                                    .mirrored = !film_->mirrored.empty(),
                                    .contributions = film_->means.any()};
    return compositor_.sample(
        {region, number, pass.numbers,
         pass_grid(region, pass.offset, film_->width, film_->height,
                   settings_->shutter.moment(settings_->time, pass_moment(number))),
         active},
        counted, wanted);
}

TileImage& TileWorker::sample_more(const Region& region, std::size_t number, const Mask& marked) {
    const Region part = blocks_of(region, marked);
    if (part.size() == 0) {
        return sample(region, number, &active_, film_->window);
    }
    Mask others = active_;
    for (std::size_t i = 0; i < others.size(); ++i) {
        others[i] = others[i] != 0 && marked[i] == 0 ? 1 : 0;
    }
    mixed_ = std::move(sample(region, number, &others, film_->window));
    const Mask in_part = within(part, region, marked, {});
    std::array<TileImage, samples_of_pass> samples;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        samples[i] = std::move(sample(part, samples_of_pass * number + i, &in_part,
                                      i == 0 ? film_->window : Region{}));
    }
    set_means(mixed_, marked, samples);
    return mixed_;
}

const TileWorker::Pass& TileWorker::pass(std::size_t number) {
    std::optional<Pass>& kept = passes_[number % passes_.size()];
    if (!kept || kept->number != number) {
        kept = Pass{number, pass_offset(*filter_, number),
                    PassNumbers(number, settings_->sampling.seed)};
    }
    return *kept;
}

WorkCounts TileWorker::counts() const {
    return {compositor_.ray_counts(), compositor_.invalid_pixels(), compositor_.repaired(),
            motion_counts_,           compositor_.camera_seconds(), seconds_};
}

}  // namespace balcony::render
