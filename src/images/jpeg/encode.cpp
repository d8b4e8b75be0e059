// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>
#include <turbojpeg.h>

#include "images/byte_numbers.hpp"
#include "images/jpeg/jpeg.hpp"

namespace balcony::images {

namespace {

// JFIF 1.02: the header that is first in the file has a unit, and the density in either direction.
void set_resolution(std::vector<std::uint8_t>& bytes, double dpi) {
    constexpr std::size_t identifier_at = 6;
    constexpr std::size_t unit_at = 13;
    if (!has(EncodedBytes::as_text(bytes), identifier_at, "JFIF")) {
        return;
    }
    constexpr double centimeters_per_inch = 2.54;
    const double dpcm = dpi / centimeters_per_inch;
    const auto error = [](double value) { return std::abs(std::round(value) / value - 1.0); };
    // They are whole numbers, of which those per centimetre may be nearer.
    const bool is_metric = error(dpcm) < error(dpi);
    const auto density =
        static_cast<unsigned>(std::clamp(std::round(is_metric ? dpcm : dpi), 1.0, 65535.0));
    bytes[unit_at] = is_metric ? 2 : 1;
    for (const std::size_t at : {unit_at + 1, unit_at + 3}) {
        bytes[at] = static_cast<std::uint8_t>(density >> 8U);
        bytes[at + 1] = static_cast<std::uint8_t>(density);
    }
}

}  // namespace

Result<std::vector<std::uint8_t>> encode_jpeg(const Raster& raster) {
    // Quality at which sharp lines have no visible fringes; without subsampling of colours.
    constexpr int quality = 92;
    const auto* const samples = std::get_if<std::span<const std::uint8_t>>(&raster.samples);
    if (samples == nullptr || raster.channels != 3) {
        return error(Kind::internal, "JPEG has three channels of 8 bits");
    }
    const std::unique_ptr<void, int (*)(tjhandle)> encoder(tjInitCompress(), tjDestroy);
    unsigned char* encoded = nullptr;
    unsigned long size = 0;
    const bool is_made =
        encoder && tjCompress2(encoder.get(), samples->data(), static_cast<int>(raster.width), 0,
                               static_cast<int>(raster.height), TJPF_RGB, &encoded, &size,
                               TJSAMP_444, quality, 0) == 0;
    const std::unique_ptr<unsigned char, void (*)(unsigned char*)> freed(encoded, tjFree);
    if (!is_made) {
        return error(Kind::environment,
                     fmt::format("the picture cannot be encoded as jpeg: {}",
                                 encoder ? tjGetErrorStr2(encoder.get()) : "it does not start"));
    }
    std::vector<std::uint8_t> bytes(encoded, encoded + size);
    if (raster.dpi > 0.0) {
        set_resolution(bytes, raster.dpi);
    }
    return bytes;
}

}  // namespace balcony::images
