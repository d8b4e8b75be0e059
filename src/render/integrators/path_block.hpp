// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A block of paths where their rays end. The random numbers of all its paths are computed together,
// and so is what their surfaces reflect.

#include <array>
#include <cstddef>
#include <optional>

#include "render/integrators/path_batch.hpp"
#include "render/sampling/sample_block.hpp"
#include "render/tracing/bsdf_block.hpp"

namespace balcony::render {

/// A path has a lane of the block.
class PathBlock {
public:
    static constexpr std::size_t size = lane_count;
    static_assert(size == SampleBlock::size && size == BsdfBlock::size);

    /// Draws the numbers of some paths of the batch, and finds the surfaces that they meet.
    void begin(PathBatch& paths, std::size_t first, std::size_t count, const SceneTracer& tracer);

    [[nodiscard]] Path& path(std::size_t lane) { return *paths_[lane]; }
    [[nodiscard]] SampleReader& numbers(std::size_t lane) { return *readers_[lane]; }
    /// Where the ray hits something.
    [[nodiscard]] const Interaction& at(std::size_t lane) const { return *interactions_[lane]; }

    /// Of the paths whose light is scattered.
    [[nodiscard]] BsdfBlock& bsdfs() { return bsdfs_; }
    /// Where it is.
    [[nodiscard]] LitPoint& point(std::size_t lane) { return points_[lane]; }

private:
    SampleBlock samples_;
    BsdfBlock bsdfs_;
    std::array<Path*, size> paths_{};
    std::array<std::optional<SampleReader>, size> readers_;
    std::array<std::optional<Interaction>, size> interactions_;
    std::array<LitPoint, size> points_;
};

}  // namespace balcony::render
