// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include <OpenImageIO/filesystem.h>

#include "images/image_checks.hpp"

namespace balcony::images {

/// An image format that OpenImageIO reads.
struct ImageFormat {
    const char* reader;               ///< OpenImageIO's name.
    std::size_t max_pixels_per_byte;  ///< The maximum compression of the format; 0 is no limit.
    bool (*matches)(const std::string& start, const std::string& ending);
    /// The size from the header, for formats whose reader allocates memory when it opens the file;
    /// {} for an invalid header. Null if opening is cheap for any header.
    std::optional<DeclaredSize> (*declared_size)(OIIO::Filesystem::IOProxy& bytes);
    /// Whether the file is complete and undamaged, as far as the reader does not report it without
    /// printing and without allocating what a few bytes claim. Null if it does.
    bool (*is_whole)(OIIO::Filesystem::IOProxy& bytes);
};

/// The format according to the first bytes; null if it is not supported.
[[nodiscard]] const ImageFormat* image_format(OIIO::Filesystem::IOProxy& bytes,
                                              const std::filesystem::path& name);

}  // namespace balcony::images
