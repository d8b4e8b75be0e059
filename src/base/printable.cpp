// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>

#include "balcony/base.hpp"
#include "base/utf8.hpp"

namespace balcony {

namespace {

struct CodePoint {
    std::size_t length = 0;  // In bytes; 0 for invalid UTF-8.
    char32_t value = 0;
};

CodePoint decode(std::string_view bytes) {
    const auto lead = static_cast<unsigned char>(bytes.front());
    if (lead < 0x80) {
        return {1, lead};
    }
    const std::size_t length = lead >> 5 == 6 ? 2 : lead >> 4 == 14 ? 3 : lead >> 3 == 30 ? 4 : 0;
    if (length == 0 || length > bytes.size()) {
        return {};
    }
    char32_t value = lead & (0x7fU >> length);
    for (const char byte : bytes.substr(1, length - 1)) {
        if (!continues_code_point(byte)) {
            return {};
        }
        value = value << 6 | (static_cast<unsigned char>(byte) & 0x3fU);
    }
    constexpr std::array<char32_t, 5> minimum = {0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = value >= 0xd800 && value < 0xe000;
    return value < minimum[length] || surrogate || value > 0x10ffff ? CodePoint{}
                                                                    : CodePoint{length, value};
}

struct CodeRange {
    char32_t first, last;
};

// Characters that control a terminal, or reorder or hide its text: control codes, and of Unicode's
// format characters (general category Cf) and separators (Zl, Zp) those that have no glyph of their
// own.
constexpr std::array<CodeRange, 13> unprintable{{
    {0x0000, 0x001f},    // C0 controls, escape among them
    {0x007f, 0x009f},    // delete, C1 controls
    {0x00ad, 0x00ad},    // soft hyphen
    {0x061c, 0x061c},    // Arabic letter mark
    {0x180e, 0x180e},    // Mongolian vowel separator
    {0x200b, 0x200f},    // zero-width space and joiners, marks of direction
    {0x2028, 0x202e},    // line and paragraph separators, embeddings and overrides of direction
    {0x2060, 0x206f},    // word joiner, invisible operators, isolates
    {0xfeff, 0xfeff},    // zero-width no-break space
    {0xfff9, 0xfffb},    // interlinear annotation
    {0x1bca0, 0x1bca3},  // shorthand format controls
    {0x1d173, 0x1d17a},  // musical format controls
    {0xe0000, 0xe007f},  // tags
}};

bool is_printable(char32_t code) {
    return std::none_of(unprintable.begin(), unprintable.end(), [code](const CodeRange& range) {
        return range.first <= code && code <= range.last;
    });
}

}  // namespace

std::string printable(std::string_view text, LineFeeds line_feeds) {
    std::string shown;
    while (!text.empty()) {
        const CodePoint code = decode(text);
        const std::size_t length = std::max<std::size_t>(code.length, 1);
        if (code.value == '\t' || (code.value == '\n' && line_feeds == LineFeeds::keep)) {
            shown += code.value == '\t' ? ' ' : '\n';
        } else if (code.length == 0 || !is_printable(code.value)) {
            shown += '?';
        } else {
            shown += text.substr(0, length);
        }
        text.remove_prefix(length);
    }
    return shown;
}

}  // namespace balcony
