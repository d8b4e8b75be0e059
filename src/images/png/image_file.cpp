// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <bit>
#include <csetjmp>
#include <cstring>
#include <limits>
#include <utility>

#include <png.h>

#include "images/byte_numbers.hpp"
#include "images/exif.hpp"
#include "images/image_checks.hpp"
#include "images/png/libpng.hpp"
#include "images/png/png.hpp"
#include "images/sample_values.hpp"
#include "images/stored_image.hpp"

namespace balcony::images {

namespace {

constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";

std::optional<DeclaredSize> declared_size(std::string_view bytes) {
    return has(bytes, 12, "IHDR")
               ? std::optional(DeclaredSize{big_endian(bytes, 16, 4), big_endian(bytes, 20, 4)})
               : std::nullopt;
}

// Whether all chunks are there, up to the last; libpng compares their checksums.
bool is_whole(std::string_view bytes) {
    constexpr std::size_t length_size = 4;
    constexpr std::size_t kind_size = 4;
    constexpr std::size_t checksum_size = 4;
    for (std::size_t at = signature.size(); at < bytes.size();) {
        const bool is_last = has(bytes, at + length_size, "IEND");
        at += length_size + kind_size + big_endian(bytes, at, length_size) + checksum_size;
        if (is_last) {
            return at <= bytes.size();
        }
    }
    return false;
}

void take(png_structp png, png_bytep to, std::size_t count) {
    auto& rest = *static_cast<std::span<const std::uint8_t>*>(png_get_io_ptr(png));
    if (count > rest.size()) {
        png_error(png, "it ends too early");
    }
    std::memcpy(to, rest.data(), count);
    rest = rest.subspan(count);
}

// Reads the header. Rows come in their order, with 8 or 16 bits a channel. False if it fails.
bool begin(png_structp png, png_infop info) {
    if (setjmp(png_jmpbuf(png)) != 0) {
        return false;
    }
    allow_any_side(png);
#ifdef PNG_IGNORE_ADLER32  // Some versions have no choice.
    // The checksums of its chunks already cover what that of the stream does.
    png_set_option(png, PNG_IGNORE_ADLER32, PNG_OPTION_ON);
#endif
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
    png_set_crc_action(png, PNG_CRC_QUIET_USE, PNG_CRC_QUIET_USE);
#endif
    png_read_info(png, info);
    png_set_expand(png);
    if (std::endian::native == std::endian::little) {
        png_set_swap(png);
    }
    (void)png_set_interlace_handling(png);
    png_read_update_info(png, info);
    return true;
}

// Rows that follow each other in a file, and in memory.
struct Rows {
    std::uint8_t* first;
    std::size_t step;  // 0 if all go to the same place.
    std::size_t count;
};

bool take_rows(png_structp png, const Rows& rows, int passes) {
    if (setjmp(png_jmpbuf(png)) != 0) {
        return false;
    }
    for (int pass = 0; pass < passes; ++pass) {
        for (std::size_t y = 0; y < rows.count; ++y) {
            png_read_row(png, rows.first + y * rows.step, nullptr);
        }
    }
    return true;
}

int orientation_of(png_const_structp png, png_infop info) {
    png_uint_32 size = 0;
    png_bytep exif = nullptr;
    return png_get_eXIf_1(png, info, &size, &exif) != 0
               ? exif_orientation({reinterpret_cast<const char*>(exif), size})
               : 1;
}

class PngFile final : public StoredImage {
public:
    explicit PngFile(EncodedBytes bytes) : bytes_(std::move(bytes)) {}
    PngFile(const PngFile&) = delete;
    PngFile& operator=(const PngFile&) = delete;
    ~PngFile() override { png_destroy_read_struct(&png_, &info_, nullptr); }

    // Begins at the top.
    [[nodiscard]] std::optional<Diagnostic> start();

    bool is_float() const override { return false; }
    bool has_bytes() const override { return sample_size_ == 1; }
    std::vector<std::string> channel_names() const override {
        const bool is_grey = stored_.channels < 3;
        std::vector<std::string> names =
            is_grey ? std::vector<std::string>{"Y"} : std::vector<std::string>{"R", "G", "B"};
        if (has_alpha()) {
            names.emplace_back("A");
        }
        return names;
    }
    bool is_whole_picture() const override { return true; }
    std::optional<std::size_t> unassociated_alpha() const override {
        return has_alpha() ? std::optional(stored_.channels - 1) : std::nullopt;
    }

protected:
    std::optional<Diagnostic> read_stored(std::size_t begin, std::size_t end,
                                          const Values& values) override {
        return std::visit([&](auto rows) { return read(begin, end, rows); }, values);
    }

private:
    [[nodiscard]] bool has_alpha() const { return stored_.channels % 2 == 0; }
    [[nodiscard]] std::size_t row_size() const {
        return stored_.width * stored_.channels * sample_size_;
    }
    // Decodes the next rows.
    [[nodiscard]] std::optional<Diagnostic> decode(const Rows& rows);
    [[nodiscard]] std::optional<Diagnostic> decode_interlaced();
    template <class Value>
    [[nodiscard]] std::optional<Diagnostic> read(std::size_t begin, std::size_t end,
                                                 std::span<Value> values);
    template <class Value>
    void convert(const std::uint8_t* row, std::span<Value> values) const;

    EncodedBytes bytes_;
    std::span<const std::uint8_t> rest_;  // That libpng has still to read.
    PngFailure failure_;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
    std::size_t sample_size_ = 1;
    int passes_ = 1;                 // More than one if its rows are interlaced.
    std::size_t next_row_ = 0;       // After the last that was decoded.
    std::vector<std::uint8_t> row_;  // Or all rows, if they are interlaced.
};

std::optional<Diagnostic> PngFile::start() {
    png_destroy_read_struct(&png_, &info_, nullptr);
    rest_ = bytes_.span();
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &failure_, fail, ignore);
    info_ = png_ != nullptr ? png_create_info_struct(png_) : nullptr;
    if (info_ == nullptr) {
        return error(Kind::environment, "libpng does not start");
    }
    png_set_read_fn(png_, &rest_, take);
    if (!begin(png_, info_)) {
        return corrupt(failure_.reason.data());
    }
    stored_ = {png_get_image_width(png_, info_), png_get_image_height(png_, info_),
               png_get_channels(png_, info_), orientation_of(png_, info_)};
    sample_size_ = png_get_bit_depth(png_, info_) / 8U;
    constexpr int adam7_passes = 7;
    passes_ = png_get_interlace_type(png_, info_) == PNG_INTERLACE_ADAM7 ? adam7_passes : 1;
    next_row_ = 0;
    return std::nullopt;
}

std::optional<Diagnostic> PngFile::decode(const Rows& rows) {
    if (rows.count == 0) {
        return std::nullopt;
    }
    const std::size_t end = next_row_ + rows.count;
    const bool is_read = take_rows(png_, rows, passes_);
    // After a failure, it begins anew.
    next_row_ = is_read ? end : std::numeric_limits<std::size_t>::max();
    return is_read ? std::nullopt : std::optional(corrupt(failure_.reason.data()));
}

std::optional<Diagnostic> PngFile::decode_interlaced() {
    if (next_row_ == stored_.height) {
        return std::nullopt;
    }
    if (auto failure = start()) {
        return failure;
    }
    row_.resize(row_size() * stored_.height);
    return decode({row_.data(), row_size(), stored_.height});
}

template <class Value>
void PngFile::convert(const std::uint8_t* row, std::span<Value> values) const {
    if (has_bytes()) {
        copy_samples(std::span(row, values.size()), values);
        return;
    }
    std::transform(values.begin(), values.end(), values.begin(), [&](Value) {
        std::uint16_t sample = 0;
        std::memcpy(&sample, row, sizeof(sample));
        row += sizeof(sample);
        return sample_value<Value>(sample);
    });
}

template <class Value>
std::optional<Diagnostic> PngFile::read(std::size_t begin, std::size_t end,
                                        std::span<Value> values) {
    const std::size_t row_values = stored_.width * stored_.channels;
    if (passes_ > 1) {
        auto failure = decode_interlaced();
        if (!failure) {
            convert(row_.data() + begin * row_size(), values);
        }
        return failure;
    }
    if (begin < next_row_) {
        if (auto failure = start()) {
            return failure;
        }
    }
    row_.resize(row_size());
    if (auto failure = decode({row_.data(), 0, begin - next_row_})) {
        return failure;
    }
    if constexpr (sizeof(Value) == 1) {
        if (has_bytes()) {
            return decode({values.data(), row_values, end - begin});
        }
    }
    for (std::size_t y = 0; y < end - begin; ++y) {
        if (auto failure = decode({row_.data(), 0, 1})) {
            return failure;
        }
        convert(row_.data(), values.subspan(y * row_values, row_values));
    }
    return std::nullopt;
}

}  // namespace

bool is_png(std::string_view start) { return start.starts_with(signature); }

Result<std::unique_ptr<ImageFile>> open_png(EncodedBytes bytes) {
    constexpr std::size_t deflate_ratio = 1032;
    constexpr std::size_t pixels_per_byte = 8;
    const std::string_view text = bytes.text();
    if (auto failure =
            check_declared(declared_size(text), text.size(), deflate_ratio * pixels_per_byte)) {
        return *std::move(failure);
    }
    if (!is_whole(text)) {
        return truncated();
    }
    auto opened = std::make_unique<PngFile>(std::move(bytes));
    if (auto failure = opened->start()) {
        return *std::move(failure);
    }
    return std::unique_ptr<ImageFile>(std::move(opened));
}

}  // namespace balcony::images
