// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Textures through a cache of bounded size, decoded to linear half floats before any filtering.

#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include <Imath/ImathColor.h>
#include <Imath/ImathVec.h>
#include <OpenImageIO/texture.h>

#include "balcony/base.hpp"
#include "balcony/scene.hpp"

namespace balcony::render {

/// The memory limit for the pixels of all textures; evicted pixels are read again when needed.
/// A decoder adds a row of tiles for each image that is being read, or the whole of an image whose
/// format is not decoded row by row (WebP, TGA, interlaced PNG, progressive JPEG).
inline constexpr float texture_cache_megabytes = 1024.0F;
inline constexpr int max_open_images = 8;

using scene::TextureEncoding;

/// The source of a texture's pixels for the cache's reader, and the reader's error.
struct TextureSource {
    const scene::Texture* texture = nullptr;
    TextureEncoding encoding = TextureEncoding::linear;
    mutable std::optional<Diagnostic>
        failure;  ///< The first error; set by the reader, one at a time.
};

/// Reads a TextureSource as four linear channels (grey is spread, missing alpha is 1). Its open()
/// takes the source's address from the attribute "balcony:source" of its configuration.
OIIO::ImageInput* make_texture_input();

/// The position of a texture look-up, and its change from one pixel to the next.
struct TextureFootprint {
    Imath::V2f at;
    Imath::V2f along_x;
    Imath::V2f along_y;
};

/// The textures of a scene. Look-ups may come from any number of threads.
class TextureLibrary {
public:
    /// Per-thread data for look-ups.
    using ThreadCache = OIIO::TextureSystem::Perthread*;

    TextureLibrary(const scene::Scene& scene, Diagnostics& warnings);
    TextureLibrary(const TextureLibrary&) = delete;
    TextureLibrary& operator=(const TextureLibrary&) = delete;

    [[nodiscard]] ThreadCache thread_cache() const { return system_->get_perthread_info(); }

    /// The mean over the footprint: red, green, blue, alpha. White where there is no texture, it
    /// cannot be read, or the point is out of range.
    [[nodiscard]] Imath::Color4f look_up(scene::TextureIndex texture, TextureEncoding encoding,
                                         const TextureFootprint& footprint,
                                         ThreadCache cache) const;

    /// One warning for each texture that failed since it was opened.
    [[nodiscard]] Diagnostics failures() const;

private:
    struct Entry {
        TextureSource source;
        OIIO::TextureSystem::TextureHandle* handle = nullptr;  // Null if not used or unreadable.
        OIIO::ustring name;                                    // The name in the cache.
        OIIO::TextureOpt::Wrap wrap_u = OIIO::TextureOpt::WrapPeriodic;
        OIIO::TextureOpt::Wrap wrap_v = OIIO::TextureOpt::WrapPeriodic;
        mutable std::once_flag read;  // Set once the whole image was requested.
        mutable std::atomic<bool> failed = false;
        mutable std::atomic<bool> reported = false;
    };
    struct DestroySystem {
        void operator()(OIIO::TextureSystem* system) const { OIIO::TextureSystem::destroy(system); }
    };

    void open(const scene::Texture& texture, TextureEncoding encoding, std::size_t index,
              Diagnostics& warnings);

    // Two entries per texture, one for each encoding.
    std::vector<std::array<Entry, 2>> entries_;
    std::unique_ptr<OIIO::TextureSystem, DestroySystem> system_;
};

}  // namespace balcony::render
