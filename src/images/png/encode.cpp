// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <bit>
#include <cmath>
#include <csetjmp>
#include <exception>
#include <string_view>

#include <fmt/format.h>
#include <png.h>

#include "images/png/libpng.hpp"
#include "images/png/png.hpp"

namespace balcony::images {

namespace {

// No exception may pass through libpng.
void append(png_structp png, png_bytep bytes, std::size_t count) {
    auto& output = *static_cast<std::vector<std::uint8_t>*>(png_get_io_ptr(png));
    bool fits = true;
    try {
        output.insert(output.end(), bytes, bytes + count);
    } catch (const std::exception&) {
        fits = false;
    }
    // After the handler: a jump out of it leaves its exception behind.
    if (!fits) {
        png_error(png, "there is not enough memory");
    }
}

void describe(png_structp png, png_infop info, const Raster& raster, int bits) {
    allow_any_side(png);
    png_set_IHDR(png, info, static_cast<png_uint_32>(raster.width),
                 static_cast<png_uint_32>(raster.height), bits,
                 raster.channels == 4 ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    if (raster.dpi > 0.0) {
        constexpr double metres_per_inch = 0.0254;
        const auto per_metre = static_cast<png_uint_32>(std::round(raster.dpi / metres_per_inch));
        png_set_pHYs(png, info, per_metre, per_metre, PNG_RESOLUTION_METER);
    }
}

// Nothing here has a destructor, as a failure jumps out of it. False if it does.
bool write(png_structp png, png_infop info, const Raster& raster, int bits, const std::uint8_t* row,
           std::size_t row_size) {
    if (setjmp(png_jmpbuf(png)) != 0) {
        return false;
    }
    describe(png, info, raster, bits);
    // Filters make noise larger. Levels above 4 take up to three times as long for 2 %.
    png_set_compression_level(png, 4);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_NO_FILTERS);
    png_write_info(png, info);
    if (std::endian::native == std::endian::little) {
        png_set_swap(png);
    }
    for (std::size_t y = 0; y < raster.height; ++y) {
        png_write_row(png, row + y * row_size);
    }
    png_write_end(png, info);
    return true;
}

}  // namespace

Result<std::vector<std::uint8_t>> encode_png(const Raster& raster) {
    std::vector<std::uint8_t> bytes;
    PngFailure failure;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &failure, fail, ignore);
    png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
    bool written = false;
    if (info != nullptr) {
        png_set_write_fn(png, &bytes, append, nullptr);
        written = std::visit(
            [&](auto samples) {
                constexpr std::size_t sample_size = sizeof(samples[0]);
                return write(png, info, raster, 8 * static_cast<int>(sample_size),
                             reinterpret_cast<const std::uint8_t*>(samples.data()),
                             raster.width * raster.channels * sample_size);
            },
            raster.samples);
    }
    png_destroy_write_struct(&png, &info);
    if (!written) {
        const std::string_view reason = failure.reason.data();
        return error(Kind::environment,
                     fmt::format("the picture cannot be encoded as png: {}",
                                 reason.empty() ? "libpng does not start" : reason));
    }
    return bytes;
}

}  // namespace balcony::images
