// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Images: reading, encoding and filtering images, the only reader of images from outside, whether
// they are textures or masks, on the disk or embedded.
//
// libpng reads and writes PNG files, libjpeg-turbo JPEG files, and OpenImageIO does the rest. A
// program that links Balcony links them too; the command loads OpenImageIO with the first image
// that needs it, since loading it takes longer than most commands take.

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <Imath/ImathVec.h>

#include "balcony/base.hpp"

namespace balcony::images {

// ----------------------------------------------------------------------------------- reading

inline constexpr std::size_t max_image_pixels = 100'000'000;
inline constexpr std::size_t max_image_values = 4 * max_image_pixels;  ///< Pixels times channels.
inline constexpr std::size_t max_tile_row_pixels = 16'777'216;         ///< Of a tiled image.
/// Of a PNG or JPEG file, which is in memory while it is open: more than all values take in 16
/// bits.
inline constexpr std::size_t max_encoded_bytes = std::size_t{1} << 30U;

/// Which channels of a file are read: colour and alpha, or all that it has.
enum class ImageChannels : std::uint8_t { first_four, all };

/// An image that is open for reading, row by row from the top. Reading rows in their order decodes
/// each once; going back begins again at the top where the format knows no other way. A JPEG, and a
/// PNG whose rows are interlaced, are decoded as a whole with their first rows.
///
/// Only PNG, JPEG, WebP, TIFF, OpenEXR, Radiance HDR, TGA and BMP are supported. The first bytes
/// determine the format (TGA has no signature, so it needs its extension and a plausible header),
/// and only that format's reader opens the file. The sizes in a header are checked against the
/// limits above and against the size of the file before any memory is allocated for pixels. A PNG
/// or JPEG that ends too early is refused when it is opened.
class ImageFile {
public:
    /// Opens a file. The message of an error is a reason that completes a sentence about the image:
    /// "it has 30000 x 30000 pixels, more than 100 million".
    [[nodiscard]] static Result<std::unique_ptr<ImageFile>> open(
        const std::filesystem::path& file, ImageChannels channels = ImageChannels::first_four);
    /// The same for the bytes of a file, which must outlive the result; the extension of `name` is
    /// used for TGA only.
    [[nodiscard]] static Result<std::unique_ptr<ImageFile>> open(
        const std::filesystem::path& name, std::span<const std::uint8_t> bytes,
        ImageChannels channels = ImageChannels::first_four);

    ImageFile() = default;
    ImageFile(const ImageFile&) = delete;
    ImageFile& operator=(const ImageFile&) = delete;
    virtual ~ImageFile() = default;

    [[nodiscard]] virtual std::size_t width() const = 0;
    [[nodiscard]] virtual std::size_t height() const = 0;
    /// The number of channels that are read.
    [[nodiscard]] virtual std::size_t channels() const = 0;
    /// Their names: R, G, B and A where the format has none.
    [[nodiscard]] virtual std::vector<std::string> channel_names() const = 0;
    /// Whether it has the pixels of the whole picture and no others; an EXR file may have those of
    /// another window.
    [[nodiscard]] virtual bool is_whole_picture() const = 0;
    /// Whether the file holds floats, which are linear light, rather than integers.
    [[nodiscard]] virtual bool is_float() const = 0;
    /// Whether the values are whole numbers of 8 bits, which can be read as they are.
    [[nodiscard]] virtual bool has_bytes() const = 0;
    /// The channel of straight alpha, if any.
    [[nodiscard]] virtual std::optional<std::size_t> unassociated_alpha() const = 0;

    /// From now on, it has the size and the rows of the image as its orientation (EXIF, TIFF) says
    /// that it is seen. One that is stored otherwise is decoded as a whole with its first rows.
    virtual void turn_upright() = 0;

    /// Reads the rows [begin, end): channels() values per pixel, integers scaled to 0 .. 1. Returns
    /// nothing on success, otherwise the reason, as for open(). Rows that the image does not have,
    /// and another number of values, are an error of Kind::internal.
    [[nodiscard]] virtual std::optional<Diagnostic> read_rows(std::size_t begin, std::size_t end,
                                                              std::span<float> values) = 0;
    /// The same from 0 to 255; values of more than 8 bits are rounded.
    [[nodiscard]] virtual std::optional<Diagnostic> read_rows(std::size_t begin, std::size_t end,
                                                              std::span<std::uint8_t> values) = 0;
};

// ---------------------------------------------------------------------------------- encoding

using Samples = std::variant<std::span<const std::uint8_t>, std::span<const std::uint16_t>>;

/// An sRGB image by rows from the top, then columns, then channels.
struct Raster {
    std::size_t width = 0;
    std::size_t height = 0;
    std::size_t channels = 0;  ///< 3, or 4 with straight alpha.
    Samples samples;
    double dpi = 0.0;  ///< Pixels per inch of its print; 0 if that is not known.
};

/// The bytes of a file. The format is "png", "jpeg", "webp" or "tiff"; JPEG has no alpha, and JPEG
/// and WebP have 8 bits. Another format, and samples that it does not have, are errors of
/// Kind::internal.
[[nodiscard]] Result<std::vector<std::uint8_t>> encode(const Raster& raster,
                                                       std::string_view format);

// --------------------------------------------------------------------------------- filtering

/// Linear red, green, blue, premultiplied by alpha, and alpha, by rows from the top left.
struct LinearImage {
    std::size_t width = 0;
    std::size_t height = 0;
    std::span<const float> values;
};

/// Gives the mean over parts of an image. Look-ups may come from any number of threads.
class FilteredImage {
public:
    /// The values must outlive the result. An image that closes goes on at its other side. Another
    /// number of values is an error of Kind::internal.
    [[nodiscard]] static Result<std::unique_ptr<FilteredImage>> make(const LinearImage& image,
                                                                     bool closes);

    FilteredImage() = default;
    FilteredImage(const FilteredImage&) = delete;
    FilteredImage& operator=(const FilteredImage&) = delete;
    virtual ~FilteredImage() = default;

    /// The mean around st, over a part whose sides are the two others; (0, 0) is the lower left
    /// corner of the image and (1, 1) the upper right one.
    [[nodiscard]] virtual std::array<float, 4> mean(const Imath::V2d& st, const Imath::V2d& side,
                                                    const Imath::V2d& other_side) const = 0;
};

// ------------------------------------------------------------------------------- OpenImageIO

/// Loads OpenImageIO at once. If it is missing, that is an error of Kind::environment.
[[nodiscard]] Diagnostics require();
/// The same if encode() needs it for a format, as for all but "png" and "jpeg", so that a caller
/// that writes an image after long work learns before it that it is missing.
[[nodiscard]] Diagnostics require_encoder(std::string_view format);
/// The same if ImageFile::open() needs it for an image, by its file or by its bytes.
[[nodiscard]] Diagnostics require_reader(const std::filesystem::path& file);
[[nodiscard]] Diagnostics require_reader(std::span<const std::uint8_t> bytes);

}  // namespace balcony::images
