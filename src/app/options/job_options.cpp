// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstdint>
#include <limits>

#include <fmt/format.h>

#include "app/options/amounts.hpp"
#include "balcony/picture_options.hpp"

namespace balcony::app {

namespace {

// Seconds, above 0.
Value<double> interval() {
    Value<double> made;
    made.info.unit = "s";
    made.info.minimum = 0.0;
    made.read = [](std::string_view word) {
        const auto seconds = duration_of(word);
        return seconds && *seconds > 0.0 ? seconds : std::nullopt;
    };
    made.write = [](double seconds) { return fmt::format("{}s", seconds); };
    made.remedy = [](std::string_view) { return "write a duration such as 30s, 10min or 1.5h"; };
    return made;
}

Value<std::optional<double>> interval_or_off() { return or_word("off", interval()); }

// Without a default to show.
Value<std::optional<double>> optional_interval() {
    Value<std::optional<double>> made = interval_or_off();
    made.write = maybe(interval()).write;
    return made;
}

Value<double> memory() {
    Value<double> made;
    made.info.unit = "bytes";
    made.info.minimum = 0.0;
    made.read = [](std::string_view word) {
        const auto bytes = bytes_of(word);
        return bytes && *bytes > 0.0 ? bytes : std::nullopt;
    };
    made.write = bytes_word;
    made.remedy = [](std::string_view) { return "write auto, or a size such as 500MB or 4GiB"; };
    return made;
}

Value<DisplayAddress> address() {
    Value<DisplayAddress> made;
    made.read = [](std::string_view word) -> std::optional<DisplayAddress> {
        const std::size_t colon = std::min(word.rfind(':'), word.size());
        const auto port = number_of<std::size_t>(word.substr(std::min(colon + 1, word.size())));
        std::string_view host = word.substr(0, colon);
        if (host.starts_with('[') && host.ends_with(']')) {  // IPv6
            host = host.substr(1, host.size() - 2);
        }
        if (!port || *port < 1 || *port > std::numeric_limits<std::uint16_t>::max() ||
            host.empty()) {
            return std::nullopt;
        }
        return DisplayAddress{std::string(host), static_cast<std::uint16_t>(*port)};
    };
    made.write = [](const DisplayAddress& display) { return display.text(); };
    made.remedy = [](std::string_view) {
        return "write a host and a port, such as localhost:14158";
    };
    return made;
}

void refuse_saved_shard(JobRequest& job, const GivenWords&, Diagnostics& found) {
    if (job.shard && job.save_every) {
        found.push_back(error(Kind::usage, "--shard and --save-every exclude each other",
                              "a shard is no picture; balcony merge makes one"));
    }
}

}  // namespace

Value<render::Shard> shard_value() {
    Value<render::Shard> made;
    made.read = [](std::string_view word) -> std::optional<render::Shard> {
        const std::size_t slash = std::min(word.find('/'), word.size());
        const auto number = number_of<std::size_t>(word.substr(0, slash));
        const auto count = number_of<std::size_t>(word.substr(std::min(slash + 1, word.size())));
        if (!number || !count || *number < 1 || *number > *count || *count > render::max_shards) {
            return std::nullopt;
        }
        return render::Shard{*number - 1, *count};
    };
    made.write = [](const render::Shard& shard) {
        return fmt::format("{}/{}", shard.index + 1, shard.count);
    };
    made.remedy = [](std::string_view) {
        return "write the number of the part and how many there are, such as 2/5";
    };
    return made;
}

Options<JobRequest> safety_options() {
    return {{option({.name = "--checkpoint-every",
                     .placeholder = "DURATION",
                     .meaning = "interval at which OUTPUT.checkpoint is written, from which a "
                                "render continues after a crash; off for none",
                     .effect = Effect::run},
                    interval_or_off(), &JobRequest::checkpoint_every),
             option({.name = "--film-memory",
                     .placeholder = "SIZE",
                     .meaning = "a larger picture is rendered in bands, which are appended to its "
                                ".exr file as they finish; auto is half of the machine's memory",
                     .effect = Effect::run},
                    or_word("auto", memory()), &JobRequest::film_memory)}};
}

Options<JobRequest> job_options() {
    Options<JobRequest> made{
        {option({.name = "--time-limit",
                 .placeholder = "DURATION",
                 .meaning = "stop rendering after this time, with the samples that there are",
                 .effect = Effect::run},
                optional_interval(), &JobRequest::time_limit),
         option({.name = "--save-every",
                 .placeholder = "DURATION",
                 .meaning = "save the whole picture so far at this interval, such as 30s or 10min",
                 .effect = Effect::run},
                optional_interval(), &JobRequest::save_every)},
        {refuse_saved_shard}};
    made.rows.push_back(option({.name = "--display",
                                .placeholder = "HOST:PORT",
                                .meaning = "show the picture so far in tev, which listens there, "
                                           "such as localhost:14158",
                                .effect = Effect::run},
                               maybe(address()), &JobRequest::display));
    made.add(safety_options());
    made.rows.push_back(
        flag({.name = "--resume",
              .meaning = "continue an interrupted render from its checkpoint, if there is one",
              .effect = Effect::run},
             true, &JobRequest::resume));
    made.rows.push_back(option({.name = "--shard",
                                .placeholder = "PART/PARTS",
                                .meaning = "render only one of several parts, such as 2/5, to "
                                           "OUTPUT.shard-2-of-5; balcony merge joins them",
                                .effect = Effect::run},
                               maybe(shard_value()), &JobRequest::shard));
    return made;
}

}  // namespace balcony::app
