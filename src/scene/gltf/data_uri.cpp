// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scene/gltf/data_uri.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include <fmt/format.h>

#include "scene/part_error.hpp"

namespace balcony::scene {

namespace {

// The value of each character as a digit of base 64, or no_digit.
constexpr std::uint8_t no_digit = 64;
constexpr std::array<std::uint8_t, 256> base64_digits = [] {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::array<std::uint8_t, 256> values{};
    values.fill(no_digit);
    for (std::size_t i = 0; i < digits.size(); ++i) {
        values[static_cast<unsigned char>(digits[i])] = static_cast<std::uint8_t>(i);
    }
    return values;
}();

std::uint32_t digit_of(char letter) { return base64_digits[static_cast<unsigned char>(letter)]; }

// Four digits are three bytes. The last ones, which may be fewer, count as if zeros followed.
std::vector<std::uint8_t> decode_base64(std::string_view digits) {
    std::vector<std::uint8_t> bytes((digits.size() + 3) / 4 * 3);
    std::uint32_t all = 0;
    const auto decode = [&all](const char* four, std::uint8_t* three) {
        const std::uint32_t a = digit_of(four[0]);
        const std::uint32_t b = digit_of(four[1]);
        const std::uint32_t c = digit_of(four[2]);
        const std::uint32_t d = digit_of(four[3]);
        all |= a | b | c | d;
        const std::uint32_t bits = a << 18U | b << 12U | c << 6U | d;
        three[0] = static_cast<std::uint8_t>(bits >> 16U);
        three[1] = static_cast<std::uint8_t>(bits >> 8U);
        three[2] = static_cast<std::uint8_t>(bits);
    };
    const std::size_t whole = digits.size() / 4;
    for (std::size_t i = 0; i < whole; ++i) {
        decode(digits.data() + 4 * i, bytes.data() + 3 * i);
    }
    if (const std::string_view rest = digits.substr(4 * whole); !rest.empty()) {
        std::array<char, 4> last{'A', 'A', 'A', 'A'};
        std::copy(rest.begin(), rest.end(), last.begin());
        decode(last.data(), bytes.data() + 3 * whole);
        bytes.resize(3 * whole + rest.size() * 3 / 4);
    }
    if ((all & no_digit) != 0) {
        throw PartError{"its data URI is not in base 64"};
    }
    return bytes;
}

// How the names of lifted URIs begin: with a character that JSON does not have in any text but as
// an escape sequence.
constexpr std::string_view name_in_json = R"(data:\u0001)";
constexpr std::string_view name_in_text = "data:\x01";

}  // namespace

std::vector<std::uint8_t> decode_data_uri(std::string_view uri) {
    constexpr std::string_view marker = ";base64,";
    const std::size_t at = uri.substr(0, 256).find(marker);
    if (!uri.starts_with("data:") || at == std::string_view::npos) {
        throw PartError{"its data URI is not in base 64"};
    }
    const std::string_view digits = uri.substr(at + marker.size());
    return decode_base64(digits.substr(0, digits.find('=')));
}

// A quotation mark that begins or ends a text follows an even number of backslashes; what follows
// one that ends a text is no letter, in JSON without mistakes.
std::string LiftedDataUris::lift(std::string_view json) {
    constexpr std::size_t long_enough = 4096;
    constexpr std::string_view beginning = R"("data:)";
    std::string text;
    uris_.clear();
    for (std::size_t quote = json.find(beginning); quote != std::string_view::npos;
         quote = json.find(beginning)) {
        const std::size_t begin = quote + 1;
        const std::size_t end = std::min(json.find('"', begin), json.size());
        const std::string_view uri = json.substr(begin, end - begin);
        const bool escaped = quote > 0 && json[quote - 1] == '\\';
        const bool lifted = !escaped && uri.size() >= long_enough && end < json.size() &&
                            uri.find('\\') == std::string_view::npos;
        text += json.substr(0, begin);
        if (lifted) {
            text += fmt::format("{}{}", name_in_json, uris_.size());
            uris_.push_back(uri);
        }
        json.remove_prefix(lifted ? end : begin);
    }
    text += json;
    return text;
}

std::string_view LiftedDataUris::original(std::string_view uri) const {
    if (!uri.starts_with(name_in_text)) {
        return uri;
    }
    std::size_t index = uris_.size();
    std::from_chars(uri.data() + name_in_text.size(), uri.data() + uri.size(), index);
    return index < uris_.size() ? uris_[index] : uri;
}

}  // namespace balcony::scene
