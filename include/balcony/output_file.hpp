// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A file that is written under a temporary name and renamed when it is complete.

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>

#include "balcony/base.hpp"

namespace balcony {

/// The extension of a file name in lower case, with the dot: by it, a file has its format.
[[nodiscard]] std::string ending_of(const std::filesystem::path& file);

class OutputFile {
public:
    /// The reason why a file cannot be written there, if known in advance.
    [[nodiscard]] static Diagnostics check(const std::filesystem::path& file);

    /// Opens a new file next to it, with a name that no other writer has, in any process, container
    /// or machine; good() of the stream tells whether this succeeded. Removes what writers of the
    /// file have left that were killed.
    explicit OutputFile(const std::filesystem::path& file);
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;
    /// Removes the file if it was not committed.
    ~OutputFile();

    [[nodiscard]] std::ofstream& stream() { return stream_; }

    /// The file's temporary name, for another program that writes it.
    [[nodiscard]] const std::filesystem::path& beside() const { return beside_; }

    /// Renames the file if all writes succeeded; otherwise an error. An existing
    /// file's permissions are kept; a file that is not writable or not regular is not replaced.
    [[nodiscard]] Diagnostics commit();

    /// The diagnostic of a failed write, with the system's reason.
    [[nodiscard]] Diagnostic failure() const;

private:
    std::filesystem::path file_;
    std::filesystem::path beside_;
    int lock_ = -1;  ///< A descriptor of the new file, which tells others that it is in use.
    std::ofstream stream_;
    int reason_ = 0;
};

/// Renames a complete file so that it replaces another one, as OutputFile::commit() does.
[[nodiscard]] Diagnostics move_into_place(const std::filesystem::path& complete,
                                          const std::filesystem::path& file);

/// The file itself where its name is a link.
[[nodiscard]] std::filesystem::path resolved(const std::filesystem::path& file);

/// Writes a complete file or none; if it fails, an existing file is unchanged.
[[nodiscard]] Diagnostics write_whole(const std::filesystem::path& file, std::string_view bytes);
[[nodiscard]] Diagnostics write_whole(const std::filesystem::path& file,
                                      std::span<const std::uint8_t> bytes);

}  // namespace balcony
