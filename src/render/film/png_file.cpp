// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/png_file.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "balcony/output_file.hpp"

namespace balcony::render {

namespace {

bool encode(const void* samples, OIIO::TypeDesc type, const PngSize& size,
            std::vector<unsigned char>& bytes) {
    OIIO::ImageSpec spec(static_cast<int>(size.width), static_cast<int>(size.height),
                         static_cast<int>(size.channels), type);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("oiio:UnassociatedAlpha", 1);
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create("png");
    return output && output->set_ioproxy(&memory) && output->open("picture.png", spec) &&
           output->write_image(type, samples) && output->close();
}

Diagnostics write(const void* samples, OIIO::TypeDesc type, const PngSize& size,
                  const std::filesystem::path& file) {
    // Encoded in memory first, so that only one call can fail to write.
    std::vector<unsigned char> bytes;
    if (!encode(samples, type, size, bytes)) {
        return {error(fmt::format("'{}' cannot be written: {}", file.string(), OIIO::geterror()))};
    }
    return write_whole(file, bytes);
}

}  // namespace

Diagnostics write_png(const std::vector<std::uint8_t>& samples, const PngSize& size,
                      const std::filesystem::path& file) {
    return write(samples.data(), OIIO::TypeDesc::UINT8, size, file);
}

Diagnostics write_png(const std::vector<std::uint16_t>& samples, const PngSize& size,
                      const std::filesystem::path& file) {
    return write(samples.data(), OIIO::TypeDesc::UINT16, size, file);
}

}  // namespace balcony::render
