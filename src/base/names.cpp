// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/names.hpp"

#include <utility>

#include <fmt/format.h>

#include "balcony/base.hpp"

namespace balcony {

namespace {

std::string listed(const std::vector<std::string>& names, std::string_view last_join) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        text += i == 0 ? "" : i + 1 == names.size() ? last_join : ", ";
        text += "'" + names[i] + "'";
    }
    return text;
}

}  // namespace

std::string one_of(const std::vector<std::string>& names) { return listed(names, " or "); }
std::string all_of(const std::vector<std::string>& names) { return listed(names, " and "); }

std::string counted(std::size_t count, std::string_view noun) {
    const bool sibilant = noun.ends_with('s') || noun.ends_with('x') || noun.ends_with("sh");
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : sibilant ? "es" : "s");
}

std::string did_you_mean(std::string_view name, const std::vector<std::string>& known,
                         std::string otherwise) {
    const auto nearest = nearest_name(name, known);
    return nearest ? "did you mean '" + *nearest + "'?" : std::move(otherwise);
}

std::string suggestion(std::string_view name, const std::vector<std::string>& known,
                       std::string_view otherwise) {
    constexpr std::size_t max_listed = 40;
    return did_you_mean(name, known,
                        known.empty() || known.size() > max_listed
                            ? std::string()
                            : std::string(otherwise) + " " + all_of(known));
}

}  // namespace balcony
