// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "balcony/base.hpp"

namespace balcony::render {

/// Intel Open Image Denoise (openimagedenoise.org), found and loaded at run time.
class ImageDenoiseLibrary {
public:
    /// The library in a file, or under one of its usual names if the file is empty; nothing if
    /// there is none.
    [[nodiscard]] static std::optional<ImageDenoiseLibrary> load(const std::filesystem::path& file);

    [[nodiscard]] const std::string& name() const { return name_; }

    /// Filters a picture of any brightness, with its features without noise. All images have three
    /// floats per pixel. What the library reports is an error.
    [[nodiscard]] Diagnostics filter(std::size_t width, std::size_t height,
                                     std::vector<float>& color, std::vector<float>& albedo,
                                     std::vector<float>& normal) const;

private:
    struct Functions;
    std::shared_ptr<const Functions> functions_;
    std::string name_;
};

}  // namespace balcony::render
