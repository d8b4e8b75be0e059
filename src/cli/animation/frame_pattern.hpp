// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "cli/animation/frame_numbers.hpp"

namespace balcony::cli {

/// The name of a file with a place for the number of a frame: "frame.####.png", where each # is a
/// digit, or "frame.%04d.png". Longer numbers take more room.
class FramePattern {
public:
    /// Nothing if the name of the file (not of its folder) has no such place.
    [[nodiscard]] static std::optional<FramePattern> read(const std::string& text);

    [[nodiscard]] std::filesystem::path file(std::size_t frame) const;
    /// The number of the frame whose file has this name, without its folder.
    [[nodiscard]] std::optional<std::size_t> number_of_file(std::string_view name) const;
    /// The frames whose files exist.
    [[nodiscard]] FrameNumbers existing() const;

    [[nodiscard]] std::size_t digits() const { return digits_; }
    /// With #, whichever way it was written.
    [[nodiscard]] std::string text() const;
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

private:
    std::filesystem::path folder_;  ///< Empty for the current one.
    std::string before_, after_;
    std::size_t digits_ = 1;
};

}  // namespace balcony::cli
