// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/commands/command.hpp"

#include <algorithm>

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

Diagnostics Command::read() const {
    Diagnostics found;
    const app::GivenWords words = given();
    for (const auto& reader : readers_) {
        reader(words, found);
    }
    return found;
}

}  // namespace balcony::cli
