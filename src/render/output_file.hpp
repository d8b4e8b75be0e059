// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A file that is written beside its place and moved there when it is whole.

#include <filesystem>
#include <fstream>
#include <optional>

#include "balcony/base.hpp"

namespace balcony::render {

class OutputFile {
public:
    /// Why a file could not be written there, if it is plain already.
    [[nodiscard]] static Diagnostics check(const std::filesystem::path& file);

    /// Opens the file beside; good() says whether that worked.
    explicit OutputFile(const std::filesystem::path& file);
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;
    /// Removes what was not committed.
    ~OutputFile();

    [[nodiscard]] std::ofstream& stream() { return stream_; }

    /// Moves the file to its place if all that was written arrived; an error otherwise.
    [[nodiscard]] Diagnostics commit();

    /// What is said when writing fails, with the system's reason.
    [[nodiscard]] Diagnostic failure() const;

private:
    std::filesystem::path file_;
    std::filesystem::path beside_;
    std::ofstream stream_;
    int reason_ = 0;
};

}  // namespace balcony::render
