// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/textures/texture_reader.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace balcony::render {

namespace {

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

// Calls set(texel, red, green, blue, alpha) for each pixel.
template <class Texel, class Value, class Set>
void spread(const std::vector<Value>& values, std::size_t channels, Value opaque,
            std::span<Texel> texels, const Set& set) {
    const std::size_t green = channels < 3 ? 0 : 1;
    const std::size_t blue = channels < 3 ? 0 : 2;
    const bool has_alpha = channels == 2 || channels == 4;
    const Value* pixel = values.data();
    for (Texel& texel : texels) {
        set(texel, pixel[0], pixel[green], pixel[blue], has_alpha ? pixel[channels - 1] : opaque);
        pixel += channels;
    }
}

}  // namespace

float linear_from_srgb(float value) {
    return value <= 0.04045F ? value / 12.92F : std::pow((value + 0.055F) / 1.055F, 2.4F);
}

Result<TextureReader> TextureReader::open(const scene::Texture& texture, TextureEncoding encoding) {
    auto image = texture.file.empty() ? images::ImageFile::open(texture.name, *texture.bytes)
                                      : images::ImageFile::open(texture.file);
    if (!image) {
        return std::move(image.diagnostics);
    }
    return TextureReader(std::move(*image), encoding);
}

template <class Value>
std::optional<Diagnostic> TextureReader::read_values(std::size_t begin, std::size_t end,
                                                     std::vector<Value>& values) {
    if (is_stopped()) {
        return stopped();
    }
    values.resize((end - begin) * image_->width() * image_->channels());
    return image_->read_rows(begin, end, values);
}

Imath::half TextureReader::repaired(float value) {
    if (!std::isfinite(value)) {
        repaired_ = true;
        return 0.0F;
    }
    constexpr auto largest = static_cast<float>(HALF_MAX);
    return std::clamp(value, -largest, largest);
}

std::optional<Diagnostic> TextureReader::read_rows(std::size_t begin, std::size_t end,
                                                   std::span<ByteTexel> texels) {
    if (auto failure = read_values(begin, end, bytes_)) {
        return failure;
    }
    spread<ByteTexel, std::uint8_t>(
        bytes_, image_->channels(), 255, texels,
        [](ByteTexel& texel, std::uint8_t r, std::uint8_t g, std::uint8_t b, std::uint8_t a) {
            texel = {r, g, b, a};
        });
    return std::nullopt;
}

std::optional<Diagnostic> TextureReader::read_rows(std::size_t begin, std::size_t end,
                                                   std::span<HalfTexel> texels) {
    static const SrgbDecoder linear;
    if (auto failure = read_values(begin, end, floats_)) {
        return failure;
    }
    const bool is_srgb = encoding_ == TextureEncoding::srgb;
    const auto color = [&](float value) { return repaired(is_srgb ? linear(value) : value); };
    spread<HalfTexel, float>(floats_, image_->channels(), 1.0F, texels,
                             [&](HalfTexel& texel, float r, float g, float b, float a) {
                                 texel = {color(r), color(g), color(b), repaired(a)};
                             });
    return std::nullopt;
}

}  // namespace balcony::render
