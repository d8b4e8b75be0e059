// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/options/job_options.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "cli/options/option_values.hpp"

namespace balcony::cli {

namespace {

struct Unit {
    std::string_view name;
    double seconds;
};

constexpr std::array units{Unit{"", 1.0},         Unit{"s", 1.0},     Unit{"sec", 1.0},
                           Unit{"m", 60.0},       Unit{"min", 60.0},  Unit{"h", 3600.0},
                           Unit{"hours", 3600.0}, Unit{"d", 86400.0}, Unit{"days", 86400.0}};

// Options that change neither the light nor the layers of a picture.
constexpr std::array<std::string_view, 14> of_output = {"SCENE",
                                                        "--output",
                                                        "--help",
                                                        "--exposure",
                                                        "--view-transform",
                                                        "--time-limit",
                                                        "--save-every",
                                                        "--checkpoint-every",
                                                        "--resume",
                                                        "--threads",
                                                        "--quiet",
                                                        "--json",
                                                        "--watch",
                                                        "--denoise"};

std::optional<double> read_interval(std::string_view option, const std::string& text,
                                    Diagnostics& diagnostics) {
    if (text.empty() || text == "off") {
        return std::nullopt;
    }
    const auto seconds = duration_of(text);
    if (!seconds || *seconds <= 0.0) {
        refuse(diagnostics, option, text, "write a duration such as 30s, 10min or 1.5h");
        return std::nullopt;
    }
    return seconds;
}

}  // namespace

void add_job_options(CLI::App& command, JobWords& words) {
    command
        .add_option("--time-limit", words.time_limit,
                    "stop rendering after this time, with the samples that there are")
        ->type_name("DURATION");
    command
        .add_option("--save-every", words.save_every,
                    "save the whole picture so far at this interval, such as 30s or 10min")
        ->type_name("DURATION");
    command
        .add_option("--checkpoint-every", words.checkpoint_every,
                    "interval at which OUTPUT.checkpoint is written, from which --resume "
                    "continues after a crash; off for none")
        ->type_name("DURATION")
        ->capture_default_str();
    command.add_flag("--resume", words.resume,
                     "continue an interrupted render from its checkpoint, if there is one");
}

JobRequest read_job(const JobWords& words, Diagnostics& diagnostics) {
    return {read_interval("--time-limit", words.time_limit, diagnostics),
            read_interval("--save-every", words.save_every, diagnostics),
            read_interval("--checkpoint-every", words.checkpoint_every, diagnostics), words.resume};
}

render::RenderFacts option_facts(const CLI::App& command) {
    render::RenderFacts facts;
    for (const CLI::Option* option : command.get_options()) {
        const std::string name = option->get_name();
        if (std::find(of_output.begin(), of_output.end(), name) == of_output.end()) {
            const std::string value =
                option->count() > 0 ? fmt::format("{}", fmt::join(option->reduced_results(), " "))
                                    : option->get_default_str();
            facts.push_back({name, value});
        }
    }
    return facts;
}

std::optional<double> duration_of(std::string_view text) {
    double total = 0.0;
    bool any = false;
    while (!text.empty()) {
        const std::size_t unit_begin = std::min(text.find_first_not_of("0123456789."), text.size());
        const auto number = number_of<double>(text.substr(0, unit_begin));
        text.remove_prefix(unit_begin);
        const std::size_t unit_end = std::min(text.find_first_of("0123456789."), text.size());
        const auto* const unit = std::find_if(units.begin(), units.end(), [&](const Unit& one) {
            return one.name == text.substr(0, unit_end);
        });
        if (!number || unit == units.end()) {
            return std::nullopt;
        }
        text.remove_prefix(unit_end);
        total += *number * unit->seconds;
        any = true;
    }
    return any ? std::optional(total) : std::nullopt;
}

}  // namespace balcony::cli
