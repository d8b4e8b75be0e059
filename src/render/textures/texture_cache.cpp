// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/textures/texture_cache.hpp"

#include <tuple>

#include <OpenImageIO/imagecache.h>

#include "render/textures/mip_pyramid.hpp"

namespace balcony::render {

namespace {

constexpr int tile_side = 64;
constexpr int max_open_images = 8;

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

}  // namespace

TextureCache::TextureCache(std::size_t bytes) : system_(OIIO::TextureSystem::create(false)) {
    system_->attribute("max_memory_MB", static_cast<float>(bytes) / 0x1p20F);
    system_->attribute("max_open_files", max_open_images);
    system_->attribute("autotile", tile_side);
    system_->attribute("automip", 1);
    system_->attribute("accept_untiled", 1);
    system_->attribute("accept_unmipped", 1);
}

std::unique_ptr<const TextureCache::Entry> TextureCache::add(const scene::Texture& texture,
                                                             TextureEncoding encoding,
                                                             const std::string& name) {
    auto entry = std::make_unique<Entry>();
    entry->source_.texture = &texture;
    entry->source_.encoding = encoding;
    entry->name_ = OIIO::ustring(name);
    OIIO::ImageSpec config;
    void* const source = &entry->source_;
    config.attribute("balcony:source", OIIO::TypeDesc::PTR, &source);
    system_->imagecache()->add_file(entry->name_, make_texture_input, &config);
    entry->handle_ = system_->get_texture_handle(entry->name_);
    return entry;
}

std::optional<Imath::Color4f> TextureCache::mean(const Entry& entry,
                                                 const TextureFootprint& footprint,
                                                 PerThread thread) const {
    std::call_once(entry.read_, [&] {
        if (entry.handle_ == nullptr || !read_through(*system_->imagecache(), entry.name_)) {
            static_cast<void>(system_->imagecache()->geterror());
            entry.failed_.store(true, std::memory_order_release);
        }
    });
    if (entry.failed()) {
        return std::nullopt;
    }
    OIIO::TextureOpt options;
    options.swrap = to_wrap(entry.source_.texture->wrap_u);
    options.twrap = to_wrap(entry.source_.texture->wrap_v);
    options.mipmode = OIIO::TextureOpt::MipModeAniso;
    options.interpmode = OIIO::TextureOpt::InterpBilinear;
    options.anisotropic = MipPyramid::max_probes;
    Imath::Color4f color;
    if (!system_->texture(entry.handle_, thread, options, footprint.at.x, footprint.at.y,
                          footprint.along_x.x, footprint.along_x.y, footprint.along_y.x,
                          footprint.along_y.y, static_cast<int>(std::tuple_size_v<HalfTexel>),
                          &color.r)) {
        static_cast<void>(system_->geterror());
        entry.failed_.store(true, std::memory_order_release);
        return std::nullopt;
    }
    return color;
}

}  // namespace balcony::render
