// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <memory>
#include <utility>

#include <turbojpeg.h>

#include "images/byte_numbers.hpp"
#include "images/exif.hpp"
#include "images/image_checks.hpp"
#include "images/jpeg/jpeg.hpp"
#include "images/sample_values.hpp"
#include "images/stored_image.hpp"

namespace balcony::images {

namespace {

constexpr std::string_view signature = "\xff\xd8\xff";
constexpr std::string_view end_of_image = "\xff\xd9";

// What a file says of its pixels before them.
struct Header {
    DeclaredSize size;
    std::size_t components = 0;
    int orientation = 1;
    std::size_t end = 0;  // Where it ends.
};

// Visits all markers up to the start of a frame (ITU-T T.81, annex B).
std::optional<Header> header_of(std::string_view bytes) {
    constexpr std::size_t application_1 = 0xe1;
    constexpr std::string_view exif = {"Exif\0\0", 6};
    Header header;
    for (std::size_t at = 2; at + 4 <= bytes.size();) {
        const std::size_t marker = big_endian(bytes, at + 1, 1);
        const std::size_t length = std::max<std::size_t>(big_endian(bytes, at + 2, 2), 2);
        if (bytes[at] != '\xff') {
            return std::nullopt;
        }
        const std::string_view segment = bytes.substr(at + 4, length - 2);
        if (marker == application_1 && segment.starts_with(exif)) {
            header.orientation = exif_orientation(segment.substr(exif.size()));
        }
        const bool is_frame =
            marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
        if (is_frame) {
            header.size = {big_endian(bytes, at + 7, 2), big_endian(bytes, at + 5, 2)};
            header.components = big_endian(bytes, at + 9, 1);
            header.end = at;
            return header;
        }
        // A marker may be preceded by any number of fill bytes.
        at += marker == 0xff ? 1 : 2 + length;
    }
    return std::nullopt;
}

// Of CMYK, the files have what is left of white; libjpeg-turbo converts it to no other colours.
void convert_cmyk(std::vector<std::uint8_t>& pixels) {
    constexpr unsigned white = 255;
    std::size_t made = 0;
    for (std::size_t i = 0; i + 3 < pixels.size(); i += 4) {
        const unsigned key = pixels[i + 3];
        for (std::size_t channel = 0; channel < 3; ++channel) {
            pixels[made++] =
                static_cast<std::uint8_t>((pixels[i + channel] * key + white / 2) / white);
        }
    }
    pixels.resize(made);
}

class JpegFile final : public StoredImage {
public:
    JpegFile(EncodedBytes bytes, const Header& header)
        : bytes_(std::move(bytes)), components_(header.components) {
        stored_ = {header.size.width, header.size.height, is_grey() ? 1UL : 3UL,
                   header.orientation};
    }

    bool is_float() const override { return false; }
    bool has_bytes() const override { return true; }
    std::vector<std::string> channel_names() const override {
        return is_grey() ? std::vector<std::string>{"Y"} : std::vector<std::string>{"R", "G", "B"};
    }
    bool is_whole_picture() const override { return true; }
    std::optional<std::size_t> unassociated_alpha() const override { return std::nullopt; }

protected:
    std::optional<Diagnostic> read_stored(std::size_t begin, std::size_t end,
                                          const Values& values) override {
        return std::visit([&](auto rows) { return read(begin, end, rows); }, values);
    }

private:
    [[nodiscard]] bool is_grey() const { return components_ == 1; }
    [[nodiscard]] std::optional<Diagnostic> decode();
    template <class Value>
    [[nodiscard]] std::optional<Diagnostic> read(std::size_t begin, std::size_t end,
                                                 std::span<Value> values) {
        if (pixels_.empty()) {
            if (auto failure = decode()) {
                pixels_.clear();
                return failure;
            }
        }
        const std::size_t row = stored_.width * stored_.channels;
        copy_samples(
            std::span<const std::uint8_t>(pixels_).subspan(begin * row, (end - begin) * row),
            values);
        return std::nullopt;
    }

    EncodedBytes bytes_;
    std::size_t components_;
    std::vector<std::uint8_t> pixels_;  // Once it is decoded.
};

std::optional<Diagnostic> JpegFile::decode() {
    constexpr std::size_t cmyk = 4;
    const int format = is_grey() ? TJPF_GRAY : components_ == cmyk ? TJPF_CMYK : TJPF_RGB;
    const std::unique_ptr<void, int (*)(tjhandle)> decoder(tjInitDecompress(), tjDestroy);
    if (!decoder) {
        return error(Kind::environment, "libjpeg-turbo does not start");
    }
    const std::span<const std::uint8_t> bytes = bytes_.span();
    const auto width = static_cast<int>(stored_.width);
    const auto height = static_cast<int>(stored_.height);
    // The limits hold for what the decoder takes for the size, too. Whether it can name the
    // sampling does not matter.
    int found_width = 0;
    int found_height = 0;
    int sampling = 0;
    int colors = 0;
    (void)tjDecompressHeader3(decoder.get(), bytes.data(), bytes.size(), &found_width,
                              &found_height, &sampling, &colors);
    if (found_width != width || found_height != height) {
        return corrupt("its header is ambiguous");
    }
    pixels_.resize(stored_.width * stored_.height * static_cast<std::size_t>(tjPixelSize[format]));
    // Warnings, such as those of bytes between two markers, do not matter.
    if (tjDecompress2(decoder.get(), bytes.data(), bytes.size(), pixels_.data(), width, 0, height,
                      format, TJFLAG_LIMITSCANS) != 0 &&
        tjGetErrorCode(decoder.get()) != TJERR_WARNING) {
        return corrupt(tjGetErrorStr2(decoder.get()));
    }
    if (components_ == cmyk) {
        convert_cmyk(pixels_);
    }
    return std::nullopt;
}

}  // namespace

bool is_jpeg(std::string_view start) { return start.starts_with(signature); }

Result<std::unique_ptr<ImageFile>> open_jpeg(EncodedBytes bytes) {
    // A block of 64 pixels takes at least one bit.
    constexpr std::size_t pixels_per_byte = 64UL * 8;
    const std::string_view text = bytes.text();
    const std::optional<Header> header = header_of(text);
    if (auto failure = check_declared(header ? std::optional(header->size) : std::nullopt,
                                      text.size(), pixels_per_byte)) {
        return *std::move(failure);
    }
    if (text.find(end_of_image, header->end) == text.npos) {
        return truncated();
    }
    return std::unique_ptr<ImageFile>(std::make_unique<JpegFile>(std::move(bytes), *header));
}

}  // namespace balcony::images
