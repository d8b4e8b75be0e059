// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "studio/session/command_line.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "balcony/picture_options.hpp"

namespace balcony::studio {

namespace {

// As a shell of POSIX reads it as one word.
std::string quoted(const std::string& word) {
    constexpr std::string_view plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./:=,+%@";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) {
        return word;
    }
    std::string inside;
    for (const char c : word) {
        inside += c == '\'' ? std::string_view("'\\''") : std::string_view(&c, 1);
    }
    return fmt::format("'{}'", inside);
}

// An option with its value.
void leave_out(std::string_view option, std::vector<std::string>& words) {
    const auto given = std::find(words.begin(), words.end(), option);
    words.erase(given, given == words.end() ? given : given + 2);
}

}  // namespace

std::string command_line(const Options& options, const live::Shown& shown,
                         const std::vector<lang::OpenParameter>& parameters) {
    const std::string file = options.file.string();
    std::vector<std::string> words{
        "balcony", "render", options.request.scene, "--camera",
        shown.camera.empty() ? file : fmt::format("{}:{}", file, shown.camera)};
    for (const live::Value& value : shown.values) {
        const auto known = std::find_if(parameters.begin(), parameters.end(), [&](const auto& one) {
            return one.name == value.parameter;
        });
        const bool is_angle = known != parameters.end() && known->is_angle;
        words.insert(words.end(), {"--set", fmt::format("{}={}", value.parameter,
                                                        lang::literal(value.value, is_angle))});
    }
    words.insert(words.end(), {"--size", fmt::format("{}x{}", shown.size[0], shown.size[1])});
    words.insert(words.end(), options.words.begin(), options.words.end());
    if (shown.time != options.request.settings.time) {
        leave_out("--time", words);
        words.insert(words.end(), {"--time", fmt::format("{}", shown.time)});
    }
    // Of one eye, there is nothing to say about the other.
    const auto of_stereo = app::stereo_options();
    for (const app::OptionInfo& row : of_stereo.rows) {
        if (!shown.stereo || row.name == "--stereo") {
            leave_out(row.name, words);
        }
    }
    if (shown.stereo) {
        words.insert(words.end(),
                     {"--stereo", std::string(camera::stereo_formats()[*shown.stereo].name)});
    }
    const bool is_placed = options.request.placement.fit.value_or(false);
    if (is_placed && std::find(words.begin(), words.end(), "--fit") == words.end()) {
        words.emplace_back("--fit");
    }
    words.insert(words.end(), {"-o", options.file.filename().replace_extension(".png").string()});
    std::transform(words.begin(), words.end(), words.begin(), quoted);
    return fmt::format("{}", fmt::join(words, " "));
}

}  // namespace balcony::studio
