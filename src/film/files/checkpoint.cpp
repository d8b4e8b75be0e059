// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/checkpoint.hpp"

#include <utility>

#include <fmt/format.h>

#include "film/files/render_facts.hpp"
#include "film/files/sealed_file.hpp"
#include "film/sums/film_arrays.hpp"

namespace balcony::render {

namespace {

constexpr std::string_view signature = "Balcony checkpoint 1\n";

Diagnostic refused(const fs::path& file, std::string_view reason) {
    return error(fmt::format("'{}' cannot be resumed: {}", file.string(), reason), {},
                 "render without --resume to begin anew");
}

Diagnostic damaged(const fs::path& file) {
    return refused(file, "the file is damaged or no checkpoint");
}

// The beginning of a checkpoint.
Result<RenderFacts> read_facts(SealedReader& input, const fs::path& file) {
    const auto facts = input.read_beginning(signature);
    return facts ? Result<RenderFacts>(*facts) : Result<RenderFacts>(damaged(file));
}

}  // namespace

Diagnostics write_checkpoint(const Film& film, const RenderFacts& facts, const fs::path& file) {
    SealedWriter output("checkpoint", file);
    output.write(std::as_bytes(std::span(signature)));
    output.write_part(std::as_bytes(std::span<const char>(text_of(facts))));
    for_each_array(film,
                   [&](const auto& array) { output.write_part(std::as_bytes(std::span(array))); });
    return output.commit();
}

Result<RenderFacts> read_facts(const fs::path& file) {
    SealedReader input(file);
    return read_facts(input, file);
}

Diagnostics read_checkpoint(Film& film, const RenderFacts& facts, const fs::path& file) {
    SealedReader input(file);
    const Result<RenderFacts> before = read_facts(input, file);
    if (!before) {
        return before.diagnostics;
    }
    if (const std::string found = difference(*before, facts); !found.empty()) {
        return {refused(file, fmt::format("it is of another render: {}", found))};
    }
    Film read = film;
    bool fits = true;
    for_each_array(read, [&](auto& array) {
        const auto bytes = std::as_writable_bytes(std::span(array));
        fits = fits && input.read_size() == bytes.size() && input.read(bytes);
    });
    if (!fits || !input.ends_with_hash()) {
        return {damaged(file)};
    }
    film = std::move(read);
    return {};
}

}  // namespace balcony::render
