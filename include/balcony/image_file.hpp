// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Image files: the only reader of images from outside, whether they are textures
// or masks, on the disk or embedded.
//
// Only PNG, JPEG, WebP, TIFF, OpenEXR, Radiance HDR, TGA and BMP are supported. The first bytes
// determine the format (TGA has no signature, so it needs its extension and a plausible header),
// and only that format's reader opens the file. The sizes in a header are checked against the
// limits below and against the size of the file before any memory is allocated for pixels.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "balcony/base.hpp"

namespace balcony::scene {

inline constexpr std::size_t max_image_pixels = 100'000'000;
inline constexpr std::size_t max_image_values = 4 * max_image_pixels;  ///< Pixels times channels.
inline constexpr std::size_t max_tile_row_pixels = 16'777'216;         ///< Of a tiled image.

/// Which channels of a file are read: colour and alpha, or all that it has.
enum class ImageChannels : std::uint8_t { first_four, all };

/// An image that is open for reading, row by row from the top. Reading rows in their order decodes
/// each once; going back begins again at the top where the format knows no other way.
class ImageFile {
public:
    /// Opens a file. The message of an error is a reason that completes a sentence about the image:
    /// "it has 30000 x 30000 pixels, more than 100 million".
    [[nodiscard]] static Result<ImageFile> open(const std::filesystem::path& file,
                                                ImageChannels channels = ImageChannels::first_four);
    /// The same for the bytes of a file, which must outlive the result; the extension of `name` is
    /// used for TGA only.
    [[nodiscard]] static Result<ImageFile> open(const std::filesystem::path& name,
                                                std::span<const std::uint8_t> bytes,
                                                ImageChannels channels = ImageChannels::first_four);
    ImageFile(ImageFile&&) noexcept;
    ImageFile& operator=(ImageFile&&) noexcept;
    ~ImageFile();

    [[nodiscard]] std::size_t width() const;
    [[nodiscard]] std::size_t height() const;
    /// The number of channels that are read.
    [[nodiscard]] std::size_t channels() const;
    /// Their names: R, G, B and A where the format has none.
    [[nodiscard]] std::vector<std::string> channel_names() const;
    /// Whether it has the pixels of the whole picture and no others; an EXR file may have those of
    /// another window.
    [[nodiscard]] bool is_whole_picture() const;
    /// Whether the file holds floats, which are linear light, rather than integers.
    [[nodiscard]] bool is_float() const;
    /// Whether the values are whole numbers of 8 bits, which can be read as they are.
    [[nodiscard]] bool has_bytes() const;
    /// The channel of straight alpha, if any.
    [[nodiscard]] std::optional<std::size_t> unassociated_alpha() const;

    /// Reads the rows [begin, end): channels() values per pixel, integers scaled to 0 .. 1. Returns
    /// nothing on success, otherwise the reason, as for open().
    [[nodiscard]] std::optional<Diagnostic> read_rows(std::size_t begin, std::size_t end,
                                                      std::span<float> values);
    /// The same from 0 to 255; values of more than 8 bits are rounded.
    [[nodiscard]] std::optional<Diagnostic> read_rows(std::size_t begin, std::size_t end,
                                                      std::span<std::uint8_t> values);

private:
    struct State;
    explicit ImageFile(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace balcony::scene
