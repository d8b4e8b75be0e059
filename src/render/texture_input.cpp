// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <memory>
#include <string_view>
#include <vector>

#include <Imath/half.h>
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "render/texture_library.hpp"

namespace balcony::render {

namespace {

constexpr int channels = 4;

// IEC 61966-2-1.
float linear_from_srgb(float value) {
    return value <= 0.04045F ? value / 12.92F : std::pow((value + 0.055F) / 1.055F, 2.4F);
}

// Embedded images have no file name to tell their format by; glTF allows these two.
const char* format_by_content(const std::vector<std::uint8_t>& bytes) {
    constexpr std::array<std::uint8_t, 4> png = {0x89, 'P', 'N', 'G'};
    return bytes.size() >= png.size() && std::equal(png.begin(), png.end(), bytes.begin())
               ? "png"
               : "jpeg";
}

class TextureInput final : public OIIO::ImageInput {
public:
    const char* format_name() const override { return "balcony texture"; }

    bool open(const std::string& name, OIIO::ImageSpec& spec) override {
        return open(name, spec, OIIO::ImageSpec());
    }

    bool open(const std::string&, OIIO::ImageSpec& spec, const OIIO::ImageSpec& config) override {
        const OIIO::ParamValue* attribute = config.find_attribute("balcony:source", OIIO::TypeDesc::PTR);
        if (attribute == nullptr) {
            errorfmt("no source");
            return false;
        }
        source_ = static_cast<const TextureSource*>(*static_cast<void* const*>(attribute->data()));
        if (!open_encoded()) {
            return false;
        }
        const OIIO::ImageSpec& encoded = encoded_->spec();
        m_spec = OIIO::ImageSpec(encoded.width, encoded.height, channels, OIIO::TypeDesc::HALF);
        m_spec.tile_width = encoded.tile_width;
        m_spec.tile_height = encoded.tile_height;
        m_spec.tile_depth = encoded.tile_depth;
        spec = m_spec;
        return true;
    }

    bool close() override {
        encoded_.reset();
        return true;
    }

    bool read_native_scanline(int subimage, int miplevel, int y, int z, void* data) override {
        const OIIO::ImageSpec& encoded = encoded_->spec();
        buffer_.resize(static_cast<std::size_t>(encoded.width) *
                       static_cast<std::size_t>(encoded.nchannels));
        if (subimage != 0 || miplevel != 0 ||
            !encoded_->read_scanline(y + encoded.y, z, OIIO::TypeDesc::FLOAT, buffer_.data())) {
            return fail();
        }
        return decode(data);
    }

    bool read_native_tile(int subimage, int miplevel, int x, int y, int z, void* data) override {
        const OIIO::ImageSpec& encoded = encoded_->spec();
        buffer_.resize(static_cast<std::size_t>(encoded.tile_pixels()) *
                       static_cast<std::size_t>(encoded.nchannels));
        if (subimage != 0 || miplevel != 0 ||
            !encoded_->read_tile(x + encoded.x, y + encoded.y, z, OIIO::TypeDesc::FLOAT,
                                 buffer_.data())) {
            return fail();
        }
        return decode(data);
    }

private:
    bool open_encoded() {
        OIIO::ImageSpec config;
        config.attribute("oiio:UnassociatedAlpha", 1);
        const scene::Texture& texture = *source_->texture;
        const bool embedded = texture.file.empty();
        const std::string name = embedded ? "embedded image" : texture.file.string();
        encoded_ = OIIO::ImageInput::create(embedded ? format_by_content(texture.bytes) : name);
        if (!encoded_) {
            errorfmt("{}", OIIO::geterror());
            return false;
        }
        if (embedded) {
            memory_ = std::make_unique<OIIO::Filesystem::IOMemReader>(texture.bytes.data(),
                                                                      texture.bytes.size());
            encoded_->set_ioproxy(memory_.get());
        }
        OIIO::ImageSpec encoded;
        if (!encoded_->open(name, encoded, config)) {
            return fail();
        }
        if (encoded_->spec().depth != 1) {
            errorfmt("a volume is no texture");
            return false;
        }
        return true;
    }

    bool fail() {
        errorfmt("{}", encoded_->geterror());
        return false;
    }

    // What was read into the buffer, as four linear channels.
    bool decode(void* data) {
        const auto count = static_cast<std::size_t>(encoded_->spec().nchannels);
        const bool grey = count < 3;
        auto* out = static_cast<Imath::half*>(data);
        for (std::size_t i = 0; i < buffer_.size(); i += count) {
            for (std::size_t c = 0; c < 3; ++c) {
                const float value = buffer_[i + (grey ? 0 : c)];
                *out++ = Imath::half(source_->encoding == TextureEncoding::srgb
                                         ? linear_from_srgb(value)
                                         : value);
            }
            *out++ = Imath::half(count == 2 || count >= 4 ? buffer_[i + count - 1] : 1.0F);
        }
        return true;
    }

    const TextureSource* source_ = nullptr;
    std::unique_ptr<OIIO::Filesystem::IOProxy> memory_;
    std::unique_ptr<OIIO::ImageInput> encoded_;
    std::vector<float> buffer_;
};

}  // namespace

OIIO::ImageInput* make_texture_input() { return new TextureInput; }

}  // namespace balcony::render
