// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// How long a render runs, and what it leaves on the disk meanwhile.

#include <optional>
#include <string>
#include <string_view>

#include "balcony/request.hpp"
#include "cli/command_line.hpp"

namespace balcony::cli {

/// The words of --time-limit, --save-every, --checkpoint-every, --resume, --film-memory and
/// --shard.
struct JobWords {
    std::string time_limit;
    std::string save_every;
    std::string checkpoint_every = "60s";
    bool resume = false;
    std::string film_memory = "auto";
    std::string shard;
};

using app::JobRequest;

/// The value of --shard, PART/PARTS; nothing if it is empty.
[[nodiscard]] std::optional<render::Shard> read_shard(const std::string& text,
                                                      Diagnostics& diagnostics);

/// All of these, for a command that renders a picture at a time.
void add_job_options(CLI::App& command, JobWords& words);
/// Only --checkpoint-every and --film-memory.
void add_safety_options(CLI::App& command, JobWords& words);
[[nodiscard]] JobRequest read_job(const JobWords& words, Diagnostics& diagnostics);

/// A duration in seconds: "90", "90s", "1.5min", "1h30min"; nothing if it cannot be read.
[[nodiscard]] std::optional<double> duration_of(std::string_view text);

/// A size in bytes: "500MB", "4GiB", "2G"; nothing if it cannot be read.
[[nodiscard]] std::optional<double> bytes_of(std::string_view text);

}  // namespace balcony::cli
