// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A film from its layout to its file: memory, denoising, exposure, writing.

#include <optional>
#include <string_view>

#include "balcony/app.hpp"
#include "balcony/shard.hpp"

namespace balcony::app {

[[nodiscard]] Finish finish_of(const Request& request);

/// What both eyes see of a picture, or one of them, if a stereo picture is wanted.
[[nodiscard]] Result<camera::Picture> stereo_view(const Request& request, camera::Picture picture);

/// An empty film, with what denoising needs beside the layers of the file.
[[nodiscard]] Result<render::Film> make_film(render::FilmLayout layout, const Request& request);

/// Whether a film takes more than the request's memory.
[[nodiscard]] bool is_large(const render::FilmLayout& layout, const Request& request);
/// The error that something, such as a frame, cannot be rendered in bands.
[[nodiscard]] Diagnostic too_large(std::string_view what);

/// Denoises if that is wanted. A film that cannot be denoised stays as it is, which is an error.
[[nodiscard]] Result<std::optional<render::DenoiseSummary>> denoise(const Finish& finish,
                                                                    render::Film& film);
/// The same, but with a warning instead of the error.
[[nodiscard]] std::optional<render::DenoiseSummary> try_to_denoise(const Finish& finish,
                                                                   render::Film& film,
                                                                   Diagnostics& found);

/// The file of a shard, beside the picture that it is a part of: "picture.png.shard-2-of-5"
[[nodiscard]] std::filesystem::path shard_file(const std::filesystem::path& picture,
                                               const render::Shard& shard);

}  // namespace balcony::app
