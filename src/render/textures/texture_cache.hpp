// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Textures through OpenImageIO's cache of tiles, decoded to linear half floats before any
// filtering. Evicted tiles are read again when needed.

#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include <Imath/ImathColor.h>
#include <OpenImageIO/texture.h>

#include "balcony/base.hpp"
#include "balcony/scene.hpp"
#include "render/textures/texture_footprint.hpp"
#include "render/textures/texture_reader.hpp"

namespace balcony::render {

/// The source of a texture's texels for the cache's reader, and the reader's results, which it
/// sets one at a time.
struct TextureSource {
    const scene::Texture* texture = nullptr;
    TextureEncoding encoding = TextureEncoding::linear;
    mutable std::optional<Diagnostic> failure;  ///< The first error.
    mutable bool repaired = false;              ///< Whether a value was not finite.
};

/// Reads a TextureSource. Its open() takes the source's address from the attribute
/// "balcony:source" of its configuration.
OIIO::ImageInput* make_texture_input();

/// Look-ups may come from any number of threads.
class TextureCache {
public:
    /// Per-thread data for look-ups.
    using PerThread = OIIO::TextureSystem::Perthread*;

    /// A texture of the cache.
    class Entry {
    public:
        [[nodiscard]] const TextureSource& source() const { return source_; }
        [[nodiscard]] bool failed() const { return failed_.load(std::memory_order_acquire); }

    private:
        friend class TextureCache;
        TextureSource source_;
        OIIO::ustring name_;
        OIIO::TextureSystem::TextureHandle* handle_ = nullptr;
        mutable std::once_flag read_;  // Set once the whole image was requested.
        mutable std::atomic<bool> failed_ = false;
    };

    /// With a limit for the texels, of at least 10 MiB. A decoder adds a row of tiles for each
    /// image that is being read, or the whole of an image whose format is not decoded row by row.
    explicit TextureCache(std::size_t bytes);

    /// Adds a texture, whose address must not change. `name` must be unique.
    [[nodiscard]] std::unique_ptr<const Entry> add(const scene::Texture& texture,
                                                   TextureEncoding encoding,
                                                   const std::string& name);

    [[nodiscard]] PerThread per_thread() const { return system_->get_perthread_info(); }

    /// The mean over a footprint: red, green, blue, alpha. Nothing if the texture cannot be read.
    [[nodiscard]] std::optional<Imath::Color4f> mean(const Entry& entry,
                                                     const TextureFootprint& footprint,
                                                     PerThread thread) const;

private:
    struct DestroySystem {
        void operator()(OIIO::TextureSystem* system) const { OIIO::TextureSystem::destroy(system); }
    };
    std::unique_ptr<OIIO::TextureSystem, DestroySystem> system_;
};

}  // namespace balcony::render
