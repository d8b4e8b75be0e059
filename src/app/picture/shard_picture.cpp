// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/picture/shard_picture.hpp"

#include <charconv>

#include <fmt/format.h>

namespace balcony::app {

namespace {

std::optional<double> stops_of(const std::string& text) {
    double stops = 0.0;
    const char* const end = text.data() + text.size();
    const auto [read_to, failed] = std::from_chars(text.data(), end, stops);
    return failed == std::errc() && read_to == end ? std::optional(stops) : std::nullopt;
}

}  // namespace

std::filesystem::path shard_file(const std::filesystem::path& picture, const render::Shard& shard) {
    std::filesystem::path file = picture;
    file += fmt::format(".shard-{}-of-{}", shard.index + 1, shard.count);
    return file;
}

render::RenderFacts facts_of(const Finish& finish) {
    return {
        {"picture", finish.output.string()},
        {"exposure", finish.exposure ? fmt::format("{}", *finish.exposure) : "auto"},
        {"view", std::string(render::view_transforms()[finish.view].name)},
        {"dither", finish.dither ? "yes" : "no"},
        {"denoiser",
         finish.denoise ? std::string(render::denoisers()[finish.denoise->denoiser].name) : ""}};
}

Finish finish_of(const render::RenderFacts& facts) {
    Finish finish;
    for (const auto& [name, value] : facts) {
        if (name == "picture") {
            finish.output = value;
        } else if (name == "exposure") {
            finish.exposure = stops_of(value);
        } else if (name == "view") {
            finish.view = render::view_transforms().find(value).value_or(finish.view);
        } else if (name == "dither") {
            finish.dither = value != "no";
        } else if (const auto denoiser = render::denoisers().find(value);
                   name == "denoiser" && denoiser) {
            finish.denoise = {.denoiser = *denoiser, .library = {}};
        }
    }
    return finish;
}

}  // namespace balcony::app
