// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>

#include <Imath/ImathColor.h>

#include "balcony/base.hpp"
#include "balcony/images.hpp"

namespace balcony::bridge::povray {

/// A picture by POV-Ray as linear light: PNG in sRGB, or EXR.
class LightFile {
public:
    /// It must have the size.
    [[nodiscard]] static Result<LightFile> open(const std::filesystem::path& file,
                                                std::size_t width, std::size_t height);

    /// Reads rows in their order, premultiplied by alpha.
    [[nodiscard]] Diagnostics read_rows(std::size_t begin, std::span<Imath::Color4f> light);

private:
    explicit LightFile(std::unique_ptr<images::ImageFile> image) : image_(std::move(image)) {}

    std::unique_ptr<images::ImageFile> image_;
};

}  // namespace balcony::bridge::povray
