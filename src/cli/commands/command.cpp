// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/commands/command.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "cli/report/usage.hpp"

namespace balcony::cli {

const app::OptionInfo* Command::row_of(const CLI::Option* option) const {
    const auto found = std::find(parsed_.begin(), parsed_.end(), option);
    return found != parsed_.end() ? &rows_[static_cast<std::size_t>(found - parsed_.begin())]
                                  : nullptr;
}

void Command::add_row(const app::OptionInfo& info) {
    rows_.push_back(info);
    const std::string names = info.letter.empty() ? info.name : info.letter + "," + info.name;
    if (info.type == app::OptionType::flag) {
        parsed_.push_back(add_flag(names, flags_.emplace_back(false), info.meaning));
        return;
    }
    CLI::Option* option = nullptr;
    const auto added = [&]<class Words>(Words) {
        return add_option_function<Words>(
            names, [](const Words&) {}, info.meaning);
    };
    if (!info.repeated) {
        option = added(std::string());
    } else {
        option = info.words == 2 ? added(std::vector<std::pair<std::string, std::string>>())
                                 : added(std::vector<std::string>());
        option->take_all();
        if (info.name.starts_with('-')) {
            option->allow_extra_args(false);
        }
    }
    option->type_name(info.placeholder);
    option->required(info.required);
    option->default_str(info.fallback);
    parsed_.push_back(option);
}

void Command::show_first(const std::vector<std::string>& names) {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (std::find(names.begin(), names.end(), rows_[i].name) == names.end() &&
            rows_[i].name.starts_with('-')) {
            parsed_[i]->group(std::string(more_options));
        }
    }
}

Result<std::vector<std::string>> Command::in_own_words(
    const std::vector<std::string>& words) const {
    std::vector<std::string> made;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string name = words[i].substr(0, words[i].find('='));
        const std::optional<OtherName> other =
            name.starts_with("--") ? find_other(name) : std::nullopt;
        if (!other) {
            made.push_back(words[i]);
            continue;
        }
        if (!other->is_taken) {
            return error(
                Kind::usage, fmt::format("balcony {} has no option '{}'", get_name(), name),
                fmt::format("did you mean '{}', {}?", other->row->name, other->row->meaning));
        }
        made.push_back(other->row->name);
        const bool has_word = words[i].size() > name.size();
        std::string value = other->value;
        const std::size_t place = value.find("{}");
        if (place != std::string::npos) {
            const std::string word = has_word               ? words[i].substr(name.size() + 1)
                                     : i + 1 < words.size() ? words[++i]
                                                            : "";
            value.replace(place, 2, word);
        } else if (has_word) {
            value = words[i].substr(name.size() + 1);
        }
        if (!value.empty()) {
            made.push_back(std::move(value));
        }
    }
    return made;
}

std::optional<Command::OtherName> Command::find_other(std::string_view name) const {
    if (get_option_no_throw(std::string(name)) != nullptr) {
        return std::nullopt;
    }
    for (const app::OptionInfo& row : rows_) {
        for (const std::string_view other : row.others) {
            const std::size_t end = std::min(other.find_first_of("=?"), other.size());
            if (other.substr(0, end) == name) {
                return OtherName{&row, std::string(other.substr(std::min(end + 1, other.size()))),
                                 !other.ends_with('?')};
            }
        }
    }
    return std::nullopt;
}

app::GivenWords Command::given() const {
    app::GivenWords words;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const bool is_flag = rows_[i].type == app::OptionType::flag;
        if (parsed_[i]->count() > 0 && (!is_flag || parsed_[i]->as<bool>())) {
            words[rows_[i].name] = parsed_[i]->reduced_results();
        }
    }
    return words;
}

// The last word of an option counts, but what it names is not given up silently.
Diagnostics Command::check_words() const {
    const auto names_something = [](const app::OptionInfo& info) {
        using enum app::OptionType;
        return !info.repeated && (info.type == camera || info.type == scene || info.type == file ||
                                  info.type == folder);
    };
    Diagnostics found;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const app::OptionInfo& row = rows_[i];
        const std::vector<std::string>& words = parsed_[i]->results();
        if (words.empty()) {
            continue;
        }
        if (names_something(row) && words.front() != words.back()) {
            found.push_back(error(Kind::usage,
                                  fmt::format("{} is given twice: '{}' and '{}'", row.name,
                                              words.front(), words.back()),
                                  "leave one out"));
        }
    }
    return found;
}

Diagnostics Command::read() const {
    Diagnostics found = check_words();
    if (has_errors(found)) {
        return found;
    }
    const app::GivenWords words = given();
    for (const auto& reader : readers_) {
        reader(words, found);
    }
    return found;
}

}  // namespace balcony::cli
