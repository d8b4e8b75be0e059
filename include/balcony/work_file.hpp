// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "balcony/base.hpp"

namespace balcony {

/// A file beside an output that later runs find by its name, such as an unfinished picture. It is
/// open for reading and writing, and locked while it is open, so that two processes do not write
/// the same one. Links are not followed, and pipes and devices are not opened.
class WorkFile {
public:
    /// Opens an empty file. A file that is there is removed and not written to, since it may have
    /// other names. Fails with Kind::environment, and with Kind::usage if another process has it
    /// open.
    [[nodiscard]] static Result<WorkFile> create(const std::filesystem::path& file);
    /// Opens a file with its contents; fails as create() does, and if there is none.
    [[nodiscard]] static Result<WorkFile> reopen(const std::filesystem::path& file);

    WorkFile(WorkFile&& other) noexcept;
    WorkFile& operator=(WorkFile&& other) noexcept;
    /// Closes the file and leaves it where it is.
    ~WorkFile();

    [[nodiscard]] int descriptor() const { return descriptor_; }

private:
    explicit WorkFile(int descriptor) : descriptor_(descriptor) {}

    int descriptor_ = -1;
};

/// The error that something stands where a file would be written, and is no regular file.
[[nodiscard]] Diagnostic not_regular(const std::filesystem::path& file);

}  // namespace balcony
