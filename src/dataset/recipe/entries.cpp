// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "dataset/recipe/entries.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "balcony/names.hpp"

namespace balcony::dataset {

namespace {

// The offset in bytes of a column, which counts code points.
std::size_t offset_of(const SourceText& source, const toml::source_position& place) {
    const std::size_t line = std::clamp<std::size_t>(place.line, 1, source.line_count());
    const std::string_view text = source.line(line);
    std::size_t at = 0;
    for (std::size_t column = 1; column < place.column && at < text.size(); ++column) {
        ++at;
        while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U) {
            ++at;
        }
    }
    return static_cast<std::size_t>(text.data() - source.text().data()) + at;
}

}  // namespace

// A table of several lines is shown by its first one.
SourceSpan RecipeText::span_of(const toml::source_region& region) const {
    const std::size_t begin = offset_of(*source, region.begin);
    const bool has_end = region.end.line == region.begin.line;
    const std::size_t end = has_end ? offset_of(*source, region.end) : begin + 1;
    return {source, begin, std::max(end, begin + 1)};
}

void RecipeText::add(const toml::node& where, std::string message, std::string remedy) const {
    found.push_back(error(std::move(message), span_of(where.source()), std::move(remedy)));
}

Entries::~Entries() {
    for (const auto& [key, node] : table_) {
        const std::string name(key.str());
        if (std::find(asked_.begin(), asked_.end(), name) == asked_.end()) {
            text_.found.push_back(error(fmt::format("{} has no entry '{}'", what_, name),
                                        text_.span_of(key.source()),
                                        suggestion(name, asked_, "its entries are")));
        }
    }
}

const toml::node* Entries::find(std::string_view name) {
    asked_.emplace_back(name);
    return table_.get(name);
}

const toml::node* Entries::require(std::string_view name) {
    const toml::node* const node = find(name);
    if (node == nullptr) {
        text_.add(table_, fmt::format("{} needs the entry '{}'", what_, name));
    }
    return node;
}

std::optional<std::string> Entries::text(std::string_view name) {
    const toml::node* const node = find(name);
    if (node == nullptr) {
        return std::nullopt;
    }
    const std::optional<std::string> value = node->value_exact<std::string>();
    if (!value || value->empty()) {
        text_.add(*node, fmt::format("'{}' is not a text", name), "write it in quotes");
        return std::nullopt;
    }
    return value;
}

std::optional<bool> Entries::truth(std::string_view name) {
    const toml::node* const node = find(name);
    if (node == nullptr) {
        return std::nullopt;
    }
    const std::optional<bool> value = node->value_exact<bool>();
    if (!value) {
        text_.add(*node, fmt::format("'{}' is neither true nor false", name));
    }
    return value;
}

std::optional<double> Entries::number(std::string_view name, double least, double most) {
    const toml::node* const node = find(name);
    if (node == nullptr) {
        return std::nullopt;
    }
    const std::optional<double> value = node->value<double>();
    if (!node->is_number() || !value || !(*value >= least && *value <= most)) {
        text_.add(*node, fmt::format("'{}' is not a number from {} to {}", name, least, most));
        return std::nullopt;
    }
    return value;
}

std::optional<std::size_t> Entries::count(std::string_view name, std::size_t least,
                                          std::size_t most) {
    const toml::node* const node = find(name);
    if (node == nullptr) {
        return std::nullopt;
    }
    const std::optional<std::int64_t> value = node->value_exact<std::int64_t>();
    if (!value || *value < static_cast<std::int64_t>(least) ||
        *value > static_cast<std::int64_t>(most)) {
        text_.add(*node,
                  fmt::format("'{}' is not a whole number from {} to {}", name, least, most));
        return std::nullopt;
    }
    return static_cast<std::size_t>(*value);
}

std::optional<Imath::V3d> point_in(const toml::node& node, const RecipeText& text,
                                   std::string_view name) {
    const toml::array* const list = node.as_array();
    Imath::V3d made(0.0);
    bool is_point = list != nullptr && list->size() == 3;
    for (std::size_t i = 0; is_point && i < 3; ++i) {
        const toml::node& part = *list->get(i);
        const std::optional<double> value = part.value<double>();
        is_point = part.is_number() && value && std::isfinite(*value);
        made[static_cast<int>(i)] = value.value_or(0.0);
    }
    if (!is_point) {
        text.add(node, fmt::format("'{}' is not a point", name), "write [x, y, z]");
        return std::nullopt;
    }
    return made;
}

std::optional<Imath::V3d> Entries::point(std::string_view name) {
    const toml::node* const node = find(name);
    return node != nullptr ? point_in(*node, text_, name) : std::nullopt;
}

std::optional<std::vector<std::string>> Entries::texts(std::string_view name) {
    const toml::node* const node = find(name);
    if (node == nullptr) {
        return std::nullopt;
    }
    if (const auto one = node->value_exact<std::string>()) {
        return std::vector{*one};
    }
    std::vector<std::string> made;
    if (const toml::array* const list = node->as_array()) {
        for (const toml::node& part : *list) {
            if (const auto one = part.value_exact<std::string>()) {
                made.push_back(*one);
            } else {
                text_.add(part, fmt::format("'{}' lists what is not a text", name),
                          "write it in quotes");
            }
        }
    } else {
        text_.add(*node, fmt::format("'{}' is neither a text nor a list of texts", name));
    }
    return made;
}

}  // namespace balcony::dataset
