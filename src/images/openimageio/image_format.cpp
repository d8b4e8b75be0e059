// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "images/openimageio/image_format.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "balcony/input_file.hpp"
#include "images/byte_numbers.hpp"

namespace balcony::images {

namespace {

using OIIO::Filesystem::IOProxy;
using Size = std::optional<DeclaredSize>;

// `count` bytes at an offset, or fewer at the end of the file.
std::string bytes_at(IOProxy& file, std::size_t offset, std::size_t count) {
    std::string bytes(count, '\0');
    bytes.resize(file.pread(bytes.data(), count, static_cast<std::int64_t>(offset)));
    return bytes;
}

template <const auto&... signatures>
bool begins_with(const std::string& start, const std::string&) {
    return (start.starts_with(std::string_view(signatures.data(), signatures.size())) || ...);
}

constexpr std::array tiff_little{'I', 'I', '*', '\0'};
constexpr std::array tiff_big{'M', 'M', '\0', '*'};
constexpr std::array big_tiff_little{'I', 'I', '+', '\0'};
constexpr std::array big_tiff_big{'M', 'M', '\0', '+'};
constexpr std::array exr_signature{'\x76', '\x2f', '\x31', '\x01'};
constexpr std::array hdr_signature{'#', '?'};
constexpr std::array bmp_signature{'B', 'M'};

bool is_webp(const std::string& start, const std::string&) {
    return has(start, 0, "RIFF") && has(start, 8, "WEBP");
}

// TGA has no signature, but few headers are plausible: a kind of image, with or without a colour
// map, and a valid depth.
bool is_tga(const std::string& start, const std::string& ending) {
    if (ending != ".tga" || start.size() < 18) {
        return false;
    }
    const std::size_t kind = little_endian(start, 2, 1);
    const std::size_t depth = little_endian(start, 16, 1);
    const bool mapped = little_endian(start, 1, 1) == 1;
    const bool is_kind = (kind & ~std::size_t{8}) >= 1 && (kind & ~std::size_t{8}) <= 3;
    return little_endian(start, 1, 1) <= 1 && is_kind && mapped == ((kind & 7U) == 1) &&
           (depth == 8 || depth == 15 || depth == 16 || depth == 24 || depth == 32);
}

// Visits all attributes of all headers, because OpenEXR allocates what one claims before it reads
// it.
bool exr_attributes_fit(IOProxy& file) {
    constexpr std::size_t flags_at = 4;
    constexpr std::size_t first_header = 8;
    constexpr std::size_t several_parts = 0x1000;
    constexpr std::size_t longest_name = 255;
    constexpr std::size_t length_size = 4;
    const bool has_parts = (little_endian(bytes_at(file, flags_at, 4), 0, 4) & several_parts) != 0;
    bool is_empty = true;
    for (std::size_t at = first_header; at < file.size();) {
        // Two names, each with a zero at its end, and the length of what follows.
        const std::string head = bytes_at(file, at, 2 * (longest_name + 1) + length_size);
        const std::size_t name_end = head.find('\0');
        if (name_end == 0) {
            // The end of a header; an empty one ends those of several parts.
            if (!has_parts || is_empty) {
                return true;
            }
            is_empty = true;
            ++at;
            continue;
        }
        const std::size_t kind_end =
            name_end == head.npos ? head.npos : head.find('\0', name_end + 1);
        if (kind_end == head.npos) {
            return false;
        }
        is_empty = false;
        at += kind_end + 1 + length_size + little_endian(head, kind_end + 1, length_size);
    }
    return false;
}

// TIFF 6.0, section 2, and BigTIFF: whether the first directory, and the values of its entries that
// do not stand in it, are in the file, because libtiff prints what it misses.
bool tiff_directory_fits(IOProxy& file) {
    constexpr std::array<std::size_t, 19> type_sizes{0, 1, 1, 2, 4, 8, 1, 1, 2, 4,
                                                     8, 4, 8, 4, 0, 0, 8, 8, 8};
    const std::string header = bytes_at(file, 0, 16);
    const bool is_big = header.size() == 16 && (header[2] == '+' || header[3] == '+');
    const auto number = header[0] == 'I' ? little_endian : big_endian;
    const std::size_t width = is_big ? 8 : 4;  // Of a count or an offset.
    const std::size_t entry_size = 4 + 2 * width;
    const std::size_t count_size = is_big ? 8 : 2;
    const auto fits = [&](std::size_t at, std::size_t count, std::size_t size) {
        return at <= file.size() && (size == 0 || count <= (file.size() - at) / size);
    };
    const std::size_t directory = number(header, is_big ? 8 : 4, width);
    if (!fits(directory, count_size, 1)) {
        return false;
    }
    const std::size_t entries = number(bytes_at(file, directory, count_size), 0, count_size);
    if (!fits(directory + count_size, entries, entry_size)) {
        return false;
    }
    for (std::size_t i = 0; i < entries; ++i) {
        const std::string entry =
            bytes_at(file, directory + count_size + i * entry_size, entry_size);
        const std::size_t type = number(entry, 2, 2);
        const std::size_t size = type < type_sizes.size() ? type_sizes[type] : 0;
        const std::size_t count = number(entry, 4, width);
        const bool is_apart = size > 0 && count > width / size;
        if (is_apart && !fits(number(entry, 4 + width, width), count, size)) {
            return false;
        }
    }
    return entries > 0;
}

Size webp_size(IOProxy& file) {
    const std::string header = bytes_at(file, 0, 30);
    if (has(header, 12, "VP8X")) {
        return DeclaredSize{little_endian(header, 24, 3) + 1, little_endian(header, 27, 3) + 1};
    }
    if (has(header, 12, "VP8L")) {
        const std::size_t bits = little_endian(header, 21, 4);
        return DeclaredSize{(bits & 0x3fffU) + 1, (bits >> 14U & 0x3fffU) + 1};
    }
    return DeclaredSize{little_endian(header, 26, 2) & 0x3fffU,
                        little_endian(header, 28, 2) & 0x3fffU};
}

Size tga_size(IOProxy& file) {
    const std::string header = bytes_at(file, 0, 18);
    return DeclaredSize{little_endian(header, 12, 2), little_endian(header, 14, 2)};
}

// A negative height means that the rows start at the top.
Size bmp_size(IOProxy& file) {
    const std::string header = bytes_at(file, 0, 26);
    constexpr std::size_t old_header = 12;
    if (little_endian(header, 14, 4) == old_header) {
        return DeclaredSize{little_endian(header, 18, 2), little_endian(header, 20, 2)};
    }
    const auto height = static_cast<std::int32_t>(little_endian(header, 22, 4));
    return DeclaredSize{little_endian(header, 18, 4),
                        static_cast<std::size_t>(std::abs(std::int64_t{height}))};
}

// A packet of a TGA file holds 128 pixels in two bytes. The others know runs without end, or kinds
// of compression that do.
constexpr std::array<ImageFormat, 6> formats{{
    {"webp", 0, is_webp, webp_size, nullptr},
    {"tiff", 0, begins_with<tiff_little, tiff_big, big_tiff_little, big_tiff_big>, nullptr,
     tiff_directory_fits},
    {"openexr", 0, begins_with<exr_signature>, nullptr, exr_attributes_fit},
    {"hdr", 0, begins_with<hdr_signature>, nullptr, nullptr},
    {"bmp", 0, begins_with<bmp_signature>, bmp_size, nullptr},
    {"targa", 128 / 2, is_tga, tga_size, nullptr},
}};

}  // namespace

const ImageFormat* image_format(IOProxy& bytes, const std::filesystem::path& name) {
    const std::string start = bytes_at(bytes, 0, 18);
    const std::string ending = extension_of(name);
    const auto* found =
        std::find_if(formats.begin(), formats.end(),
                     [&](const ImageFormat& format) { return format.matches(start, ending); });
    return found == formats.end() ? nullptr : found;
}

}  // namespace balcony::images
