// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "images/openimageio/library.hpp"

namespace balcony::images {

Result<std::vector<std::uint8_t>> OpenImageIo::encode(const Raster& raster,
                                                      std::string_view format) const {
    const OIIO::TypeDesc type = std::visit(
        [](auto samples) {
            using Sample = typename decltype(samples)::value_type;
            return OIIO::TypeDesc(OIIO::BaseTypeFromC<Sample>::value);
        },
        raster.samples);
    OIIO::ImageSpec spec(static_cast<int>(raster.width), static_cast<int>(raster.height),
                         static_cast<int>(raster.channels), type);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("oiio:UnassociatedAlpha", 1);
    if (raster.dpi > 0.0) {
        spec.attribute("ResolutionUnit", "in");
        spec.attribute("XResolution", static_cast<float>(raster.dpi));
        spec.attribute("YResolution", static_cast<float>(raster.dpi));
    }
    if (format == "webp") {
        spec.attribute("Compression", "webp:92");
    } else if (format == "tiff") {
        spec.attribute("Compression", "zip");
        // OpenImageIO 2.4 writes invalid files if it adds EXIF data to a file in memory.
        spec.attribute("tiff:write_exif", 0);
        // Anything but a text keeps it from adding the time of writing.
        spec.attribute("DateTime", 0);
    }
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const std::string encoder(format);
    const auto output = OIIO::ImageOutput::create(encoder);
    const void* const samples = std::visit(
        [](auto values) { return static_cast<const void*>(values.data()); }, raster.samples);
    if (!output || !output->set_ioproxy(&memory) || !output->open("picture." + encoder, spec) ||
        !output->write_image(type, samples) || !output->close()) {
        return error(Kind::environment,
                     fmt::format("the picture cannot be encoded as {}: {}", encoder,
                                 output ? output->geterror() : OIIO::geterror()));
    }
    return bytes;
}

}  // namespace balcony::images
