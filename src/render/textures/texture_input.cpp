// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include <OpenImageIO/imageio.h>

#include "render/textures/texture_cache.hpp"

namespace balcony::render {

namespace {

// Returns the rows of an image on request, and releases it after the last: the memory of
// a decoder is needed only while the image is read from top to bottom.
class TextureInput final : public OIIO::ImageInput {
public:
    const char* format_name() const override { return "balcony texture"; }

    bool open(const std::string& name, OIIO::ImageSpec& spec) override {
        return open(name, spec, OIIO::ImageSpec());
    }

    bool open(const std::string&, OIIO::ImageSpec& spec, const OIIO::ImageSpec& config) override {
        const OIIO::ParamValue* attribute =
            config.find_attribute("balcony:source", OIIO::TypeDesc::PTR);
        if (attribute == nullptr) {
            errorfmt("no source");
            return false;
        }
        source_ = static_cast<const TextureSource*>(*static_cast<void* const*>(attribute->data()));
        if (!open_source()) {
            return false;
        }
        m_spec =
            OIIO::ImageSpec(static_cast<int>(image_->width()), static_cast<int>(image_->height()),
                            static_cast<int>(std::tuple_size_v<HalfTexel>), OIIO::TypeDesc::HALF);
        spec = m_spec;
        return true;
    }

    bool close() override {
        image_.reset();
        return true;
    }

    bool read_native_scanline(int subimage, int miplevel, int y, int z, void* data) override {
        return read_native_scanlines(subimage, miplevel, y, y + 1, z, data);
    }

    bool read_native_scanlines(int subimage, int miplevel, int begin, int end, int,
                               void* data) override {
        end = std::min(end, m_spec.height);
        if (subimage != 0 || miplevel != 0 || begin >= end || (!image_ && !open_source())) {
            return false;
        }
        const std::span texels(static_cast<HalfTexel*>(data),
                               static_cast<std::size_t>(end - begin) * image_->width());
        if (const auto failure = image_->read_rows(static_cast<std::size_t>(begin),
                                                   static_cast<std::size_t>(end), texels)) {
            return failed(*failure);
        }
        source_->repaired = source_->repaired || image_->has_repaired();
        if (end == m_spec.height) {
            image_.reset();
        }
        return true;
    }

private:
    bool open_source() {
        Result<TextureReader> opened = TextureReader::open(*source_->texture, source_->encoding);
        if (!opened) {
            return failed(opened.diagnostics.front());
        }
        image_ = std::move(opened.value);
        return true;
    }

    bool failed(const Diagnostic& reason) {
        if (!source_->failure) {
            source_->failure = reason;
        }
        errorfmt("{}", reason.message);
        return false;
    }

    const TextureSource* source_ = nullptr;
    std::optional<TextureReader> image_;  // Only while its rows are read.
};

}  // namespace

OIIO::ImageInput* make_texture_input() { return new TextureInput; }

}  // namespace balcony::render
