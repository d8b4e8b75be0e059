// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lsp/open_text.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace balcony::lsp {

using nlohmann::json;

namespace {

constexpr std::string_view file_scheme = "file://";

// How many code units of UTF-16 the character takes that begins with a byte of UTF-8; 0 for a byte
// inside of one.
std::size_t units_of(char byte) {
    const auto c = static_cast<unsigned char>(byte);
    return (c & 0xc0U) == 0x80U ? 0 : c >= 0xf0U ? 2 : 1;
}

std::size_t begin_of_line(std::string_view text, std::size_t line) {
    std::size_t begin = 0;
    for (std::size_t i = 0; i < line; ++i) {
        const std::size_t end = text.find('\n', begin);
        if (end == std::string_view::npos) {
            return text.size();
        }
        begin = end + 1;
    }
    return begin;
}

std::size_t offset_in(std::string_view text, const json& position) {
    const auto number = [&position](const char* name) {
        return static_cast<std::size_t>(std::max(0.0, position.at(name).get<double>()));
    };
    std::size_t offset = begin_of_line(text, number("line"));
    std::size_t left = number("character");
    while (offset < text.size() && text[offset] != '\n') {
        const std::size_t units = units_of(text[offset]);
        if (units > left || (left == 0 && units > 0)) {
            break;
        }
        left -= units;
        ++offset;
    }
    return offset;
}

}  // namespace

std::filesystem::path file_of(std::string_view uri) {
    if (!uri.starts_with(file_scheme)) {
        return {};
    }
    uri.remove_prefix(file_scheme.size());
    uri.remove_prefix(std::min(uri.find('/'), uri.size()));
    std::string path;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        unsigned value = 0;
        const char* const digits = uri.data() + i + 1;
        const bool is_code = uri[i] == '%' && i + 2 < uri.size() &&
                             std::from_chars(digits, digits + 2, value, 16).ptr == digits + 2;
        path += is_code ? static_cast<char>(value) : uri[i];
        i += is_code ? 2 : 0;
    }
    return path;
}

std::string uri_of(const std::filesystem::path& file) {
    std::string uri(file_scheme);
    std::error_code failure;
    for (const char c : std::filesystem::absolute(file, failure).lexically_normal().string()) {
        const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                              std::string_view("/-_.~").find(c) != std::string_view::npos;
        uri += is_plain
                   ? std::string(1, c)
                   : fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    }
    return uri;
}

json position_in(const SourceText& text, std::size_t offset) {
    const std::size_t line = text.locate(offset).line;
    const std::string_view written = text.line(line);
    const auto end = static_cast<std::size_t>(text.text().data() + offset - written.data());
    std::size_t units = 0;
    for (std::size_t i = 0; i < std::min(end, written.size()); ++i) {
        units += units_of(written[i]);
    }
    return {{"line", line - 1}, {"character", units}};
}

json range_in(const SourceText& text, std::size_t begin, std::size_t end) {
    return {{"start", position_in(text, begin)}, {"end", position_in(text, end)}};
}

OpenText::OpenText(std::string uri, std::string text, int version)
    : uri_(std::move(uri)), version_(version) {
    set(std::move(text));
}

void OpenText::set(std::string text) {
    const std::filesystem::path file = file_of(uri_);
    source_ =
        std::make_shared<const SourceText>(file.empty() ? uri_ : file.string(), std::move(text));
    known_.reset();
}

const lang::EditedText& OpenText::known() {
    if (!known_) {
        known_.emplace(source_, folder());
    }
    return *known_;
}

std::size_t OpenText::offset_of(const json& position) const {
    return offset_in(source_->text(), position);
}

void OpenText::change(const json& changes, int version) {
    std::string text(source_->text());
    for (const json& change : changes) {
        const auto& written = change.at("text").get_ref<const std::string&>();
        if (const auto range = change.find("range"); range != change.end()) {
            const std::size_t begin = offset_in(text, range->at("start"));
            const std::size_t end = std::max(begin, offset_in(text, range->at("end")));
            text.replace(begin, end - begin, written);
        } else {
            text = written;
        }
    }
    version_ = version;
    set(std::move(text));
}

}  // namespace balcony::lsp
