// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/options/job_options.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
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

std::optional<double> read_memory(const std::string& text, Diagnostics& diagnostics) {
    if (text == "auto") {
        return std::nullopt;
    }
    const auto bytes = bytes_of(text);
    if (!bytes || *bytes <= 0.0) {
        refuse(diagnostics, "--film-memory", text, "write auto, or a size such as 500MB or 4GiB");
    }
    return bytes;
}

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

// "2/5"
std::optional<render::Shard> shard_of(std::string_view text) {
    const std::size_t slash = text.find('/');
    if (slash == std::string_view::npos) {
        return std::nullopt;
    }
    const auto number = number_of<std::size_t>(text.substr(0, slash));
    const auto count = number_of<std::size_t>(text.substr(slash + 1));
    if (!number || !count || *number < 1 || *number > *count || *count > render::max_shards) {
        return std::nullopt;
    }
    return render::Shard{*number - 1, *count};
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
    add_safety_options(command, words);
    command.add_flag("--resume", words.resume,
                     "continue an interrupted render from its checkpoint, if there is one");
    command
        .add_option("--shard", words.shard,
                    "render only one of several parts, such as 2/5, to OUTPUT.shard-2-of-5; "
                    "balcony merge joins them")
        ->type_name("PART/PARTS");
}

void add_safety_options(CLI::App& command, JobWords& words) {
    command
        .add_option("--checkpoint-every", words.checkpoint_every,
                    "interval at which OUTPUT.checkpoint is written, from which a render "
                    "continues after a crash; off for none")
        ->type_name("DURATION")
        ->capture_default_str();
    command
        .add_option("--film-memory", words.film_memory,
                    "a larger picture is rendered in bands, which are appended to its .exr file "
                    "as they finish; auto is half of the machine's memory")
        ->type_name("SIZE")
        ->capture_default_str();
}

std::optional<render::Shard> read_shard(const std::string& text, Diagnostics& diagnostics) {
    const auto shard = shard_of(text);
    if (!text.empty() && !shard) {
        refuse(diagnostics, "--shard", text,
               "write the number of the part and how many there are, such as 2/5");
    }
    return shard;
}

JobRequest read_job(const JobWords& words, Diagnostics& diagnostics) {
    const auto shard = read_shard(words.shard, diagnostics);
    if (shard && !words.save_every.empty()) {
        diagnostics.push_back(error("--shard and --save-every exclude each other", {},
                                    "a shard is no picture; balcony merge makes one"));
    }
    return {read_interval("--time-limit", words.time_limit, diagnostics),
            read_interval("--save-every", words.save_every, diagnostics),
            read_interval("--checkpoint-every", words.checkpoint_every, diagnostics),
            words.resume,
            read_memory(words.film_memory, diagnostics),
            shard};
}

std::optional<double> bytes_of(std::string_view text) {
    constexpr std::string_view prefixes = "kMGT";
    const std::size_t unit_begin = std::min(text.find_first_not_of("0123456789."), text.size());
    const auto number = number_of<double>(text.substr(0, unit_begin));
    std::string_view unit = text.substr(unit_begin);
    unit.remove_suffix(unit.ends_with('B') ? 1 : 0);
    const bool binary = unit.ends_with('i');
    unit.remove_suffix(binary ? 1 : 0);
    const std::size_t prefix = unit.empty() || unit == "K" ? 0 : prefixes.find(unit);
    if (!number || unit.size() > 1 || prefix == std::string_view::npos ||
        (binary && unit.empty())) {
        return std::nullopt;
    }
    const double power = unit.empty() ? 0.0 : static_cast<double>(prefix + 1);
    return *number * std::pow(binary ? 1024.0 : 1000.0, power);
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
