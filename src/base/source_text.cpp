// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>

#include "balcony/base.hpp"
#include "balcony/input_file.hpp"
#include "base/utf8.hpp"

namespace balcony {

SourceText::SourceText(std::string name, std::string text)
    : name_(std::move(name)), text_(std::move(text)) {
    std::string_view begun = text_;
    if (!begin_text(begun, name_)) {
        text_.erase(0, text_.size() - begun.size());
    }
    line_begins_.push_back(0);
    for (std::size_t i = 0; i < text_.size(); ++i) {
        if (text_[i] == '\n') {
            line_begins_.push_back(i + 1);
        }
    }
}

LineColumn SourceText::locate(std::size_t offset) const {
    offset = std::min(offset, text_.size());
    const auto next = std::upper_bound(line_begins_.begin(), line_begins_.end(), offset);
    const auto line = static_cast<std::size_t>(next - line_begins_.begin());
    LineColumn place{line, 1};
    for (std::size_t i = line_begins_[line - 1]; i < offset; ++i) {
        place.column += continues_code_point(text_[i]) ? 0 : 1;
    }
    return place;
}

std::string_view SourceText::line(std::size_t number) const {
    assert(number >= 1 && number <= line_begins_.size());
    const std::size_t begin = line_begins_[number - 1];
    std::size_t end = number < line_begins_.size() ? line_begins_[number] - 1 : text_.size();
    if (end > begin && text_[end - 1] == '\r') {
        --end;
    }
    return std::string_view(text_).substr(begin, end - begin);
}

SourceSpan join(const SourceSpan& first, const SourceSpan& last) {
    assert(first.source == last.source);
    return {first.source, std::min(first.begin, last.begin), std::max(first.end, last.end)};
}

}  // namespace balcony
