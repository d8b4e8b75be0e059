// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string_view>
#include <vector>

#include <Imath/half.h>
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "render/textures/texture_library.hpp"

namespace balcony::render {

namespace {

constexpr std::size_t channels = 4;

// IEC 61966-2-1.
float linear_from_srgb(float value) {
    return value <= 0.04045F ? value / 12.92F : std::pow((value + 0.055F) / 1.055F, 2.4F);
}

// Embedded images have no file name to tell their format by; glTF allows these two.
const char* format_by_content(const std::vector<std::uint8_t>& bytes) {
    constexpr std::array<std::uint8_t, 4> png = {0x89, 'P', 'N', 'G'};
    return bytes.size() >= png.size() && std::equal(png.begin(), png.end(), bytes.begin()) ? "png"
                                                                                           : "jpeg";
}

// Decodes the whole image when its first row is asked for and lets go of it when each row has been
// given: the formats in use can only be read from top to bottom, the cache reads in any order.
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
        const Encoded encoded = open_encoded();
        if (!encoded.input) {
            return false;
        }
        const OIIO::ImageSpec& found = encoded.input->spec();
        m_spec = OIIO::ImageSpec(found.width, found.height, static_cast<int>(channels),
                                 OIIO::TypeDesc::HALF);
        spec = m_spec;
        return true;
    }

    bool close() override {
        texels_.clear();
        return true;
    }

    bool read_native_scanline(int subimage, int miplevel, int y, int, void* data) override {
        if (subimage != 0 || miplevel != 0 || (texels_.empty() && !decode())) {
            return false;
        }
        const std::size_t row = row_size();
        std::copy_n(texels_.begin() + static_cast<std::ptrdiff_t>(row) * y, row,
                    static_cast<Imath::half*>(data));
        if (--rows_to_give_ == 0) {
            texels_ = {};
        }
        return true;
    }

private:
    struct Encoded {
        std::unique_ptr<OIIO::Filesystem::IOProxy> memory;  // Outlives the input that reads it.
        std::unique_ptr<OIIO::ImageInput> input;            // Null if it cannot be read.
    };

    Encoded open_encoded() {
        Encoded encoded;
        const scene::Texture& texture = *source_->texture;
        const bool embedded = texture.file.empty();
        const std::string name = embedded ? "embedded image" : texture.file.string();
        encoded.input =
            OIIO::ImageInput::create(embedded ? format_by_content(texture.bytes) : name);
        if (!encoded.input) {
            errorfmt("{}", OIIO::geterror());
            return {};
        }
        if (embedded) {
            encoded.memory = std::make_unique<OIIO::Filesystem::IOMemReader>(texture.bytes.data(),
                                                                             texture.bytes.size());
            encoded.input->set_ioproxy(encoded.memory.get());
        }
        OIIO::ImageSpec config;
        config.attribute("oiio:UnassociatedAlpha", 1);
        OIIO::ImageSpec found;
        if (!encoded.input->open(name, found, config) || found.depth != 1) {
            errorfmt("{}", found.depth != 1 ? "it is a volume" : encoded.input->geterror());
            return {};
        }
        return encoded;
    }

    [[nodiscard]] std::size_t row_size() const {
        return static_cast<std::size_t>(m_spec.width) * channels;
    }

    // Reads the image as four linear channels.
    bool decode() {
        const Encoded encoded = open_encoded();
        if (!encoded.input) {
            return false;
        }
        const auto count = static_cast<std::size_t>(encoded.input->spec().nchannels);
        const std::size_t rows = static_cast<std::size_t>(m_spec.height);
        std::vector<float> values(static_cast<std::size_t>(m_spec.width) * rows * count);
        if (!encoded.input->read_image(0, 0, 0, static_cast<int>(count), OIIO::TypeDesc::FLOAT,
                                       values.data())) {
            errorfmt("{}", encoded.input->geterror());
            return false;
        }
        texels_.reserve(row_size() * rows);
        for (std::size_t i = 0; i < values.size(); i += count) {
            for (std::size_t c = 0; c < 3; ++c) {
                const float value = values[i + (count < 3 ? 0 : c)];
                texels_.emplace_back(
                    source_->encoding == TextureEncoding::srgb ? linear_from_srgb(value) : value);
            }
            texels_.emplace_back(count == 2 || count >= 4 ? values[i + (count == 2 ? 1 : 3)]
                                                          : 1.0F);
        }
        rows_to_give_ = rows;
        return true;
    }

    const TextureSource* source_ = nullptr;
    std::vector<Imath::half> texels_;  // Empty unless rows of it have yet to be given.
    std::size_t rows_to_give_ = 0;
};

}  // namespace

OIIO::ImageInput* make_texture_input() { return new TextureInput; }

}  // namespace balcony::render
