// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/render_request.hpp"

#include <cmath>

#include "cli/options/camera_argument.hpp"

namespace balcony::cli {

Request read_request(const RenderOptions& options, Diagnostics& diagnostics) {
    Request request{
        read_settings(options, diagnostics),    read_exposure(options, diagnostics),
        read_view(options, diagnostics),        read_size(options.size, diagnostics),
        read_layers(options.film, diagnostics), read_crop(options.crop, diagnostics),
        read_job(options.job, diagnostics),     read_texture_memory(options.textures, diagnostics),
        read_denoise(options.film, diagnostics)};
    request.added = options.add;
    request.stereo = read_stereo(options.stereo, diagnostics);
    // Others mix the channels, so that an eye would see what belongs to the other one.
    if (request.stereo && request.stereo->is_anaglyph() &&
        options.command->count("--view-transform") == 0) {
        request.view = render::ViewTransform::standard;
    }
    if (request.exposure) {
        request.settings.sampling.white = std::exp2(-*request.exposure);
    }
    if (request.denoise) {
        request.denoise->threads = request.settings.threads;
    }
    if (options.camera.empty() && !options.set.empty()) {
        diagnostics.push_back(
            error("--set needs a camera whose parameter it sets", {}, "add --camera FILE"));
    }
    if (options.fit.wanted() && (options.camera.empty() || is_of_scene(options.camera))) {
        diagnostics.push_back(error("--fit needs a camera of a file, which it places", {},
                                    "add --camera FILE or the name of a built-in camera"));
    }
    return request;
}

}  // namespace balcony::cli
