// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/picture_rays.hpp"

#include "base/stopwatch.hpp"

namespace balcony::render {

Color4f TileCoverages::paint(std::size_t root, std::size_t i) const {
    const auto channel = [&](std::size_t c) { return static_cast<float>(values_[root + c][i]); };
    return {channel(0), channel(1), channel(2), 1.0F};
}

TileCoverages PictureRays::coverages(const rays::Tile& points) {
    TileCoverages made;
    if (picture_->coverage_count() == 0) {
        return made;
    }
    const Stopwatch watch;
    const std::size_t count = points.width * points.height;
    inputs_.set_middle(count);
    rays::Tile tile = points;
    tile.inputs = inputs_.of_layer(0);
    picture_->run_coverages(tile, scratch_,
                            made.values_.reserve(picture_->coverage_count(), count));
    seconds_ += watch.seconds();
    return made;
}

void PictureRays::find_rays(std::size_t layer, const rays::Tile& points, TileRays& rays) {
    const Stopwatch watch;
    inputs_.set_middle(points.width * points.height);
    rays.through_lens = false;
    run(layer, points, rays);
    seconds_ += watch.seconds();
}

void PictureRays::find_rays_of_pass(std::size_t layer, const rays::Tile& points,
                                    const Region& region, const PassNumbers& numbers,
                                    TileRays& rays) {
    const Stopwatch watch;
    rays.through_lens = has_lens(layer);
    if (rays.through_lens) {
        inputs_.set_samples(region, numbers);
    } else {
        inputs_.set_middle(points.width * points.height);
    }
    run(layer, points, rays);
    seconds_ += watch.seconds();
}

void PictureRays::run(std::size_t layer, rays::Tile points, TileRays& rays) {
    points.inputs = inputs_.of_layer(layer);
    rays.layer = layer;
    rays.shown = &(*shown_)[layer];
    picture_->layers()[layer].rays.run(points, scratch_, rays.all);
    rays.interval = interval_;
    rays.time = static_cast<float>(interval_.part_at(points.time));
}

}  // namespace balcony::render
