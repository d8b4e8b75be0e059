// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/textures/texture_library.hpp"

#include <cmath>

#include <OpenImageIO/imagecache.h>
#include <fmt/format.h>

namespace balcony::render {

namespace {

constexpr int texture_channels = 4;
constexpr int tile_side = 64;

OIIO::TextureOpt::Wrap to_wrap(scene::Wrap wrap) {
    switch (wrap) {
        case scene::Wrap::repeat: return OIIO::TextureOpt::WrapPeriodic;
        case scene::Wrap::clamp: return OIIO::TextureOpt::WrapClamp;
        case scene::Wrap::mirror: return OIIO::TextureOpt::WrapMirror;
    }
    return OIIO::TextureOpt::WrapPeriodic;
}

// Reads an image into the cache once, from top to bottom, before tiles are requested in any
// order: most formats can only be decoded from the top. False if a part cannot be read.
bool read_through(OIIO::ImageCache& cache, OIIO::ustring name) {
    OIIO::ImageCache::ImageHandle* const image = cache.get_image_handle(name);
    OIIO::ImageSpec spec;
    if (!cache.get_imagespec(image, nullptr, spec)) {
        return false;
    }
    // One tile loads its whole row of tiles.
    for (int y = 0; y < spec.height; y += tile_side) {
        OIIO::ImageCache::Tile* const tile = cache.get_tile(image, nullptr, 0, 0, 0, y, 0);
        if (tile == nullptr) {
            return false;
        }
        cache.release_tile(tile);
    }
    return true;
}

Diagnostic unreadable(const TextureSource& source) {
    const Diagnostic reason = source.failure.value_or(Diagnostic{});
    return warning(fmt::format("texture '{}' cannot be read{}{}", source.texture->name,
                               reason.message.empty() ? "" : ": ", reason.message),
                   {},
                   reason.remedy.empty() ? "its material is rendered with its constant factors"
                                         : reason.remedy);
}

}  // namespace

TextureLibrary::TextureLibrary(const scene::Scene& scene, Diagnostics& warnings)
    : entries_(scene.textures.size()), system_(OIIO::TextureSystem::create(false)) {
    system_->attribute("max_memory_MB", texture_cache_megabytes);
    system_->attribute("max_open_files", max_open_images);
    system_->attribute("autotile", tile_side);
    system_->attribute("automip", 1);
    system_->attribute("accept_untiled", 1);
    system_->attribute("accept_unmipped", 1);
    for (const scene::Material& material : scene.materials) {
        for (const auto texture : scene::texture_uses) {
            const scene::TextureUse& use = material.*texture;
            if (use.valid()) {
                open(scene.textures[use.index.value()], use.encoding, use.index.value(), warnings);
            }
        }
    }
}

void TextureLibrary::open(const scene::Texture& texture, TextureEncoding encoding,
                          std::size_t index, Diagnostics& warnings) {
    Entry& entry = entries_[index][static_cast<std::size_t>(encoding)];
    if (entry.source.texture != nullptr) {
        return;
    }
    entry.source.texture = &texture;
    entry.source.encoding = encoding;
    entry.wrap_u = to_wrap(texture.wrap_u);
    entry.wrap_v = to_wrap(texture.wrap_v);

    // The cache identifies images by name.
    const OIIO::ustring name(fmt::format("{}:{}", index, static_cast<int>(encoding)));
    OIIO::ImageSpec config;
    void* const source = &entry.source;
    config.attribute("balcony:source", OIIO::TypeDesc::PTR, &source);
    system_->imagecache()->add_file(name, make_texture_input, &config);
    OIIO::TextureSystem::TextureHandle* handle = system_->get_texture_handle(name);
    int found = 0;
    if (handle == nullptr ||
        !system_->get_texture_info(handle, nullptr, 0, OIIO::ustring("channels"),
                                   OIIO::TypeDesc::INT, &found)) {
        static_cast<void>(system_->geterror());
        warnings.push_back(unreadable(entry.source));
        return;
    }
    entry.handle = handle;
    entry.name = name;
}

Imath::Color4f TextureLibrary::look_up(scene::TextureIndex texture, TextureEncoding encoding,
                                       const TextureFootprint& footprint, ThreadCache cache) const {
    Imath::Color4f color(1.0F, 1.0F, 1.0F, 1.0F);
    if (!texture.valid()) {
        return color;
    }
    const Entry& entry = entries_[texture.value()][static_cast<std::size_t>(encoding)];
    if (entry.handle == nullptr) {
        return color;
    }
    std::call_once(entry.read, [&] {
        if (!read_through(*system_->imagecache(), entry.name)) {
            static_cast<void>(system_->imagecache()->geterror());
            entry.failed.store(true, std::memory_order_release);
        }
    });
    if (entry.failed.load(std::memory_order_relaxed)) {
        return color;
    }
    // Beyond this, a float cannot distinguish the texels of an image.
    constexpr float farthest = 1e6F;
    if (!(std::abs(footprint.at.x) < farthest && std::abs(footprint.at.y) < farthest)) {
        return color;
    }
    OIIO::TextureOpt options;
    options.swrap = entry.wrap_u;
    options.twrap = entry.wrap_v;
    options.mipmode = OIIO::TextureOpt::MipModeAniso;
    options.interpmode = OIIO::TextureOpt::InterpBilinear;
    options.anisotropic = 16;
    if (!system_->texture(entry.handle, cache, options, footprint.at.x, footprint.at.y,
                          footprint.along_x.x, footprint.along_x.y, footprint.along_y.x,
                          footprint.along_y.y, texture_channels, &color.r)) {
        static_cast<void>(system_->geterror());
        entry.failed.store(true, std::memory_order_release);
        return {1.0F, 1.0F, 1.0F, 1.0F};
    }
    return color;
}

Diagnostics TextureLibrary::failures() const {
    Diagnostics warnings;
    for (const std::array<Entry, 2>& pair : entries_) {
        for (const Entry& entry : pair) {
            if (entry.failed.load(std::memory_order_acquire) && !entry.reported.exchange(true)) {
                warnings.push_back(unreadable(entry.source));
            }
        }
    }
    return warnings;
}

}  // namespace balcony::render
