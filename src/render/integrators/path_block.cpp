// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/integrators/path_block.hpp"

#include <span>

namespace balcony::render {

// Memory is requested so many paths early that it has usually arrived.
void PathBlock::begin(PathBatch& paths, std::size_t first, std::size_t count,
                      const SceneTracer& tracer) {
    constexpr std::size_t steps_to_corners = 4;
    constexpr std::size_t steps_to_triangle = 8;
    constexpr std::size_t steps_to_path = 12;
    std::array<const Sampler*, size> samplers{};
    for (std::size_t lane = 0; lane < count; ++lane) {
        paths_[lane] = &paths[first + lane];
        samplers[lane] = &paths_[lane]->sampler;
    }
    samples_.fill(std::span(samplers).first(count));
    for (std::size_t lane = 0; lane < count; ++lane) {
        readers_[lane].emplace(samples_, lane, paths_[lane]->sampler);
    }
    for (std::size_t lane = 0; lane < count; ++lane) {
        prefetch(paths.ahead(first + lane, steps_to_path));
        tracer.request_triangle(paths.ahead(first + lane, steps_to_triangle).hit);
        tracer.request_corners(paths.ahead(first + lane, steps_to_corners).hit);
        const Path& path = *paths_[lane];
        if (path.hit.any()) {
            interactions_[lane].emplace(tracer.scene(), path.ray, path.hit);
        }
    }
    bsdfs_.clear();
}

}  // namespace balcony::render
