// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "dataset/recipe/picture_entries.hpp"

#include <algorithm>
#include <optional>
#include <system_error>

#include <fmt/format.h>

#include "balcony/names.hpp"
#include "dataset/picture_facts.hpp"

namespace balcony::dataset {

namespace {

std::optional<std::string> word_of(const toml::node& node, const app::OptionInfo& row) {
    if (const auto text = node.value_exact<std::string>()) {
        return text;
    }
    if (const auto whole = node.value_exact<std::int64_t>()) {
        return fmt::format("{}", *whole);
    }
    if (const auto number = node.value_exact<double>()) {
        return fmt::format("{}", *number);
    }
    const toml::array* const list = node.as_array();
    if (list == nullptr) {
        return std::nullopt;
    }
    std::vector<std::string> parts;
    for (const toml::node& part : *list) {
        const auto word = part.is_array() ? std::nullopt : word_of(part, row);
        if (!word) {
            return std::nullopt;
        }
        parts.push_back(*word);
    }
    return app::word_of_parts(row, parts);
}

// The words of an option; nothing if it cannot have such a value.
std::optional<std::vector<std::string>> words_of(const toml::node& node,
                                                 const app::OptionInfo& row) {
    if (row.type == app::OptionType::flag) {
        const auto truth = node.value_exact<bool>();
        return !truth   ? std::nullopt
               : *truth ? std::optional(std::vector<std::string>{"true"})
                        : std::optional(std::vector<std::string>{});
    }
    std::vector<std::string> words;
    const toml::array* const list = row.repeated ? node.as_array() : nullptr;
    for (std::size_t i = 0; i < (list != nullptr ? list->size() : 1); ++i) {
        const auto word = word_of(list != nullptr ? *list->get(i) : node, row);
        if (!word) {
            return std::nullopt;
        }
        words.push_back(*word);
    }
    return words;
}

}  // namespace

std::string found_in(const std::filesystem::path& folder, const std::string& file) {
    std::error_code failed;
    const std::filesystem::path inside = folder / file;
    return !folder.empty() && std::filesystem::exists(inside, failed) ? inside.string() : file;
}

void read_picture(const toml::node& node, const RecipeText& text,
                  const std::filesystem::path& folder, app::Request& picture) {
    const toml::table* const table = node.as_table();
    if (table == nullptr) {
        text.add(node, "'render' is not a table", "write [render] and its options below it");
        return;
    }
    const app::Options<app::Request> known = frame_options();
    std::vector<std::string> names;
    for (const app::OptionInfo& row : known.rows) {
        names.push_back(row.name.substr(2));
    }
    app::GivenWords given;
    for (const auto& [key, value] : *table) {
        const std::string name = app::option_name(std::string(key.str()));
        const auto row = std::find_if(known.rows.begin(), known.rows.end(),
                                      [&](const auto& one) { return one.name == name; });
        if (row == known.rows.end()) {
            text.found.push_back(
                error(fmt::format("frames have no option '{}'", std::string(key.str())),
                      text.span_of(key.source()),
                      did_you_mean(name.substr(2), names,
                                   "docs/datasets.md says which options frames have")));
            continue;
        }
        auto words = words_of(value, *row);
        if (!words) {
            text.add(value, fmt::format("'{}' cannot have this value", name.substr(2)),
                     row->meaning);
            continue;
        }
        if (words->empty()) {
            continue;
        }
        if (row->name == "--environment" || row->type == app::OptionType::scene) {
            for (std::string& word : *words) {
                word = found_in(folder, word);
            }
        }
        // One by one, so that each mistake has its place.
        Diagnostics found;
        row->read(*words, picture, found);
        for (Diagnostic& one : found) {
            one.span = text.span_of(value.source());
            text.found.push_back(std::move(one));
        }
        given[row->name] = std::move(*words);
    }
    Diagnostics found;
    for (const auto& check : known.checks) {
        check(picture, given, found);
    }
    for (Diagnostic& one : found) {
        one.span = text.span_of(node.source());
        text.found.push_back(std::move(one));
    }
}

}  // namespace balcony::dataset
