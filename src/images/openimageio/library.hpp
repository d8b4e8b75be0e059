// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "images/image_library.hpp"

namespace balcony::images {

/// The library by calls of OpenImageIO, all of which are in this folder: image_file.cpp opens,
/// encode.cpp encodes and filtered_image.cpp filters.
class OpenImageIo final : public ImageLibrary {
public:
    [[nodiscard]] Result<std::unique_ptr<ImageFile>> open(const std::filesystem::path& file,
                                                          ImageChannels channels) const override;
    [[nodiscard]] Result<std::unique_ptr<ImageFile>> open(const std::filesystem::path& name,
                                                          std::span<const std::uint8_t> bytes,
                                                          ImageChannels channels) const override;
    [[nodiscard]] Result<std::vector<std::uint8_t>> encode(const Raster& raster,
                                                           std::string_view format) const override;
    [[nodiscard]] std::unique_ptr<FilteredImage> filter(const LinearImage& image,
                                                        bool closes) const override;
};

}  // namespace balcony::images
