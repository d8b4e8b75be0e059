// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Bands: pictures that are larger than the memory, written row by row while they are rendered.

#include <cstddef>
#include <filesystem>
#include <memory>
#include <stop_token>

#include "balcony/render.hpp"

namespace balcony::render {

/// The memory that a film takes, without what a job adds to it.
[[nodiscard]] double film_bytes(const FilmLayout& layout);

/// The rows of a band whose film takes at most this many bytes, and at least one row of tiles.
[[nodiscard]] std::size_t band_height(const FilmLayout& layout, double bytes);

/// Adds the counts and times of a later run to those of earlier ones.
void add(Summary& total, const Summary& part);

/// Writes an EXR file in bands, from top to bottom. It is that of write() for the whole film.
class BandedFile {
public:
    /// The whole window of the picture.
    BandedFile(const std::filesystem::path& file, const Region& window);
    BandedFile(BandedFile&&) noexcept;
    ~BandedFile();

    /// The band follows on the one before. All but the last have a multiple of tile_height rows.
    [[nodiscard]] Diagnostics add(const Film& band);
    /// After the last band.
    [[nodiscard]] Diagnostics commit();

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Renders a picture in bands of these rows, each with all its samples, and writes it to an EXR
/// file. The picture is that of a job for the whole film. When a stop is requested, the rest of the
/// picture is transparent. Adaptive sampling needs SamplingSettings::white.
[[nodiscard]] Result<Summary> render_in_bands(const Renderer& renderer,
                                              const camera::Picture& picture,
                                              const Settings& settings, const FilmLayout& layout,
                                              std::size_t rows, const std::filesystem::path& file,
                                              const ProgressCallback& progress = {},
                                              std::stop_token stop = {});

}  // namespace balcony::render
