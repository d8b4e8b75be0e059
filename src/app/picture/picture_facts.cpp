// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/picture/picture_facts.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "balcony/content_hash.hpp"
#include "balcony/picture_options.hpp"

namespace balcony::app {

namespace {

using Row = Option<Request>;

// What an EXR file shows of a film, and what asks for its layers.
constexpr std::array<std::string_view, 4> of_exr{"--background", "--denoise", "--denoiser",
                                                 "--layers"};
constexpr std::array<std::string_view, 2> of_layers{"--denoise", "--layers"};

template <std::size_t count>
bool contains(const std::array<std::string_view, count>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

const std::vector<Row>& rows() {
    static const std::vector<Row> all = request_options().rows;
    return all;
}

std::string word_of(const Row& row, const Request& request) {
    return fmt::format("{}", fmt::join(row.write(request), " "));
}

bool matters(const Row& row, const Request& request, FactsOf what, bool is_frame) {
    if (row.name == "--fps") {
        return is_frame || request.layers.contains(render::LayerId::motion) ||
               (request.shutter.in_degrees && request.shutter.duration > 0.0);
    }
    if (row.name == "--exposure" && request.settings.sampling.noise > 0.0) {
        return true;
    }
    // --size says both, or the width.
    if (row.name == "--width" || (row.name == "--height" && request.size.width)) {
        return false;
    }
    return contains(of_exr, row.name)      ? what != FactsOf::sums
           : row.effect == Effect::display ? what == FactsOf::display
                                           : row.effect == Effect::film;
}

// Whether the environment is in the sums.
render::RenderFact environment_fact(const Request& request) {
    const bool visible = !request.settings.background && request.settings.light.visible;
    return {"--background", visible ? "auto" : "a colour or transparent"};
}

}  // namespace

render::RenderFacts facts_of(const Request& request, FactsOf what, bool is_frame) {
    render::RenderFacts facts;
    for (const Row& row : rows()) {
        if (matters(row, request, what, is_frame)) {
            facts.push_back({row.name, word_of(row, request)});
        }
    }
    return facts;
}

render::FilmFacts film_facts(const Request& request) {
    render::FilmFacts facts{.sums = facts_of(request, FactsOf::sums)};
    facts.sums.push_back(environment_fact(request));
    for (const Row& row : rows()) {
        if (contains(of_layers, row.name)) {
            facts.layers.push_back({row.name, word_of(row, request)});
        }
    }
    return facts;
}

render::RenderFacts facts_of(std::span<const std::filesystem::path> files) {
    render::RenderFacts facts;
    for (const std::filesystem::path& file : files) {
        const auto hash = content_hash(file);
        facts.push_back({fmt::format("the file '{}'", file.string()),
                         hash ? fmt::format("#{:016x}", *hash) : "#unreadable"});
    }
    return facts;
}

}  // namespace balcony::app
