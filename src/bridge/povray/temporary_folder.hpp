// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

namespace balcony::bridge::povray {

/// A new folder for files of this process alone, removed in the end.
class TemporaryFolder {
public:
    /// In TMPDIR, or in /tmp if POV-Ray could not read the name of that. Nothing if it cannot be
    /// made.
    [[nodiscard]] static std::optional<TemporaryFolder> make();
    TemporaryFolder(TemporaryFolder&& other) noexcept;
    TemporaryFolder& operator=(TemporaryFolder&&) = delete;
    ~TemporaryFolder();

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    explicit TemporaryFolder(std::filesystem::path path) : path_(std::move(path)) {}

    std::filesystem::path path_;
};

}  // namespace balcony::bridge::povray
