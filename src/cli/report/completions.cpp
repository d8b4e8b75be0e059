// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/report/completions.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "balcony/catalogue.hpp"
#include "balcony/inputs.hpp"
#include "balcony/lang.hpp"
#include "cli/commands/command.hpp"

namespace balcony::cli {

namespace {

namespace fs = std::filesystem;

/// The command line before the word to complete.
struct Before {
    const Command& command;
    std::span<const std::string> words;
};

/// Collects the words that begin like the one to complete.
class Candidates {
public:
    explicit Candidates(std::string prefix) : prefix_(std::move(prefix)) {}

    [[nodiscard]] const std::string& prefix() const { return prefix_; }

    // One word a line: names that would control the terminal or break the line are left out.
    void add(std::string_view word, std::string_view meaning = {}) {
        if (word.starts_with(prefix_) && printable(word) == word) {
            text_ += fmt::format("{}{}\t{}\n", front_, word, printable(meaning));
        }
    }

    /// Text in front of every word that is added later.
    void put_in_front(std::string text) { front_ = std::move(text); }

    std::string take() { return std::move(text_); }

private:
    std::string prefix_;
    std::string front_;
    std::string text_;
};

// Files for which the test holds, and folders.
template <class Test>
void add_files(Candidates& words, const Test& is_wanted) {
    const std::string& prefix = words.prefix();
    const std::size_t cut = prefix.rfind('/') == std::string::npos ? 0 : prefix.rfind('/') + 1;
    const std::string folder = prefix.substr(0, cut);
    const char* const home = std::getenv("HOME");
    const std::string place = folder.empty() ? "."
                              : folder.starts_with("~/") && home != nullptr
                                  ? home + folder.substr(1)
                                  : folder;
    std::vector<std::string> found;
    std::error_code failed;
    for (fs::directory_iterator entry(place, failed), end; !failed && entry != end;
         entry.increment(failed)) {
        const std::string name = entry->path().filename().string();
        const bool hidden = name.starts_with('.') && prefix.size() == cut;
        std::error_code ignored;
        if (!hidden && entry->is_directory(ignored)) {
            found.push_back(folder + name + "/");
        } else if (!hidden && is_wanted(name)) {
            found.push_back(folder + name);
        }
    }
    std::sort(found.begin(), found.end());
    for (const std::string& name : found) {
        words.add(name);
    }
}

void add_any_file(const Before&, Candidates& words) {
    add_files(words, [](const std::string&) { return true; });
}

void add_folders(const Before&, Candidates& words) {
    add_files(words, [](const std::string&) { return false; });
}

void add_scenes(const Before&, Candidates& words) { add_files(words, app::is_scene_file); }

void add_camera_files(const Before&, Candidates& words) {
    add_files(words, [](const std::string& name) { return name.ends_with(".cam"); });
}

// Built-in cameras, camera files, and the cameras in a file behind its colon.
void add_cameras(const Before& before, Candidates& words) {
    const std::size_t colon = words.prefix().find(".cam:");
    if (colon != std::string::npos) {
        const std::string file = words.prefix().substr(0, colon + 4);
        const auto cameras = lang::Workspace().describe(file);
        for (std::size_t i = 0; cameras && i < cameras->size(); ++i) {
            words.add(fmt::format("{}:{}", file, (*cameras)[i].name),
                      (*cameras)[i].is_picture ? "picture" : "camera");
        }
        return;
    }
    for (const std::string& name : lang::built_in_cameras()) {
        words.add(name, "built-in camera");
    }
    add_camera_files(before, words);
}

const CLI::Option* option_named(const CLI::App& command, const std::string& word) {
    const CLI::Option* option = word.starts_with('-') ? command.get_option_no_throw(word) : nullptr;
    return option != nullptr && option->get_items_expected_max() > 0 ? option : nullptr;
}

// The camera of the command line: the value of --camera, or else the argument.
std::optional<std::string> camera_in(const Before& before) {
    const CLI::Option* const camera = before.command.get_option_no_throw("--camera");
    std::optional<std::string> argument;
    for (std::size_t i = 0; i < before.words.size(); ++i) {
        if (const CLI::Option* option = option_named(before.command, before.words[i])) {
            ++i;
            if (option == camera && i < before.words.size()) {
                return before.words[i];
            }
        } else if (!before.words[i].starts_with('-') && !argument) {
            argument = before.words[i];
        }
    }
    return camera == nullptr ? argument : std::nullopt;
}

void add_parameters(const Before& before, Candidates& words) {
    const auto camera = camera_in(before);
    const auto wanted =
        camera ? app::read_camera(*camera, {}) : Result<app::CameraArgument>(Diagnostics());
    const auto known = wanted ? lang::Workspace().describe(wanted->file)
                              : Result<std::vector<lang::Description>>(Diagnostics());
    for (std::size_t i = 0; known && i < known->size(); ++i) {
        const lang::Description& one = (*known)[i];
        if (wanted->name.empty() ? i + 1 == known->size() : one.name == wanted->name) {
            for (const auto& parameter : one.parameters) {
                words.add(
                    parameter.name + "=",
                    fmt::format("default {}{}{}", parameter.default_text,
                                parameter.limits_text.empty() ? "" : ", ", parameter.limits_text));
            }
        }
    }
}

void add_what_is_listed(const Before& before, Candidates& words) {
    for (const char* word : {"stages", "cameras", "options"}) {
        words.add(word);
    }
    for (const camera::StageEntry& row : camera::catalogue()) {
        words.add(row.name, name_of(row.kind));
    }
    add_cameras(before, words);
}

// By the row of an option or argument. Numbers and the like have none.
void add_values(const CLI::Option& option, const Before& before, Candidates& words) {
    const app::OptionInfo* const row = before.command.row_of(&option);
    if (row == nullptr) {
        return;
    }
    for (const app::OptionChoice& one : row->choices) {
        words.add(one.name, one.meaning);
    }
    switch (row->type) {
        case app::OptionType::file: return add_any_file(before, words);
        case app::OptionType::folder: return add_folders(before, words);
        case app::OptionType::scene: return add_scenes(before, words);
        case app::OptionType::camera: return add_cameras(before, words);
        case app::OptionType::setting: return add_parameters(before, words);
        default: break;
    }
    if (row->name == "WHAT") {
        add_what_is_listed(before, words);
    }
}

void add_options(const CLI::App& command, Candidates& words) {
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) {
            words.add("--" + name, option->get_description());
        }
        for (const std::string& name : option->get_snames()) {
            words.add("-" + name, option->get_description());
        }
    }
}

void add_commands(const CLI::App& app, Candidates& words) {
    for (const CLI::App* command : app.get_subcommands({})) {
        words.add(command->get_name(), command->get_description());
    }
}

void add_arguments(const Before& before, Candidates& words) {
    for (const CLI::Option* option : before.command.get_options()) {
        if (option->get_positional()) {
            add_values(*option, before, words);
        }
    }
}

std::string in_command(const Before& before, const std::string& word) {
    Candidates words(word);
    const std::size_t count = before.words.size();
    const CLI::Option* const option =
        count > 0 ? option_named(before.command, before.words.back()) : nullptr;
    if (option != nullptr) {
        add_values(*option, before, words);
    } else if (count > 1 && before.words[count - 2] == "--map") {
        add_any_file(before, words);
    } else if (const std::size_t equals = word.find('=');
               word.starts_with("--") && equals != std::string::npos) {
        const std::string name = word.substr(0, equals);
        if (const CLI::Option* written = option_named(before.command, name)) {
            words = Candidates(word.substr(equals + 1));
            words.put_in_front(name + "=");
            add_values(*written, before, words);
        }
    } else if (word.starts_with('-')) {
        add_options(before.command, words);
    } else {
        add_arguments(before, words);
    }
    return words.take();
}

}  // namespace

std::string completions(const CLI::App& app, std::span<const std::string> words) {
    const std::string word = words.empty() ? "" : words.back();
    const auto before = words.first(words.empty() ? 0 : words.size() - 1);
    if (before.empty() || before.front() == "help") {
        Candidates found(word);
        add_commands(app, found);
        add_options(app, found);
        return found.take();
    }
    const auto chosen = app.get_subcommands(
        [&](const CLI::App* command) { return command->get_name() == before.front(); });
    return chosen.empty()
               ? ""
               : in_command({static_cast<const Command&>(*chosen.front()), before.subspan(1)},
                            word);
}

}  // namespace balcony::cli
