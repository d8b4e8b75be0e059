// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "film/files/render_facts.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace balcony::render {

std::string text_of(const RenderFacts& facts) {
    std::string text;
    for (const RenderFact& fact : facts) {
        text += fact.name + '\0' + fact.value + '\0';
    }
    return text;
}

RenderFacts facts_of(std::string_view text) {
    std::vector<std::string> words;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\0'), text.size());
        words.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    RenderFacts facts;
    for (std::size_t i = 0; i + 1 < words.size(); i += 2) {
        facts.push_back({words[i], words[i + 1]});
    }
    return facts;
}

std::optional<std::string_view> find(const RenderFacts& facts, std::string_view name) {
    const auto found = std::find_if(facts.begin(), facts.end(),
                                    [&](const RenderFact& fact) { return fact.name == name; });
    return found != facts.end() ? std::optional<std::string_view>(found->value) : std::nullopt;
}

std::string difference(const RenderFacts& before, const RenderFacts& now) {
    std::vector<std::string> found;
    for (const RenderFact& fact : now) {
        const auto value = find(before, fact.name);
        if (!value) {
            found.push_back(fmt::format("{} is new", fact.name));
        } else if (*value != fact.value && fact.value.starts_with('#')) {
            found.push_back(fmt::format("{} has changed", fact.name));
        } else if (*value != fact.value) {
            found.push_back(fmt::format("{} was '{}' and is '{}'", fact.name, *value, fact.value));
        }
    }
    for (const RenderFact& fact : before) {
        if (!find(now, fact.name)) {
            found.push_back(fmt::format("{} is missing", fact.name));
        }
    }
    return fmt::format("{}", fmt::join(found, "; "));
}

}  // namespace balcony::render
