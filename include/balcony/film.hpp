// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Film: the sums of a render, pixel by pixel, and the files that show them.
//
// A film holds the data window of a picture: the whole of it, or a region. It counts its passes by
// tile, so that tiles may have different numbers of samples, and so that a render that was stopped
// can go on. Films are plain data that the caller owns; a job (render.hpp) adds passes to them.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Imath/ImathColor.h>
#include <Imath/ImathVec.h>

#include "balcony/base.hpp"

namespace balcony::render {

using Imath::Color3f;
using Imath::Color4f;
using Color4d = Imath::Color4<double>;
using Imath::V2f;
using Imath::V3f;

// -------------------------------------------------------------------------------------- film

/// A rectangle of pixels; x and y count from the picture's top left.
struct Region {
    std::size_t x = 0;
    std::size_t y = 0;
    std::size_t width = 0;
    std::size_t height = 0;

    [[nodiscard]] std::size_t size() const { return width * height; }
    [[nodiscard]] bool contains(std::size_t px, std::size_t py) const {
        return px >= x && px - x < width && py >= y && py - y < height;
    }
    bool operator==(const Region&) const = default;
};

/// What a film is to hold.
struct FilmLayout {
    std::size_t width = 1280;  ///< Of the picture, in pixels: 1 to 2^20.
    std::size_t height = 720;
    std::optional<Region> window{};  ///< The data window; without one the whole picture.
    bool data_layers = true;         ///< Hold Film::layers, at 79 bytes a pixel.
    bool second_moment = false;      ///< Hold Film::sum_of_squares, at 32 bytes a pixel.
};

/// What is known of each pixel's centre, unfiltered, row by row from the window's top left. Where
/// several layers of a picture show, the front one counts that covers at least half of the point.
/// World co-ordinates are the scene's, also where the camera has other axes. Unless said otherwise
/// a value is 0 where there is no ray or nothing was hit.
struct DataLayers {
    std::vector<float> ray_length;      ///< From origin to hit; infinite where nothing was hit.
    std::vector<V3f> position;          ///< Of the hit.
    std::vector<V3f> normal;            ///< Unit shading normal at the hit, towards the ray's side.
    std::vector<Color3f> albedo;        ///< Base colour at the hit.
    std::vector<std::uint32_t> object;  ///< Index into Film::objects plus 1.
    std::vector<V3f> origin;            ///< Of the ray.
    std::vector<V3f> direction;         ///< Of the ray, unit length.
    std::vector<V2f> parameters;        ///< (u, v) of the eye object.
    std::vector<std::uint8_t> valid;    ///< 1 where there is a ray.
    std::vector<std::uint16_t> layer;   ///< Index into Film::picture_layers plus 1.
};

/// The tiles of a picture: a grid from its top left. Those on the right and at the bottom may be
/// smaller.
inline constexpr std::size_t tile_width = 64;
inline constexpr std::size_t tile_height = 32;

/// A picture in the making. make_film() sizes the vectors; a job fills them.
struct Film {
    std::size_t width = 0;  ///< Of the picture.
    std::size_t height = 0;
    Region window;  ///< The pixels that the film holds, row by row from the window's top left.

    std::vector<Color4d> sum;             ///< Linear radiance, alpha; colour is premultiplied.
    std::vector<Color4d> sum_of_squares;  ///< By channel; empty unless asked for.
    std::optional<DataLayers> layers;     ///< Filled by pass 0; absent unless asked for.

    /// The first pass in the sums. A film that starts at another pass than 0 holds a later part of
    /// the same render, and its data layers stay empty.
    std::size_t first_pass = 0;
    /// By tile: how many passes are in the sums of its pixels. The next one of tile i is
    /// first_pass + passes[i].
    std::vector<std::uint32_t> passes;

    std::vector<std::string> objects;         ///< Names, by object id less 1.
    std::vector<std::string> picture_layers;  ///< Names of the picture's camera layers.

    /// The tiles that the window touches, row by row; only their pixels in the window count.
    [[nodiscard]] std::size_t tile_count() const { return tile_columns() * tile_rows(); }
    [[nodiscard]] Region tile(std::size_t index) const;  ///< Whole, as far as the picture goes.
    [[nodiscard]] std::size_t tile_of(std::size_t x, std::size_t y) const;

    /// Where a pixel of the window is in the vectors.
    [[nodiscard]] std::size_t index(std::size_t x, std::size_t y) const {
        return (y - window.y) * window.width + x - window.x;
    }
    /// How many samples are in the sum of a pixel of the window.
    [[nodiscard]] std::uint32_t samples(std::size_t x, std::size_t y) const {
        return passes[tile_of(x, y)];
    }

    /// The mean of the samples of a pixel of the window, premultiplied by alpha; nothing where
    /// there are none.
    [[nodiscard]] Color4f pixel(std::size_t x, std::size_t y) const;
    /// The unbiased estimate of the variance of one sample, by channel; that of pixel() is smaller
    /// by the number of samples. Needs sum_of_squares; 0 below two samples.
    [[nodiscard]] Color4d variance(std::size_t x, std::size_t y) const;

private:
    [[nodiscard]] std::size_t tile_columns() const;
    [[nodiscard]] std::size_t tile_rows() const;
};

/// An empty film. A size out of range, a window that is empty or not within the picture, and a film
/// larger than the machine's memory are errors.
[[nodiscard]] Result<Film> make_film(const FilmLayout& layout);

// -------------------------------------------------------------------------------------- files

/// All of these write beside the file and then rename, so the file is whole or untouched; what
/// goes wrong is an error. Values that are no number are written as 0.

struct PngOptions {
    double exposure = 0.0;  ///< Stops: colour is multiplied by 2^exposure.
    int bits = 8;           ///< A channel: 8 or 16.
};

/// The exposure, in half stops, that suits a film whose light is far from the range of a screen, as
/// scenes with physical units have it: 0 if the median luminance of what is not transparent is
/// between nearly black (0.004) and a stop above white (2), else what brings it to middle grey
/// (0.18).
[[nodiscard]] double automatic_exposure(const Film& film);

/// sRGB with alpha (not premultiplied); brighter than white is white. Of a region the file holds
/// the window alone.
[[nodiscard]] Diagnostics write_png(const Film& film, const std::filesystem::path& file,
                                    const PngOptions& options = {});

/// Linear floats, every layer in one part, names as in docs/rendering.md. The display window is the
/// picture, the data window that of the film.
[[nodiscard]] Diagnostics write_exr(const Film& film, const std::filesystem::path& file);

/// By the file's ending, .png or .exr; the options hold for PNG.
[[nodiscard]] Diagnostics write(const Film& film, const std::filesystem::path& file,
                                const PngOptions& options = {});

/// What write() would refuse, known before anything is rendered: an unknown ending, a folder that
/// is not there or cannot be written to.
[[nodiscard]] Diagnostics check_output(const std::filesystem::path& file);

}  // namespace balcony::render
