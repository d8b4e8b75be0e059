// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The textures of a scene within a memory limit. Those that fit are decoded once and held as a
// whole; the others go through a cache.

#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <vector>

#include <Imath/ImathColor.h>

#include "balcony/base.hpp"
#include "balcony/scene.hpp"
#include "render/textures/held_texture.hpp"
#include "render/textures/texture_cache.hpp"
#include "render/textures/texture_footprint.hpp"

namespace balcony::render {

/// Look-ups may come from any number of threads.
class TextureLibrary {
public:
    /// Per-thread data for look-ups.
    using ThreadCache = TextureCache::PerThread;

    /// Opens the textures of the scene's materials. One that cannot be opened is a warning.
    /// `memory` is the limit for all texels, in bytes. If all textures fit, they are held as a
    /// whole; otherwise, the smaller ones are, in three quarters of the memory, and the rest is for
    /// the cache.
    TextureLibrary(const scene::Scene& scene, std::size_t memory, Diagnostics& warnings);
    TextureLibrary(const TextureLibrary&) = delete;
    TextureLibrary& operator=(const TextureLibrary&) = delete;

    /// Decodes the textures that fit, on all threads of the machine. Otherwise, the first look-up
    /// decodes a texture.
    void read_all() const;

    [[nodiscard]] ThreadCache thread_cache() const {
        return cache_ ? cache_->per_thread() : nullptr;
    }

    /// The mean over the footprint: red, green, blue, alpha. White where there is no texture, it
    /// cannot be read, or the point is out of range; without a filter if the footprint is out of
    /// range.
    [[nodiscard]] Imath::Color4f look_up(scene::TextureIndex texture, TextureEncoding encoding,
                                         const TextureFootprint& footprint,
                                         ThreadCache cache) const;

    /// Warnings about textures that were read since: each is returned once.
    [[nodiscard]] Diagnostics warnings() const;

    /// The memory that the textures held as a whole take once they are decoded, in bytes.
    [[nodiscard]] std::size_t held_bytes() const { return held_bytes_; }

private:
    struct Entry {
        std::unique_ptr<const HeldTexture> held;
        std::unique_ptr<const TextureCache::Entry> cached;
        mutable std::atomic<bool> reported = false;
    };

    std::unique_ptr<TextureCache> cache_;  // Null if all textures fit.
    // Two entries per texture, one for each encoding; both pointers are null if it is not used or
    // cannot be opened.
    std::vector<std::array<Entry, 2>> entries_;
    std::size_t held_bytes_ = 0;
};

}  // namespace balcony::render
