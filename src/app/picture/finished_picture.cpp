// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/picture/finished_picture.hpp"

#include <system_error>

#include <fmt/format.h>

#include "app/words.hpp"
#include "balcony/images.hpp"
#include "balcony/tiled_file.hpp"

namespace balcony::app {

namespace {

namespace fs = std::filesystem;

bool is_stream(const fs::path& output) { return output == "-"; }

}  // namespace

Finish finish_of(const Request& request) {
    const render::DisplayOptions display = request.display();
    return {.output = request.output,
            .denoiser = request.denoise ? std::optional(request.denoiser) : std::nullopt,
            .threads = request.settings.threads,
            .exposure = display.exposure,
            .view = display.view,
            .dither = display.dither,
            .dpi = display.dpi};
}

Result<camera::Picture> stereo_view(const Request& request, camera::Picture picture) {
    return request.stereo.is_wanted()
               ? camera::stereo_picture(picture, request.stereo.formats.front(),
                                        request.stereo.pair)
               : Result<camera::Picture>(std::move(picture));
}

Result<render::Film> make_film(render::FilmLayout layout, const Request& request) {
    const render::LayerSet in_file = layout.layers;
    if (request.denoise) {
        layout.layers.insert(render::denoise_layers());
    }
    Result<render::Film> film = render::make_film(layout);
    if (film) {
        film->layer_set = in_file;
    }
    return film;
}

bool is_large(const render::FilmLayout& layout, const Request& request) {
    return render::film_bytes(layout) > request.job.film_bytes();
}

Diagnostic too_large(std::string_view what) {
    return error(Kind::environment,
                 fmt::format("{} of this size needs more memory than --film-memory allows", what),
                 "raise --film-memory, or make the picture smaller");
}

Result<std::optional<render::DenoiseSummary>> denoise(const Finish& finish, render::Film& film) {
    if (!finish.denoiser) {
        return std::optional<render::DenoiseSummary>();
    }
    auto done = render::denoise(
        film, {.denoiser = *finish.denoiser, .library = {}, .threads = finish.threads});
    if (!done) {
        return std::move(done.diagnostics);
    }
    return {std::optional(std::move(*done)), std::move(done.diagnostics)};
}

std::optional<render::DenoiseSummary> try_to_denoise(const Finish& finish, render::Film& film,
                                                     Diagnostics& found) {
    auto done = denoise(finish, film);
    for (Diagnostic& one : done.diagnostics) {
        found.push_back(
            done ? one : warning("the picture is not denoised: " + one.message, {}, one.remedy));
    }
    return done ? *done : std::nullopt;
}

Diagnostics write(const Finish& finish, const render::Film& film, const Observer& observer) {
    const render::DisplayOptions options{.exposure = finish.exposure,
                                         .view = finish.view,
                                         .dither = finish.dither,
                                         .dpi = finish.dpi};
    if (!is_stream(finish.output)) {
        return render::write(film, finish.output, options);
    }
    auto bytes = render::encode(film, *finish.display_format(), options);
    if (bytes && observer.bytes) {
        observer.bytes(*bytes);
    }
    return std::move(bytes.diagnostics);
}

fs::path shard_file(const fs::path& picture, const render::Shard& shard) {
    fs::path file = picture;
    file += fmt::format(".shard-{}-of-{}", shard.index + 1, shard.count);
    return file;
}

Diagnostics check_output(const fs::path& output) {
    if (is_stream(output)) {
        return {};
    }
    std::error_code ignored;
    if (fs::is_directory(output, ignored)) {
        return {error(Kind::usage, fmt::format("'{}' is a folder", output.string()),
                      fmt::format("name a file in it: {}", (output / "{scene}.png").string()))};
    }
    return render::check_output(output);
}

}  // namespace balcony::app
