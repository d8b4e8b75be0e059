// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/picture/finished_picture.hpp"

#include <system_error>

#include <fmt/format.h>

#include "app/words.hpp"
#include "balcony/images.hpp"

namespace balcony::app {

namespace {

bool is_stream(const std::filesystem::path& output) { return output == "-"; }

}  // namespace

const render::DisplayFormat* Finish::display_format() const {
    return render::display_format(is_stream(output) ? "picture.png" : output);
}

double Finish::exposure_of(const render::Film& film) const {
    return exposure                      ? *exposure
           : display_format() != nullptr ? render::automatic_exposure(film)
                                         : 0.0;
}

Finish finish_of(const Request& request) {
    Finish finish{.output = request.output,
                  .exposure = request.exposure,
                  .view = request.view_transform(),
                  .dither = request.dither};
    if (request.denoise) {
        finish.denoise = {
            .denoiser = request.denoiser, .library = {}, .threads = request.settings.threads};
    }
    return finish;
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

Result<std::optional<render::DenoiseSummary>> denoise(const Finish& finish, render::Film& film) {
    if (!finish.denoise) {
        return std::optional<render::DenoiseSummary>();
    }
    auto done = render::denoise(film, *finish.denoise);
    if (!done) {
        return of_kind(Kind::environment, std::move(done.diagnostics));
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
    const render::DisplayOptions options{
        .exposure = finish.exposure_of(film), .view = finish.view, .dither = finish.dither};
    if (!is_stream(finish.output)) {
        return of_kind(Kind::environment, render::write(film, finish.output, options));
    }
    auto bytes = render::encode(film, *finish.display_format(), options);
    if (bytes && observer.bytes) {
        observer.bytes(*bytes);
    }
    return of_kind(Kind::environment, std::move(bytes.diagnostics));
}

Diagnostics check_output(const std::filesystem::path& output) {
    if (is_stream(output)) {
        return of_kind(Kind::environment, images::require());
    }
    std::error_code ignored;
    if (std::filesystem::is_directory(output, ignored)) {
        return {error(Kind::usage, fmt::format("'{}' is a folder", output.string()),
                      fmt::format("name a file in it: {}", (output / "{scene}.png").string()))};
    }
    const bool is_known =
        render::display_format(output) != nullptr || ending_of(output.string()) == ".exr";
    return of_kind(is_known ? Kind::environment : Kind::usage, render::check_output(output));
}

}  // namespace balcony::app
