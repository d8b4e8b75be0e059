// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/images.hpp"

namespace balcony::images {

/// What OpenImageIO does for this layer. Its functions are those of images.hpp.
class ImageLibrary {
public:
    ImageLibrary() = default;
    ImageLibrary(const ImageLibrary&) = delete;
    ImageLibrary& operator=(const ImageLibrary&) = delete;
    virtual ~ImageLibrary() = default;

    [[nodiscard]] virtual Result<std::unique_ptr<ImageFile>> open(const std::filesystem::path& file,
                                                                  ImageChannels channels) const = 0;
    [[nodiscard]] virtual Result<std::unique_ptr<ImageFile>> open(
        const std::filesystem::path& name, std::span<const std::uint8_t> bytes,
        ImageChannels channels) const = 0;
    [[nodiscard]] virtual Result<std::vector<std::uint8_t>> encode(
        const Raster& raster, std::string_view format) const = 0;
    [[nodiscard]] virtual std::unique_ptr<FilteredImage> filter(const LinearImage& image,
                                                                bool closes) const = 0;
};

/// The library, or why there is none. Every program has one of two definitions: linked_library.cpp,
/// or loaded_library.cpp, which loads a module at the first call.
[[nodiscard]] const Result<const ImageLibrary*>& image_library();

}  // namespace balcony::images
