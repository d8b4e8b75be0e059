// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The channels of an EXR file of a film.

#include <cstddef>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>

#include "balcony/base.hpp"
#include "balcony/film.hpp"

namespace balcony::render {

/// Some channels of the file, whose values are computed together.
struct ChannelGroup {
    std::vector<std::string> names;
    void (*read)(const Film& film, std::size_t x, std::size_t y, float* channels);
};

/// The picture, its part that is not light, and the layers.
[[nodiscard]] std::vector<ChannelGroup> channel_groups(const Film& film);

/// The header of a file with scan lines whose data window is a region of the picture.
[[nodiscard]] Imf::Header exr_header(const Film& film, const Region& window,
                                     const std::vector<ChannelGroup>& groups);

/// Why OpenEXR could not make a file.
[[nodiscard]] Diagnostic exr_failure(const std::filesystem::path& file,
                                     const std::exception& failed);

/// The values of a region, pixel by pixel, in memory that is used again.
class ChannelValues {
public:
    explicit ChannelValues(const std::vector<ChannelGroup>& groups);

    /// How many rows of a width to read at once: from 1 to 64, of at most 64 MiB if there are more.
    [[nodiscard]] std::size_t rows_at_once(std::size_t width) const;
    /// A buffer for OpenEXR, valid until the next call. NaN becomes 0.
    [[nodiscard]] Imf::FrameBuffer read(const Film& film, const Region& region);

private:
    const std::vector<ChannelGroup>* groups_;
    std::size_t channels_ = 0;
    std::vector<float> values_;
};

}  // namespace balcony::render
