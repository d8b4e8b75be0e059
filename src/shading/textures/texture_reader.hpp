// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The pixels of a texture's image as texels: red, green, blue, alpha. Grey is spread, a missing
// alpha is 1, and a value that is not finite is read as 0.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

#include <Imath/half.h>

#include "balcony/base.hpp"
#include "balcony/images.hpp"
#include "balcony/scene.hpp"

namespace balcony::render {

using scene::TextureEncoding;

using ByteTexel = std::array<std::uint8_t, 4>;  ///< As in the image: colours may be sRGB.
using HalfTexel = std::array<Imath::half, 4>;   ///< Linear.

/// The linear colour of an sRGB value (IEC 61966-2-1).
[[nodiscard]] float linear_from_srgb(float value);

/// An image that is open for reading. Reading rows in their order decodes each once.
class TextureReader {
public:
    /// The texture must outlive the result. The message of an error is a reason, as that of
    /// images::ImageFile::open().
    [[nodiscard]] static Result<TextureReader> open(const scene::Texture& texture,
                                                    TextureEncoding encoding);

    [[nodiscard]] std::size_t width() const { return image_->width(); }
    [[nodiscard]] std::size_t height() const { return image_->height(); }
    [[nodiscard]] TextureEncoding encoding() const { return encoding_; }
    [[nodiscard]] bool has_bytes() const { return image_->has_bytes(); }
    /// Whether a value that was read was not finite.
    [[nodiscard]] bool has_repaired() const { return repaired_; }

    /// From now on, a stop is a failure of Kind::interrupted.
    void obey(std::stop_token stop) { stop_ = std::move(stop); }
    [[nodiscard]] bool is_stopped() const { return stop_.stop_requested(); }

    /// Reads the rows [begin, end). Returns the reason if that fails.
    [[nodiscard]] std::optional<Diagnostic> read_rows(std::size_t begin, std::size_t end,
                                                      std::span<ByteTexel> texels);
    /// The same, decoded to linear values; they are limited to the range of a half.
    [[nodiscard]] std::optional<Diagnostic> read_rows(std::size_t begin, std::size_t end,
                                                      std::span<HalfTexel> texels);

private:
    TextureReader(std::unique_ptr<images::ImageFile> image, TextureEncoding encoding)
        : image_(std::move(image)), encoding_(encoding) {}

    template <class Value>
    [[nodiscard]] std::optional<Diagnostic> read_values(std::size_t begin, std::size_t end,
                                                        std::vector<Value>& values);
    [[nodiscard]] Imath::half repaired(float value);

    std::stop_token stop_;
    std::unique_ptr<images::ImageFile> image_;
    TextureEncoding encoding_;
    bool repaired_ = false;
    std::vector<std::uint8_t> bytes_;  // Of the rows at work; kept for their memory.
    std::vector<float> floats_;
};

}  // namespace balcony::render
