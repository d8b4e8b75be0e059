// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A file that is written beside its place and moved there when it is whole.

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string_view>

#include "balcony/base.hpp"

namespace balcony {

class OutputFile {
public:
    /// Why a file could not be written there, if it is plain already.
    [[nodiscard]] static Diagnostics check(const std::filesystem::path& file);

    /// Opens a new file beside, of a name that no other writer has, in whichever process, container
    /// or machine; good() of the stream says whether that worked.
    explicit OutputFile(const std::filesystem::path& file);
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;
    /// Removes what was not committed.
    ~OutputFile();

    [[nodiscard]] std::ofstream& stream() { return stream_; }

    /// Moves the file to its place if all that was written arrived; an error otherwise. An older
    /// file passes its permissions on; one that may not be written, or what is no file, stays.
    [[nodiscard]] Diagnostics commit();

    /// What is said when writing fails, with the system's reason.
    [[nodiscard]] Diagnostic failure() const;

private:
    std::filesystem::path file_;
    std::filesystem::path beside_;
    std::ofstream stream_;
    int reason_ = 0;
};

/// Writes a file whole or not at all; an older file of that name stays as it was if it fails.
[[nodiscard]] Diagnostics write_whole(const std::filesystem::path& file, std::string_view bytes);
[[nodiscard]] Diagnostics write_whole(const std::filesystem::path& file,
                                      std::span<const std::uint8_t> bytes);

}  // namespace balcony
