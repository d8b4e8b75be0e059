// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/integrators/path_batch.hpp"

namespace balcony::render {

void PathBatch::generate(std::span<const CameraRay> rays, Part part) {
    paths_.clear();
    active_.clear();
    for (const CameraRay& one : rays) {
        const auto index = static_cast<std::uint32_t>(paths_.size());
        active_.push_back(index);
        paths_.push_back({.ray = one.ray,
                          .hit = one.first,
                          .eye = one.ray.origin,
                          .sampler = one.sampler,
                          .index = index,
                          .packet = one.packet,
                          .part = part});
    }
}

// Each ray by itself: packets gain nothing for rays that were scattered, and the result of a ray
// then does not depend on the others.
void PathBatch::intersect(const SceneTracer& tracer, const ShownObjects& shown) {
    constexpr std::uint32_t bucket_count = 256;
    constexpr std::size_t steps_to_path = 3;  // Tracing takes longer than shading.
    keys_.clear();
    for (const std::uint32_t i : active_) {
        keys_.push_back({paths_[i].ray.origin, paths_[i].ray.direction});
    }
    unordered_.swap(active_);
    active_.clear();
    const std::span<const std::uint32_t> order = order_.sort(keys_);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::uint32_t k = order[i];
        prefetch(paths_[unordered_[order[std::min(i + steps_to_path, order.size() - 1)]]]);
        Path& path = paths_[unordered_[k]];
        path.hit = tracer.nearest(path.ray, path.bounces.all == 0 ? shown.only() : nullptr);
        active_.push_back(unordered_[k]);
    }
    // Neighbours then have the same material and need the same memory.
    counting_sort<bucket_count>(active_, unordered_, [&](std::uint32_t i) {
        return paths_[i].hit.instance % bucket_count;
    });
}

}  // namespace balcony::render
