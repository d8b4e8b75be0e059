// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/checkpoint.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "film/files/sealed_file.hpp"
#include "film/sums/film_arrays.hpp"

namespace balcony::render {

namespace {

constexpr std::string_view checkpoint_kind = "checkpoint";

Diagnostic not_resumable(const fs::path& file, std::string_view reason) {
    return error(Kind::input, fmt::format("'{}' cannot be resumed: {}", file.string(), reason),
                 "render without --resume to begin anew");
}

// To be written or read.
auto members_of_checkpoint(auto& heading) {
    return std::tie(heading.facts.sums, heading.facts.layers, heading.width, heading.height,
                    heading.window, heading.finished);
}

Result<CheckpointHeading> read_heading(SealedReader& input, const fs::path& file) {
    if (const auto why = input.begins_otherwise(checkpoint_kind)) {
        return not_resumable(file, *why);
    }
    CheckpointHeading heading;
    if (!input.read_fields(members_of_checkpoint(heading)) || !input.is_sealed()) {
        return not_resumable(file, damaged(checkpoint_kind));
    }
    return heading;
}

// Why a film is not the one of a heading; empty if it is.
std::string difference(const CheckpointHeading& before, const Film& film, const FilmFacts& now) {
    std::string found = difference(before.facts.sums, now.sums);
    const auto shape = [](std::size_t width, std::size_t height, const Region& window) {
        return fmt::format("{}x{}+{}+{} of {}x{}", window.width, window.height, window.x, window.y,
                           width, height);
    };
    const std::string was = shape(before.width, before.height, before.window);
    const std::string is = shape(film.width, film.height, film.window);
    return found.empty() && was != is ? fmt::format("the picture was {} and is {}", was, is)
                                      : found;
}

// Reads the arrays of a film. Those that it does not have are passed over.
enum class Arrays : std::uint8_t { read, lacking, damaged };

Arrays read_arrays(SealedReader& input, Film& film) {
    std::uint64_t count = 0;
    if (!input.read_fields(std::tie(count))) {
        return Arrays::damaged;
    }
    bool is_sound = true;
    bool is_complete = true;
    const auto pass_over = [&](std::uint64_t size) {
        std::vector<std::byte> bytes(size);
        return input.read(bytes);
    };
    for_each_array(film, [&](auto& array) {
        const auto bytes = std::as_writable_bytes(std::span(array));
        if (count == 0) {
            is_complete = is_complete && bytes.empty();
            return;
        }
        --count;
        const auto size = is_sound ? input.read_size() : std::nullopt;
        is_complete = is_complete && (!size || *size >= bytes.size());
        is_sound =
            size && (*size == bytes.size() ? input.read(bytes)
                                           : (*size == 0 || bytes.empty()) && pass_over(*size));
    });
    for (; is_sound && count > 0; --count) {
        const auto size = input.read_size();
        is_sound = size && pass_over(*size);
    }
    return !is_sound || !input.ends_sealed() ? Arrays::damaged
           : is_complete                     ? Arrays::read
                                             : Arrays::lacking;
}

}  // namespace

Diagnostics write_checkpoint(const Film& film, const FilmFacts& facts,
                             const std::vector<std::uint64_t>& finished, const fs::path& file) {
    SealedWriter output(checkpoint_kind, file);
    const CheckpointHeading heading{facts, film.width, film.height, film.window, finished};
    output.write_fields(members_of_checkpoint(heading));
    output.seal();
    std::uint64_t count = 0;
    for_each_array(film, [&count](const auto&) { ++count; });
    output.write_fields(std::tie(count));
    for_each_array(film,
                   [&](const auto& array) { output.write_part(std::as_bytes(std::span(array))); });
    return output.commit();
}

Result<CheckpointHeading> read_checkpoint_heading(const fs::path& file) {
    SealedReader input(file);
    return read_heading(input, file);
}

Diagnostics read_checkpoint(Film& film, const FilmFacts& facts, const fs::path& file) {
    SealedReader input(file);
    const Result<CheckpointHeading> before = read_heading(input, file);
    if (!before) {
        return before.diagnostics;
    }
    std::string other = difference(*before, film, facts);
    Film read = film;
    if (other.empty()) {
        const Arrays arrays = read_arrays(input, read);
        other = arrays == Arrays::lacking ? difference(before->facts.layers, facts.layers) : "";
        if (arrays != Arrays::read && other.empty()) {
            return {not_resumable(file, damaged(checkpoint_kind))};
        }
    }
    if (!other.empty()) {
        return {not_resumable(file, fmt::format("it is of another render: {}", other))};
    }
    film = std::move(read);
    return {};
}

}  // namespace balcony::render
