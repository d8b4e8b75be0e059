// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "balcony/checkpoint.hpp"

namespace balcony::render {

namespace {

std::optional<std::string_view> find(const RenderFacts& facts, std::string_view name) {
    const auto found = std::find_if(facts.begin(), facts.end(),
                                    [&](const RenderFact& fact) { return fact.name == name; });
    return found != facts.end() ? std::optional<std::string_view>(found->value) : std::nullopt;
}

}  // namespace

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
