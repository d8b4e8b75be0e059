// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/images.hpp"

#include "images/image_library.hpp"

namespace balcony::images {

Result<std::unique_ptr<ImageFile>> ImageFile::open(const std::filesystem::path& file,
                                                   ImageChannels channels) {
    const auto& library = image_library();
    return library ? (*library)->open(file, channels) : library.diagnostics;
}

Result<std::unique_ptr<ImageFile>> ImageFile::open(const std::filesystem::path& name,
                                                   std::span<const std::uint8_t> bytes,
                                                   ImageChannels channels) {
    const auto& library = image_library();
    return library ? (*library)->open(name, bytes, channels) : library.diagnostics;
}

Result<std::vector<std::uint8_t>> encode(const Raster& raster, std::string_view format) {
    const auto& library = image_library();
    return library ? (*library)->encode(raster, format) : library.diagnostics;
}

Result<std::unique_ptr<FilteredImage>> FilteredImage::make(const LinearImage& image, bool closes) {
    const auto& library = image_library();
    if (!library) {
        return library.diagnostics;
    }
    return (*library)->filter(image, closes);
}

Diagnostics require() { return image_library().diagnostics; }

}  // namespace balcony::images
