// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/options/amounts.hpp"
#include "balcony/finish.hpp"
#include "balcony/picture_options.hpp"

namespace balcony::app {

namespace {

void read_layers(std::span<const std::string> words, Request& request, Diagnostics& found) {
    const Result<render::LayerSet> layers = render::find_layers(words.back());
    for (const Diagnostic& one : layers.diagnostics) {
        found.push_back(error(Kind::usage, "--layers: " + one.message, one.remedy));
    }
    request.layers = layers.value.value_or(request.layers);
}

std::vector<std::string> write_layers(const Request& request) {
    for (const char* name : {"default", "all", "none"}) {
        if (*render::find_layers(name) == request.layers) {
            return {name};
        }
    }
    std::vector<std::string_view> names;
    for (const render::LayerInfo& info : render::layers()) {
        if (request.layers.contains(info.id) &&
            std::find(names.begin(), names.end(), info.name) == names.end()) {
            names.push_back(info.name);
        }
    }
    return {fmt::format("{}", fmt::join(names, ","))};
}

// A number of MiB, or with a unit.
Value<std::size_t> texture_bytes() {
    constexpr double largest = 0x1p50;
    constexpr double mebibyte = 0x1p20;
    Value<std::size_t> made;
    made.info.unit = "bytes";
    made.info.minimum = static_cast<double>(render::min_texture_memory);
    made.info.maximum = largest;
    made.read = [](std::string_view word) -> std::optional<std::size_t> {
        const auto mebibytes = number_of<double>(word);
        const auto bytes = mebibytes ? std::optional(*mebibytes * mebibyte) : bytes_of(word);
        return bytes && *bytes >= static_cast<double>(render::min_texture_memory) &&
                       *bytes <= largest
                   ? std::optional(static_cast<std::size_t>(*bytes))
                   : std::nullopt;
    };
    made.write = [](std::size_t bytes) { return bytes_word(static_cast<double>(bytes)); };
    made.remedy = [](std::string_view) {
        return fmt::format("give at least {} MiB, such as 512 or 4GiB",
                           render::min_texture_memory >> 20U);
    };
    return made;
}

}  // namespace

Diagnostics check_dpi(const std::optional<double>& dpi, const std::filesystem::path& output) {
    if (!dpi || output.empty()) {
        return {};
    }
    const render::DisplayFormat* const format = render::Finish{.output = output}.display_format();
    if (format != nullptr && format->has_resolution) {
        return {};
    }
    return {error(Kind::usage,
                  fmt::format("--dpi: a file '{}' does not say how large it is in print",
                              output.extension().string()),
                  "write a .png, .jpg or .tif file, or leave out --dpi")};
}

Options<Request> film_options() {
    return {{custom_option<Request>(
                 {.name = "--layers",
                  .others = {"--aov", "--aovs", "--passes"},
                  .placeholder = "LIST",
                  .meaning = "layers of an EXR file beside the picture: default, all, none, or "
                             "names separated by commas, such as default,direct,indirect (see "
                             "docs/layers.md)"},
                 read_layers, write_layers),
             flag({.name = "--denoise",
                   .meaning = "remove the noise of the finished picture (see docs/denoising.md)",
                   .effect = Effect::display},
                  true, &Request::denoise),
             option({.name = "--denoiser",
                     .placeholder = "NAME",
                     .meaning = "library (Open Image Denoise), features (Balcony's filter, the "
                                "same on every machine) or auto (library where there is one)",
                     .effect = Effect::display},
                    choice(render::denoisers()), &Request::denoiser),
             flag({.name = "--no-dither",
                   .meaning = "round the colours of files with 8 bits instead of dithering them",
                   .effect = Effect::display},
                  false, &Request::dither),
             dpi_option(&Request::dpi),
             option({.name = "--texture-memory",
                     .placeholder = "SIZE",
                     .meaning = "limit for the textures in memory, in MiB or with a unit (MiB, "
                                "GiB, MB, GB)",
                     .effect = Effect::run},
                    texture_bytes(), &Request::texture_memory)}};
}

}  // namespace balcony::app
