// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The camera file that all pages edit: one text, with versions, and its file.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "balcony/base.hpp"

namespace balcony::studio {

class SharedText {
public:
    /// The text of a file, or another one if there is no such file yet.
    [[nodiscard]] static Result<SharedText> open(const std::filesystem::path& file,
                                                 const std::string& otherwise);

    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    [[nodiscard]] const std::string& text() const { return text_; }
    [[nodiscard]] int version() const { return version_; }
    /// The version that the file has; none if there is no file, or if the text was replaced.
    [[nodiscard]] std::optional<int> saved_version() const { return saved_version_; }

    /// Replaces the text if this is the version after the last one; otherwise it was made of an
    /// older text. False if it was.
    [[nodiscard]] bool take(int version, std::string text);

    /// Whether somebody else has written the file, or made it, since it was read or saved.
    [[nodiscard]] bool has_changed_on_disk() const;
    /// Writes the file, as a whole or not at all.
    [[nodiscard]] Diagnostics save();

private:
    SharedText() = default;

    std::filesystem::path file_;
    std::string text_;
    int version_ = 1;
    std::optional<int> saved_version_;
    std::optional<std::string> on_disk_;  ///< The bytes of the file as far as they are known.
};

}  // namespace balcony::studio
