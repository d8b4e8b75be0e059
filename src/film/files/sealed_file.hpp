// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Files with sums of films: checkpoints and shards. The format is that of this machine: numbers as
// they are in memory. All parts but the first are preceded by their sizes in bytes; the hash of
// everything before it is the end.
//
//     signature | facts | array | ... | hash

#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

#include "balcony/content_hash.hpp"
#include "balcony/input_file.hpp"
#include "balcony/work_file.hpp"
#include "film/files/render_facts.hpp"

namespace balcony::render {

namespace fs = std::filesystem;

// A file that becomes visible when it is complete. Its temporary name is always the same, so that
// a process that is killed leaves one such file at most.
class SealedWriter {
public:
    // `kind` is for messages: "checkpoint".
    SealedWriter(std::string_view kind, const fs::path& file)
        : kind_(kind),
          file_(file),
          fresh_(file.string() + ".new"),
          output_(WorkFile::create(fresh_)) {}
    SealedWriter(const SealedWriter&) = delete;
    SealedWriter& operator=(const SealedWriter&) = delete;
    ~SealedWriter() {
        if (output_ && !committed_) {
            ::unlink(fresh_.c_str());
        }
    }

    void write(std::span<const std::byte> bytes) {
        hash_.add(bytes);
        while (output_ && reason_ == 0 && !bytes.empty()) {
            const ssize_t written = ::write(output_->descriptor(), bytes.data(), bytes.size());
            if (written >= 0) {
                bytes = bytes.subspan(static_cast<std::size_t>(written));
            } else {
                note(errno == EINTR);
            }
        }
    }
    // A part with its size before it.
    void write_part(std::span<const std::byte> bytes) {
        const std::uint64_t size = bytes.size();
        write(std::as_bytes(std::span(&size, 1)));
        write(bytes);
    }

    // Adds the hash. The file is on the disk before it is renamed, so that a power failure leaves a
    // complete one.
    [[nodiscard]] Diagnostics commit() {
        if (!output_) {
            return output_.diagnostics;
        }
        const std::uint64_t hash = hash_.value();
        write(std::as_bytes(std::span(&hash, 1)));
        note(reason_ == 0 ? ::fsync(output_->descriptor()) == 0 : true);
        note(reason_ == 0 ? ::rename(fresh_.c_str(), file_.c_str()) == 0 : true);
        if (reason_ != 0) {
            return {error(Kind::environment,
                          fmt::format("the {} '{}' cannot be written: {}", kind_, file_.string(),
                                      std::generic_category().message(reason_)))};
        }
        committed_ = true;
        return {};
    }

private:
    void note(bool success) {
        if (!success && reason_ == 0) {
            reason_ = errno;
        }
    }

    std::string_view kind_;
    fs::path file_;
    fs::path fresh_;
    Result<WorkFile> output_;
    bool committed_ = false;
    int reason_ = 0;
    ContentHash hash_;
};

class SealedReader {
public:
    // Without a file there, it is like an empty one.
    explicit SealedReader(const fs::path& file) {
        if (!not_a_file(file, "")) {
            stream_.open(file, std::ios::binary);
            std::error_code failed;
            const std::uintmax_t size = fs::file_size(file, failed);
            rest_ = failed ? 0 : size;
        }
    }

    // The bytes that are left.
    [[nodiscard]] std::uintmax_t rest() const { return rest_; }
    // False if the file is shorter.
    [[nodiscard]] bool read(std::span<std::byte> bytes) {
        if (bytes.size() > rest_) {
            return false;
        }
        rest_ -= bytes.size();
        stream_.read(reinterpret_cast<char*>(bytes.data()),
                     static_cast<std::streamsize>(bytes.size()));
        hash_.add(bytes);
        return stream_.good();
    }
    // The signature and the facts after it; nothing if the file does not begin so.
    [[nodiscard]] std::optional<RenderFacts> read_beginning(std::string_view signature) {
        std::string beginning(signature.size(), '\0');
        if (!read(std::as_writable_bytes(std::span(beginning))) || beginning != signature) {
            return std::nullopt;
        }
        return read_facts();
    }
    // A part that holds facts.
    [[nodiscard]] std::optional<RenderFacts> read_facts() {
        const auto size = read_size();
        std::string text(size.value_or(0), '\0');
        if (!size || !read(std::as_writable_bytes(std::span(text)))) {
            return std::nullopt;
        }
        return facts_of(text);
    }
    // The size of the next part; nothing if the file is shorter.
    [[nodiscard]] std::optional<std::uint64_t> read_size() {
        std::uint64_t size = 0;
        const bool complete = read(std::as_writable_bytes(std::span(&size, 1)));
        return complete && size <= rest_ ? std::optional(size) : std::nullopt;
    }
    [[nodiscard]] bool ends_with_hash() {
        const std::uint64_t expected = hash_.value();
        std::uint64_t found = 0;
        return read(std::as_writable_bytes(std::span(&found, 1))) && found == expected &&
               rest_ == 0;
    }

private:
    std::ifstream stream_;
    std::uintmax_t rest_ = 0;
    ContentHash hash_;
};

}  // namespace balcony::render
