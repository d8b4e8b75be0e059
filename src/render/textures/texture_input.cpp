// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <Imath/half.h>
#include <OpenImageIO/imageio.h>

#include "balcony/image_file.hpp"
#include "render/textures/texture_library.hpp"

namespace balcony::render {

namespace {

constexpr std::size_t texel_channels = 4;

// IEC 61966-2-1.
float linear_from_srgb(float value) {
    return value <= 0.04045F ? value / 12.92F : std::pow((value + 0.055F) / 1.055F, 2.4F);
}

// Most images have 8 bits per channel, so 256 values to decode.
class SrgbDecoder {
public:
    SrgbDecoder() {
        for (std::size_t i = 0; i < byte_values.size(); ++i) {
            byte_values[i] = linear_from_srgb(as_float(i));
        }
    }

    float operator()(float value) const {
        const float scaled = value * 255.0F + 0.5F;
        const auto nearest =
            scaled > 0.0F && scaled < 256.0F ? static_cast<std::size_t>(scaled) : 0;
        return as_float(nearest) == value ? byte_values[nearest] : linear_from_srgb(value);
    }

private:
    static float as_float(std::size_t byte) { return static_cast<float>(byte) * (1.0F / 255.0F); }

    std::array<float, 256> byte_values{};
};

Result<scene::ImageFile> open_image(const scene::Texture& texture) {
    return texture.file.empty() ? scene::ImageFile::open(texture.name, texture.bytes)
                                : scene::ImageFile::open(texture.file);
}

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
                            static_cast<int>(texel_channels), OIIO::TypeDesc::HALF);
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
        std::vector<float> values(static_cast<std::size_t>(end - begin) * image_->width() *
                                  image_->channels());
        if (const auto failure = image_->read_rows(static_cast<std::size_t>(begin),
                                                   static_cast<std::size_t>(end), values)) {
            return failed(*failure);
        }
        decode(values, image_->channels(), static_cast<Imath::half*>(data));
        if (end == m_spec.height) {
            image_.reset();
        }
        return true;
    }

private:
    bool open_source() {
        Result<scene::ImageFile> opened = open_image(*source_->texture);
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

    // Four linear channels of each pixel.
    void decode(const std::vector<float>& values, std::size_t count, Imath::half* texel) const {
        static const SrgbDecoder linear;
        const bool is_srgb = source_->encoding == TextureEncoding::srgb;
        for (std::size_t i = 0; i < values.size(); i += count) {
            for (std::size_t c = 0; c < 3; ++c) {
                const float value = values[i + (count < 3 ? 0 : c)];
                *texel++ = is_srgb ? linear(value) : value;
            }
            *texel++ = count == 2 || count == 4 ? values[i + count - 1] : 1.0F;
        }
    }

    const TextureSource* source_ = nullptr;
    std::optional<scene::ImageFile> image_;  // Only while its rows are read.
};

}  // namespace

OIIO::ImageInput* make_texture_input() { return new TextureInput; }

}  // namespace balcony::render
