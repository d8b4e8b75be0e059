// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "common/output_file.hpp"

#include <fstream>
#include <system_error>

#include <fmt/format.h>

#include <unistd.h>

namespace balcony::plates {

std::optional<Diagnostic> write_whole(const std::filesystem::path& file,
                                      const std::vector<std::uint8_t>& bytes) {
    std::filesystem::path beside = file;
    beside += fmt::format(".{}.part", ::getpid());
    std::ofstream stream(beside, std::ios::binary);
    stream.write(reinterpret_cast<const char*>(bytes.data()),
                 static_cast<std::streamsize>(bytes.size()));
    stream.close();
    std::error_code failure;
    if (stream) {
        std::filesystem::rename(beside, file, failure);
    }
    if (!stream || failure) {
        std::error_code ignored;
        std::filesystem::remove(beside, ignored);
        return error(fmt::format("cannot write '{}'", file.string()), {},
                     "check that the folder exists, that it may be written to and that the disk "
                     "is not full");
    }
    return std::nullopt;
}

}  // namespace balcony::plates
