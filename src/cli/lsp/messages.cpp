// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/lsp/messages.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdio>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace balcony::cli {

namespace {

constexpr std::size_t longest_header = 4096;

// A line without its end; nothing at the end of the stream or if it is too long.
std::optional<std::string> read_line(std::istream& stream) {
    std::string line;
    for (int c = stream.get(); c != std::istream::traits_type::eof(); c = stream.get()) {
        if (c == '\n') {
            if (line.ends_with('\r')) {
                line.pop_back();
            }
            return line;
        }
        if (line.size() == longest_header) {
            return std::nullopt;
        }
        line += static_cast<char>(c);
    }
    return std::nullopt;
}

// Of Content-Length: 123; nothing for another field.
std::optional<std::string_view> value_of_length(std::string_view line) {
    constexpr std::string_view name = "content-length:";
    const bool is_length =
        line.size() > name.size() &&
        std::equal(name.begin(), name.end(), line.begin(), [](char expected, char c) {
            return expected == std::tolower(static_cast<unsigned char>(c));
        });
    if (!is_length) {
        return std::nullopt;
    }
    line.remove_prefix(name.size());
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    return line;
}

// istream::ignore() waits for the byte behind.
void skip(std::istream& stream, std::size_t count) {
    std::array<char, 65536> buffer{};
    while (count > 0 && stream) {
        const std::size_t part = std::min(count, buffer.size());
        stream.read(buffer.data(), static_cast<std::streamsize>(part));
        count -= part;
    }
}

}  // namespace

std::variant<std::string, NoMessage> read_message(std::istream& stream) {
    std::optional<std::size_t> length;
    if (stream.peek() == std::istream::traits_type::eof()) {
        return NoMessage::end;
    }
    for (;;) {
        const std::optional<std::string> line = read_line(stream);
        if (!line) {
            return NoMessage::bad_header;
        }
        if (line->empty()) {
            break;
        }
        if (const auto digits = value_of_length(*line)) {
            std::size_t value = 0;
            const char* const end = digits->data() + digits->size();
            const auto [rest, failure] = std::from_chars(digits->data(), end, value);
            if (failure != std::errc() || rest != end) {
                return NoMessage::bad_header;
            }
            length = value;
        }
    }
    if (!length) {
        return NoMessage::bad_header;
    }
    if (*length > lsp::longest_message) {
        skip(stream, *length);
        return NoMessage::too_long;
    }
    std::string text(*length, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    return static_cast<std::size_t>(stream.gcount()) == text.size()
               ? std::variant<std::string, NoMessage>(std::move(text))
               : NoMessage::end;
}

nlohmann::json refusal_of(NoMessage why) {
    const lsp::Refusal refusal =
        why == NoMessage::too_long
            ? lsp::Refusal{lsp::invalid_request,
                           fmt::format("a message is longer than {} bytes", lsp::longest_message)}
            : lsp::Refusal{lsp::parse_error,
                           "a header is wrong: a message begins with Content-Length: and its "
                           "length in bytes"};
    return lsp::error_of(nullptr, refusal);
}

void MessageWriter::write(const nlohmann::json& message) {
    const std::string text = lsp::text_of(message);
    const std::string whole = fmt::format("Content-Length: {}\r\n\r\n{}", text.size(), text);
    const std::lock_guard lock(mutex_);
    std::fwrite(whole.data(), 1, whole.size(), stdout);
    std::fflush(stdout);
}

}  // namespace balcony::cli
