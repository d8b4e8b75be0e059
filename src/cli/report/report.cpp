// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/report/report.hpp"

#include <cerrno>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

namespace balcony::cli {

namespace {

/// The errno of the first failed write to standard output; 0 if none failed.
int output_trouble = 0;

void write_output(std::string_view text) {
    errno = 0;
    if (std::fwrite(text.data(), 1, text.size(), stdout) < text.size() && output_trouble == 0) {
        output_trouble = errno != 0 ? errno : EIO;
    }
}

void write_aside(std::string_view text) {
    [[maybe_unused]] const auto written = std::fwrite(text.data(), 1, text.size(), stderr);
    std::fflush(stderr);
}

}  // namespace

void report(const Diagnostics& diagnostics) { print_aside(to_text(diagnostics)); }

void print_result(std::string_view text) { write_output(printable(text, LineFeeds::keep)); }

void print_file(std::string_view text) {
    if (isatty(STDOUT_FILENO) != 0) {
        print_result(text);
    } else {
        write_output(text);
    }
}

bool print_bytes(std::span<const std::uint8_t> bytes) {
    write_output({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    return output_trouble == 0;
}

void print_json(const nlohmann::json& document) {
    constexpr int indent = 2;
    constexpr bool ascii_only = true;
    write_output(document.dump(indent, ' ', ascii_only, nlohmann::json::error_handler_t::replace) +
                 "\n");
}

bool finish_output() {
    errno = 0;
    if (std::fflush(stdout) != 0 && output_trouble == 0) {
        output_trouble = errno != 0 ? errno : EIO;
    }
    return output_trouble == 0 || output_trouble == EPIPE;
}

void print_aside(std::string_view text) { write_aside(printable(text, LineFeeds::keep)); }

void show_status(std::string_view text) { write_aside("\r" + printable(text) + "\033[K"); }

// Beyond these limits, rounding would show 1000 of a unit.
std::string count_text(double count) {
    if (count < 1e4) {
        return fmt::format("{:.0f}", count);
    }
    const bool thousands = count < 999.95e3;
    const bool millions = count < 999.95e6;
    return thousands  ? fmt::format("{:.1f} k", count / 1e3)
           : millions ? fmt::format("{:.1f} M", count / 1e6)
                      : fmt::format("{:.1f} G", count / 1e9);
}

std::string duration_text(double seconds) {
    if (seconds < 59.95) {
        return fmt::format("{:.1f} s", seconds);
    }
    const auto whole = static_cast<long>(std::lround(seconds));
    if (whole < 3600) {
        return fmt::format("{}:{:02} min", whole / 60, whole % 60);
    }
    return fmt::format("{}:{:02} h", whole / 3600, whole % 3600 / 60);
}

}  // namespace balcony::cli
