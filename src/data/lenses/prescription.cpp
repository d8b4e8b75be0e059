// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Prescriptions: which reader, and what all of them share.

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "balcony/input_file.hpp"
#include "balcony/names.hpp"
#include "data/files.hpp"
#include "data/lenses/lens_file.hpp"

namespace balcony::data {

namespace {

constexpr std::size_t max_surfaces = 200;
constexpr std::size_t max_errors = 10;

// Zemax writes UTF-16. All that means something is in ASCII.
std::optional<std::string> from_utf16(const std::string& bytes) {
    if (!bytes.starts_with("\xFF\xFE")) {
        return std::nullopt;
    }
    std::string text;
    for (std::size_t i = 2; i + 1 < bytes.size(); i += 2) {
        const bool ascii = bytes[i + 1] == '\0' && static_cast<unsigned char>(bytes[i]) < 0x80U;
        text += ascii && bytes[i] != '\0' ? bytes[i] : '?';
    }
    return text;
}

Result<std::shared_ptr<const SourceText>> source_of(const File& file) {
    const Result<std::string> bytes = read_bytes(file, max_prescription);
    if (!bytes) {
        return bytes.diagnostics;
    }
    if (auto text = from_utf16(*bytes)) {
        return std::make_shared<const SourceText>(file.name, *std::move(text));
    }
    return read_text(file, max_prescription, "export the lens as text");
}

}  // namespace

std::vector<LensLine> lens_lines(const std::shared_ptr<const SourceText>& source, char comment) {
    constexpr std::string_view blanks = " \t,;";
    const std::string_view text = source->text();
    std::vector<LensLine> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t line_end = std::min(text.find_first_of("\n\r", begin), text.size());
        std::size_t end = line_end;
        if (comment != '\0') {
            end = std::min(text.find(comment, begin), line_end);
        }
        LensLine words;
        for (std::size_t at = begin; at < end;) {
            const std::size_t first = text.find_first_not_of(blanks, at);
            if (first >= end) {
                break;
            }
            const std::size_t last = std::min(text.find_first_of(blanks, first), end);
            words.push_back({text.substr(first, last - first), {source, first, last}});
            at = last;
        }
        if (!words.empty()) {
            lines.push_back(std::move(words));
        }
        begin = line_end + 1;
    }
    return lines;
}

SourceSpan span_of(const LensLine& line) { return join(line.front().span, line.back().span); }

std::optional<double> lens_number(const LensWord& word, Diagnostics& found) {
    std::string_view text = word.text;
    text.remove_prefix(text.starts_with('+') ? 1 : 0);
    double value = 0.0;
    const auto [stop, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (status != std::errc() || stop != text.data() + text.size() || !std::isfinite(value)) {
        found.push_back(
            error("this is not a number", word.span, "write one such as -14.5 or 2e-5"));
        return std::nullopt;
    }
    return value;
}

std::optional<double> lens_unit(const LensWord& word, Diagnostics& found) {
    struct Unit {
        std::string_view name;
        double millimetres;
    };
    static constexpr std::array units{Unit{"mm", 1.0},       Unit{"cm", 10.0}, Unit{"m", 1000.0},
                                      Unit{"meter", 1000.0}, Unit{"in", 25.4}, Unit{"inch", 25.4}};
    std::string name(word.text);
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (const Unit& unit : units) {
        if (unit.name == name) {
            return unit.millimetres;
        }
    }
    found.push_back(error(fmt::format("there is no unit '{}'", printable(word.text)), word.span,
                          "write mm, cm, m or in"));
    return std::nullopt;
}

Diagnostic unknown_glass(const LensWord& name, std::vector<std::string> known) {
    const std::vector<std::string> built_in = camera::glass_names();
    known.insert(known.end(), built_in.begin(), built_in.end());
    return error(fmt::format("there is no glass '{}'", printable(name.text)), name.span,
                 did_you_mean(name.text, known,
                              "write its index and Abbe number instead, such as 1.67/47.1"));
}

Result<std::shared_ptr<const camera::Prescription>> read_prescription(const File& file) {
    const auto source = source_of(file);
    if (!source) {
        return source.diagnostics;
    }
    Diagnostics found;
    camera::Prescription lens = extension_of(file.path) == ".zmx" ? read_zemax(*source, found)
                                                                  : read_lens_table(*source, found);
    lens.name = file.name;
    if (found.empty() && lens.surfaces.empty()) {
        found.push_back(error(fmt::format("'{}' has no surfaces", file.name), {},
                              "write one a line: radius, gap, medium behind it, diameter"));
    } else if (lens.surfaces.size() > max_surfaces) {
        found.push_back(
            error(fmt::format("'{}' has more than {} surfaces", file.name, max_surfaces), {},
                  "check that it is the right file"));
    } else if (!has_errors(found)) {
        const Diagnostics faults = camera::check(lens);
        found.insert(found.end(), faults.begin(), faults.end());
    }
    if (has_errors(found)) {
        found.resize(std::min(found.size(), max_errors));
        return found;
    }
    return {std::make_shared<const camera::Prescription>(std::move(lens)), std::move(found)};
}

}  // namespace balcony::data
