// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Files with sums of films: checkpoints and shards. The format is that of this machine and this
// version: numbers as they are in memory, lists and texts with their sizes before them. A hash of
// everything before it ends the heading, and another one the file.
//
//     signature | field | ... | hash | array | ... | hash

#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "balcony/checkpoint.hpp"
#include "balcony/content_hash.hpp"
#include "balcony/input_file.hpp"
#include "balcony/work_file.hpp"

namespace balcony::render {

namespace fs = std::filesystem;

// The first line of a file of this kind by this version.
[[nodiscard]] inline std::string signature_of(std::string_view kind) {
    return fmt::format("Balcony {} {}\n", kind, BALCONY_VERSION);
}

// Why a file is not one of this kind.
[[nodiscard]] inline std::string damaged(std::string_view kind) {
    return fmt::format("it is damaged or no {}", kind);
}

// What is written as it is in memory: numbers, structures of them, and Imath's vectors.
template <class T>
concept PlainField = std::is_trivially_copyable_v<T> || requires {
    typename T::BaseType;
};

// A file that becomes visible when it is complete. Its temporary name is always the same, so that
// a process that is killed leaves one such file at most.
class SealedWriter {
public:
    // `kind` is for messages: "checkpoint".
    SealedWriter(std::string_view kind, const fs::path& file)
        : kind_(kind),
          file_(file),
          fresh_(file.string() + ".new"),
          output_(WorkFile::create(fresh_)) {
        write(std::as_bytes(std::span<const char>(signature_of(kind))));
    }
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

    // The members of a heading, as SealedReader::read_fields() reads them.
    template <class... Fields>
    void write_fields(const std::tuple<Fields&...>& members) {
        std::apply([this](const auto&... values) { (this->write_field(values), ...); }, members);
    }
    // The end of the heading.
    void seal() {
        const std::uint64_t hash = hash_.value();
        write(std::as_bytes(std::span(&hash, 1)));
    }

    // Seals the file. It is on the disk before it is renamed, so that a power failure leaves a
    // complete one.
    [[nodiscard]] Diagnostics commit() {
        if (!output_) {
            return output_.diagnostics;
        }
        seal();
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
    template <class T>
    void write_field(const T& value) {
        if constexpr (requires {
                          *value;
                          value.has_value();
                      }) {
            write_field(value.has_value());
            if (value) {
                write_field(*value);
            }
        } else if constexpr (std::is_same_v<T, bool>) {
            write_field(static_cast<std::uint8_t>(value ? 1 : 0));
        } else if constexpr (std::is_same_v<T, fs::path>) {
            write_field(value.string());
        } else if constexpr (std::is_same_v<T, std::string>) {
            write_part(std::as_bytes(std::span(value)));
        } else if constexpr (std::is_same_v<T, RenderFact>) {
            write_fields(std::tie(value.name, value.value));
        } else if constexpr (PlainField<T>) {
            write(std::as_bytes(std::span(&value, 1)));
        } else {
            write_field(std::uint64_t{value.size()});
            for (const auto& element : value) {
                write_field(element);
            }
        }
    }
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
    // Passes over bytes. False if the file is shorter; the seal at its end is not known any more.
    [[nodiscard]] bool pass_over(std::uintmax_t bytes) {
        if (bytes > rest_) {
            return false;
        }
        rest_ -= bytes;
        stream_.seekg(static_cast<std::streamoff>(bytes), std::ios::cur);
        return stream_.good();
    }
    // Whether no more than the seal is left.
    [[nodiscard]] bool is_at_seal() const { return rest_ == sizeof(std::uint64_t); }
    // Whether the file begins with a signature of this kind; otherwise why not.
    [[nodiscard]] std::optional<std::string> begins_otherwise(std::string_view kind) {
        const std::string expected = signature_of(kind);
        const std::size_t named = expected.rfind(' ') + 1;
        std::string found(std::min<std::uintmax_t>(expected.size(), rest_), '\0');
        if (!read(std::as_writable_bytes(std::span(found))) ||
            found.compare(0, named, expected, 0, named) != 0) {
            return damaged(kind);
        }
        return found == expected
                   ? std::nullopt
                   : std::optional(fmt::format("it is by another version of Balcony than {}",
                                               BALCONY_VERSION));
    }
    // False if the file is shorter.
    template <class... Fields>
    [[nodiscard]] bool read_fields(const std::tuple<Fields&...>& members) {
        return std::apply([this](auto&... values) { return (this->read_field(values) && ...); },
                          members);
    }
    // Whether what was read so far is what was written. Fuzzers take any hash for the right one.
    [[nodiscard]] bool is_sealed() {
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
        constexpr bool any_hash = true;
#else
        constexpr bool any_hash = false;
#endif
        const std::uint64_t expected = hash_.value();
        std::uint64_t found = 0;
        return read(std::as_writable_bytes(std::span(&found, 1))) &&
               (any_hash || found == expected);
    }
    // The same for the end of the file.
    [[nodiscard]] bool ends_sealed() { return is_sealed() && rest_ == 0; }
    // The size of the next part; nothing if the file is shorter.
    [[nodiscard]] std::optional<std::uint64_t> read_size() {
        std::uint64_t size = 0;
        const bool complete = read(std::as_writable_bytes(std::span(&size, 1)));
        return complete && size <= rest_ ? std::optional(size) : std::nullopt;
    }

private:
    template <class T>
    [[nodiscard]] bool read_field(T& value) {
        if constexpr (requires {
                          value.emplace();
                          value.has_value();
                      }) {
            bool is_there = false;
            return read_field(is_there) && (!is_there || read_field(value.emplace()));
        } else if constexpr (std::is_same_v<T, bool>) {
            std::uint8_t byte = 0;
            const bool complete = read_field(byte);
            value = byte != 0;
            return complete;
        } else if constexpr (std::is_same_v<T, fs::path>) {
            std::string text;
            const bool complete = read_field(text);
            value = std::move(text);
            return complete;
        } else if constexpr (std::is_same_v<T, std::string>) {
            const auto size = read_size();
            value.resize(size.value_or(0));
            return size && read(std::as_writable_bytes(std::span(value)));
        } else if constexpr (std::is_same_v<T, RenderFact>) {
            return read_fields(std::tie(value.name, value.value));
        } else if constexpr (PlainField<T>) {
            return read(std::as_writable_bytes(std::span(&value, 1)));
        } else {
            std::uint64_t count = 0;
            bool complete = read_field(count) && count <= rest_;
            for (std::uint64_t i = 0; i < count && complete; ++i) {
                complete = read_field(value.emplace_back());
            }
            return complete;
        }
    }

    std::ifstream stream_;
    std::uintmax_t rest_ = 0;
    ContentHash hash_;
};

}  // namespace balcony::render
