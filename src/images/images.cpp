// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/images.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <limits>

#include <fmt/format.h>

#include "balcony/input_file.hpp"
#include "images/image_checks.hpp"
#include "images/image_library.hpp"
#include "images/jpeg/jpeg.hpp"
#include "images/png/png.hpp"

namespace balcony::images {

namespace {

using Bytes = std::vector<std::uint8_t>;

// A format that is read and written without OpenImageIO.
struct DirectFormat {
    std::string_view name;
    bool (*matches)(std::string_view start);
    Result<std::unique_ptr<ImageFile>> (*open)(EncodedBytes bytes);
    Result<Bytes> (*encode)(const Raster& raster);
};
constexpr std::array direct_formats{DirectFormat{"png", is_png, open_png, encode_png},
                                    DirectFormat{"jpeg", is_jpeg, open_jpeg, encode_jpeg}};
constexpr std::size_t longest_signature = 8;

constexpr std::array library_formats{std::string_view("webp"), std::string_view("tiff")};

template <class Test>
const DirectFormat* direct_format(const Test& test) {
    const auto* const found = std::find_if(direct_formats.begin(), direct_formats.end(), test);
    return found == direct_formats.end() ? nullptr : found;
}

const DirectFormat* direct_format_of(std::span<const std::uint8_t> bytes) {
    const std::string_view start = EncodedBytes::as_text(bytes).substr(0, longest_signature);
    return direct_format([&](const DirectFormat& format) { return format.matches(start); });
}

const DirectFormat* direct_format_named(std::string_view name) {
    return direct_format([&](const DirectFormat& format) { return format.name == name; });
}

// Up to so many bytes.
Bytes read(std::istream& stream, std::size_t count) {
    Bytes bytes(count);
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(count));
    bytes.resize(static_cast<std::size_t>(stream.gcount()));
    return bytes;
}

Result<std::unique_ptr<ImageFile>> open_whole(const DirectFormat& format, std::istream& stream) {
    stream.seekg(0, std::ios::end);
    const auto size = static_cast<std::size_t>(std::max<std::streamoff>(stream.tellg(), 0));
    if (size > max_encoded_bytes) {
        return error(
            fmt::format("it has {} MiB, more than {}", size >> 20U, max_encoded_bytes >> 20U), {},
            "scale it down, or export it again");
    }
    stream.seekg(0);
    Result<std::unique_ptr<ImageFile>> opened = error(Kind::internal, "it is not opened");
    if (auto failure = guarded([&]() -> std::optional<Diagnostic> {
            opened = format.open(EncodedBytes(read(stream, size)));
            return std::nullopt;
        })) {
        return *std::move(failure);
    }
    return opened;
}

bool has_size(std::size_t width, std::size_t height) {
    constexpr std::size_t largest = std::numeric_limits<int>::max();
    return width > 0 && height > 0 && width <= largest && height <= largest;
}

bool holds_together(const Raster& raster) {
    const std::size_t values =
        std::visit([](auto samples) { return samples.size(); }, raster.samples);
    return has_size(raster.width, raster.height) &&
           (raster.channels == 3 || raster.channels == 4) &&
           values == raster.width * raster.height * raster.channels;
}

}  // namespace

Result<std::unique_ptr<ImageFile>> ImageFile::open(const std::filesystem::path& file,
                                                   ImageChannels channels) {
    if (const auto fault = not_a_file(file, fmt::format("'{}'", file.string()))) {
        return *fault;
    }
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
        return error("it cannot be opened", {}, "check its read permission");
    }
    if (const DirectFormat* const format = direct_format_of(read(stream, longest_signature))) {
        return open_whole(*format, stream);
    }
    const auto& library = image_library();
    return library ? (*library)->open(file, channels) : library.diagnostics;
}

Result<std::unique_ptr<ImageFile>> ImageFile::open(const std::filesystem::path& name,
                                                   std::span<const std::uint8_t> bytes,
                                                   ImageChannels channels) {
    if (const DirectFormat* const format = direct_format_of(bytes)) {
        return format->open(EncodedBytes(bytes));
    }
    const auto& library = image_library();
    return library ? (*library)->open(name, bytes, channels) : library.diagnostics;
}

Result<Bytes> encode(const Raster& raster, std::string_view format) {
    const DirectFormat* const direct = direct_format_named(format);
    const bool is_known =
        direct != nullptr ||
        std::find(library_formats.begin(), library_formats.end(), format) != library_formats.end();
    if (!holds_together(raster) || !is_known) {
        return error(Kind::internal, "the samples, channels or format of an image cannot be");
    }
    if (direct != nullptr) {
        return direct->encode(raster);
    }
    const auto& library = image_library();
    return library ? (*library)->encode(raster, format) : library.diagnostics;
}

Result<std::unique_ptr<FilteredImage>> FilteredImage::make(const LinearImage& image, bool closes) {
    if (!has_size(image.width, image.height) ||
        image.values.size() != 4 * image.width * image.height) {
        return error(Kind::internal, "an image to filter does not have four values a pixel");
    }
    const auto& library = image_library();
    if (!library) {
        return library.diagnostics;
    }
    return (*library)->filter(image, closes);
}

Diagnostics require_encoder(std::string_view format) {
    return direct_format_named(format) != nullptr ? Diagnostics() : require();
}

Diagnostics require_reader(const std::filesystem::path& file) {
    if (not_a_file(file, {})) {
        return {};  // As ImageFile::open() will say.
    }
    std::ifstream stream(file, std::ios::binary);
    return require_reader(read(stream, longest_signature));
}

Diagnostics require_reader(std::span<const std::uint8_t> bytes) {
    return direct_format_of(bytes) != nullptr ? Diagnostics() : require();
}

Diagnostics require() { return image_library().diagnostics; }

}  // namespace balcony::images
