// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/npy.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace balcony {

namespace {

constexpr std::string_view magic = "\x93NUMPY";

std::size_t byte_at(std::string_view bytes, std::size_t i) {
    return static_cast<unsigned char>(bytes[i]);
}

constexpr std::size_t fixed = 10;  // Bytes before the dictionary, in version 1.

/// The part of the header that is a Python dictionary.
std::optional<std::string_view> dictionary_of(std::string_view bytes) {
    if (bytes.size() < fixed) {
        return std::nullopt;
    }
    // Version 1 has two bytes for the length of the header, later ones four.
    const std::size_t version = byte_at(bytes, magic.size());
    const std::size_t begin = version == 1 ? fixed : fixed + 2;
    if (version < 1 || version > 3 || bytes.size() < begin) {
        return std::nullopt;
    }
    std::size_t length = 0;
    for (std::size_t i = begin; i-- > fixed - 2;) {
        length = length << 8U | byte_at(bytes, i);
    }
    return length <= bytes.size() - begin ? std::optional(bytes.substr(begin, length))
                                          : std::nullopt;
}

// The text after 'key': without blanks in front; empty if there is no such key.
std::string_view value_of(std::string_view header, std::string_view key) {
    for (const char quote : {'\'', '"'}) {
        const std::string quoted = fmt::format("{}{}{}", quote, key, quote);
        const std::size_t found = header.find(quoted);
        if (found != header.npos) {
            std::string_view rest = header.substr(found + quoted.size());
            rest.remove_prefix(std::min(rest.find_first_not_of(" :"), rest.size()));
            return rest;
        }
    }
    return {};
}

// Of '<f8' the text <f8; empty if it is not a text in quotation marks.
std::string_view quoted_text(std::string_view value) {
    if (value.empty() || (value.front() != '\'' && value.front() != '"')) {
        return {};
    }
    const std::size_t end = value.find(value.front(), 1);
    return end == value.npos ? std::string_view() : value.substr(1, end - 1);
}

// Of (2, 3) the numbers; nothing if it is not a tuple of numbers.
std::optional<std::vector<std::size_t>> numbers_in(std::string_view tuple) {
    const std::size_t end = tuple.find(')');
    if (!tuple.starts_with('(') || end == tuple.npos) {
        return std::nullopt;
    }
    std::vector<std::size_t> numbers;
    tuple = tuple.substr(1, end - 1);
    while (true) {
        tuple.remove_prefix(std::min(tuple.find_first_not_of(" ,"), tuple.size()));
        if (tuple.empty()) {
            return numbers;
        }
        std::size_t number = 0;
        const auto [read_to, failed] =
            std::from_chars(tuple.data(), tuple.data() + tuple.size(), number);
        if (failed != std::errc()) {
            return std::nullopt;
        }
        numbers.push_back(number);
        tuple.remove_prefix(static_cast<std::size_t>(read_to - tuple.data()));
    }
}

Diagnostic corrupt(const std::string& name) {
    return error(fmt::format("'{}' is truncated or no array of NumPy", name), {},
                 "write it again with numpy.save");
}

}  // namespace

bool is_npy(std::string_view bytes) { return bytes.starts_with(magic); }

Result<NpyHeader> NpyHeader::read(std::string_view bytes, const std::string& name) {
    const auto dictionary = is_npy(bytes) ? dictionary_of(bytes) : std::nullopt;
    if (!dictionary) {
        return corrupt(name);
    }
    const std::string_view type = quoted_text(value_of(*dictionary, "descr"));
    const auto shape = numbers_in(value_of(*dictionary, "shape"));
    const std::string_view fortran = value_of(*dictionary, "fortran_order");
    if (!shape || fortran.empty()) {
        return corrupt(name);
    }
    if (type.size() != 3 || std::string_view("<>=").find(type[0]) == type.npos || type[1] != 'f' ||
        (type[2] != '4' && type[2] != '8')) {
        return error(fmt::format("the numbers of '{}' are not floats of 4 or 8 bytes", name), {},
                     "convert the array with .astype(\"f8\") before numpy.save");
    }
    NpyHeader made;
    made.shape = *shape;
    made.size = static_cast<std::size_t>(dictionary->end() - bytes.begin());
    made.number_size = type[2] == '4' ? 4 : 8;
    made.swapped =
        type[0] != '=' && (type[0] == '<') != (std::endian::native == std::endian::little);
    made.by_columns = fortran.starts_with("True");
    return made;
}

double NpyHeader::number_at(const char* bytes) const {
    std::array<char, 8> own{};
    std::copy_n(bytes, number_size, own.begin());
    if (swapped) {
        std::reverse(own.begin(), own.begin() + static_cast<std::ptrdiff_t>(number_size));
    }
    if (number_size == sizeof(float)) {
        float number = 0.0F;
        std::memcpy(&number, own.data(), sizeof number);
        return double{number};
    }
    return std::bit_cast<double>(own);
}

// Version 1 of the format: a magic text, the length of the dictionary, and the dictionary, which
// ends at a multiple of 64 bytes.
std::string npy_header(std::span<const std::size_t> shape, std::size_t number_size,
                       std::size_t least, char kind) {
    constexpr std::size_t alignment = 64;
    std::string text = fmt::format("{{'descr': '{}{}{}', 'fortran_order': False, 'shape': ({}), }}",
                                   std::endian::native == std::endian::little ? '<' : '>', kind,
                                   number_size, fmt::join(shape, ", "));
    const std::size_t end =
        std::max((fixed + text.size() + 1 + alignment - 1) / alignment * alignment, least);
    text.resize(end - fixed - 1, ' ');
    text += '\n';
    const auto length = static_cast<unsigned>(text.size());
    return fmt::format("{}\x01{}{}{}{}", magic, '\0', static_cast<char>(length & 0xffU),
                       static_cast<char>(length >> 8U), text);
}

}  // namespace balcony
