// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include <OpenImageIO/filesystem.h>

namespace balcony::scene {

/// What the header of an image declares.
struct DeclaredSize {
    std::size_t width = 0;
    std::size_t height = 0;
};

/// A format of images that is opened.
struct ImageFormat {
    const char* reader;               ///< OpenImageIO's name.
    std::size_t max_pixels_per_byte;  ///< The most that the format packs into one; 0 is no bound.
    bool (*matches)(const std::string& start, const std::string& ending);
    /// The size by the header alone, for formats whose reader reserves memory as it opens the file;
    /// {} for a header that is none. Null where opening is cheap whatever the header declares.
    std::optional<DeclaredSize> (*declared_size)(OIIO::Filesystem::IOProxy& bytes);
    /// Whether the file ends where it should. Null where the reader reports this without printing.
    bool (*is_whole)(OIIO::Filesystem::IOProxy& bytes);
};

/// The format that the first bytes tell; null if it is none that is opened.
[[nodiscard]] const ImageFormat* image_format(OIIO::Filesystem::IOProxy& bytes,
                                              const std::filesystem::path& name);

}  // namespace balcony::scene
