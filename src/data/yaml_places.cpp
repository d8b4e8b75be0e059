// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "data/yaml_places.hpp"

#include <algorithm>

namespace balcony::data {

// The library counts lines from 0.
SourceSpan place_of(const std::shared_ptr<const SourceText>& source, const YAML::Mark& mark,
                    std::size_t length) {
    if (mark.is_null() || mark.line < 0 || mark.column < 0) {
        return {source, 0, 0};
    }
    const std::string_view text = source->text();
    const auto number = std::min(static_cast<std::size_t>(mark.line) + 1, source->line_count());
    const std::string_view line = source->line(number);
    const auto begin = static_cast<std::size_t>(line.data() - text.data()) +
                       std::min(static_cast<std::size_t>(mark.column), line.size());
    return {source, begin, std::min(begin + length, text.size())};
}

SourceSpan place_of(const std::shared_ptr<const SourceText>& source, const YAML::Node& node) {
    return place_of(source, node.Mark(),
                    node.IsScalar() ? std::max<std::size_t>(node.Scalar().size(), 1) : 1);
}

}  // namespace balcony::data
