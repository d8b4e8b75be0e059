// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "data/npy_array.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace balcony::data {

namespace {

constexpr std::string_view magic = "\x93NUMPY";

std::size_t byte_at(std::string_view bytes, std::size_t i) {
    return static_cast<unsigned char>(bytes[i]);
}

/// The header, a Python dictionary, and the bytes after it.
struct NpyParts {
    std::string_view header;
    std::string_view numbers;
};

std::optional<NpyParts> parts_of(std::string_view bytes) {
    constexpr std::size_t fixed = 10;
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
    return length <= bytes.size() - begin
               ? std::optional(NpyParts{bytes.substr(begin, length), bytes.substr(begin + length)})
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

Result<NpyArray> NpyArray::read(std::string_view bytes, const std::string& name) {
    const std::optional<NpyParts> parts = parts_of(bytes);
    if (!parts) {
        return corrupt(name);
    }
    const std::string_view type = quoted_text(value_of(parts->header, "descr"));
    const auto shape = numbers_in(value_of(parts->header, "shape"));
    const std::string_view fortran = value_of(parts->header, "fortran_order");
    if (!shape || fortran.empty()) {
        return corrupt(name);
    }
    if (type.size() != 3 || std::string_view("<>=").find(type[0]) == type.npos || type[1] != 'f' ||
        (type[2] != '4' && type[2] != '8')) {
        return error(fmt::format("the numbers of '{}' are not floats of 4 or 8 bytes", name), {},
                     "convert the array with .astype(\"f8\") before numpy.save");
    }
    if (shape->size() != 3) {
        return error(
            fmt::format("the array in '{}' has the shape ({})", name, fmt::join(*shape, ", ")), {},
            "give it the shape (height, width, columns)");
    }
    NpyArray made;
    made.numbers_ = parts->numbers;
    made.size_ = type[2] == '4' ? 4 : 8;
    made.swapped_ =
        type[0] != '=' && (type[0] == '<') != (std::endian::native == std::endian::little);
    std::copy(shape->begin(), shape->end(), made.shape_.begin());
    // The product may exceed any number.
    std::size_t left = made.numbers_.size() / made.size_;
    for (const std::size_t length : made.shape_) {
        left = length == 0 ? 0 : left / length;
    }
    if (left == 0) {
        return error(fmt::format("'{}' ends before its {} x {} x {} numbers do", name,
                                 made.shape_[0], made.shape_[1], made.shape_[2]),
                     {}, "write it again with numpy.save");
    }
    const auto [rows, columns, depth] = made.shape_;
    made.stride_ = fortran.starts_with("True")
                       ? std::array<std::size_t, 3>{1, rows, rows * columns}
                       : std::array<std::size_t, 3>{columns * depth, depth, 1};
    return made;
}

double NpyArray::operator()(std::size_t i, std::size_t j, std::size_t k) const {
    const std::size_t at = (i * stride_[0] + j * stride_[1] + k * stride_[2]) * size_;
    std::array<char, 8> bytes{};
    std::copy_n(numbers_.begin() + static_cast<std::ptrdiff_t>(at), size_, bytes.begin());
    if (swapped_) {
        std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size_));
    }
    if (size_ == sizeof(float)) {
        float number = 0.0F;
        std::memcpy(&number, bytes.data(), sizeof number);
        return double{number};
    }
    return std::bit_cast<double>(bytes);
}

}  // namespace balcony::data
