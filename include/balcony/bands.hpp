// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Bands: pictures that are larger than the memory. Band by band, from top to bottom, a film is
// rendered with all its samples, and its tiles are appended to an EXR file.
//
//     BandedRender::make(renderer, picture, settings, layout, rows)
//     TiledFile::create(file, film, window)
//     do { job().run(); tiles.add(film()); } while (render.next());
//     tiles.commit();
//
// With a checkpoint of the film of the band in progress, whose heading says which it is and what is
// finished, and the unfinished file, another process continues to the very same file.

#include <cstddef>
#include <stop_token>
#include <utility>

#include "balcony/render.hpp"
#include "balcony/tiled_file.hpp"

namespace balcony::render {

/// Adds the counts and times of a later run to those of earlier ones.
void add(Summary& total, const Summary& part);

/// The render of a picture in bands.
class BandedRender {
public:
    /// Begins with the first band of the layout's window. Rows that are no multiple of
    /// file_tile_side are an error of Kind::internal. Adaptive sampling needs
    /// SamplingSettings::white.
    [[nodiscard]] static Result<BandedRender> make(const Renderer& renderer,
                                                   const camera::Picture& picture,
                                                   const Settings& settings,
                                                   const FilmLayout& layout, std::size_t rows,
                                                   const std::stop_token& stop = {});

    /// Of the band in progress: a job for its film.
    [[nodiscard]] Film& film() { return *job_.film(); }
    [[nodiscard]] Job& job() { return job_; }

    /// Begins the band after the one in progress; false if that was the last one.
    [[nodiscard]] bool next();
    /// Begins the band at a row of the picture. False if no tile of the file begins there.
    [[nodiscard]] bool begin_at(std::size_t first_row);
    /// Begins another band, of whole tiles of the file. False if there is no such band.
    [[nodiscard]] bool go_to(std::size_t first_row, std::size_t rows);

    /// The part of the picture that is done, from 0 to 1, if this part of the band is.
    [[nodiscard]] double done(double part_of_band) const;

private:
    BandedRender(const Region& window, std::size_t rows, Job job)
        : window_(window), rows_(rows), job_(std::move(job)) {}

    Region window_;
    std::size_t rows_;
    Job job_;
};

}  // namespace balcony::render
