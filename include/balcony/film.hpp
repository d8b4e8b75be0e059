// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Film: the sums of a render, by pixel, and output files.
//
// A film has the data window of a picture: the whole picture, or a region. It counts passes by
// tile, so that tiles may have different numbers of samples, and so that a stopped render
// can continue. Films are plain data owned by the caller; a job (render.hpp) adds passes to them.

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

/// A rectangle of pixels; x and y are relative to the picture's top left.
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

/// The contents of a film.
struct FilmLayout {
    std::size_t width = 1280;  ///< Of the picture, in pixels: 1 to 2^20.
    std::size_t height = 720;
    std::optional<Region> window{};  ///< The data window; by default the whole picture.
    bool data_layers = true;         ///< Include Film::layers, 79 bytes per pixel.
    bool second_moment = false;      ///< Include Film::sum_of_squares, 32 bytes per pixel.
};

/// Data of each pixel's centre, unfiltered, row by row from the window's top left. If
/// several layers of a picture are visible, the front one with a coverage of at least one half
/// applies. World coordinates are those of the scene, even if the camera has other axes. Unless
/// noted, a value is 0 where there is no ray or nothing was hit.
struct DataLayers {
    std::vector<float> ray_length;      ///< From origin to hit; infinite where nothing was hit.
    std::vector<V3f> position;          ///< Position of the hit.
    std::vector<V3f> normal;            ///< Unit shading normal at the hit, towards the ray's side.
    std::vector<Color3f> albedo;        ///< Base colour at the hit.
    std::vector<std::uint32_t> object;  ///< Index into Film::objects plus 1.
    std::vector<V3f> origin;            ///< Origin of the ray.
    std::vector<V3f> direction;         ///< Unit direction of the ray.
    std::vector<V2f> parameters;        ///< (u, v) of the eye object.
    std::vector<std::uint8_t> valid;    ///< 1 where there is a ray.
    std::vector<std::uint16_t> layer;   ///< Index into Film::picture_layers plus 1.
};

/// The tiles of a picture: a grid from its top left. Those at the right and bottom border may be
/// smaller.
inline constexpr std::size_t tile_width = 64;
inline constexpr std::size_t tile_height = 32;

/// A picture under construction. make_film() sizes the vectors; a job fills them.
struct Film {
    std::size_t width = 0;  ///< Width of the picture.
    std::size_t height = 0;
    Region window;  ///< The pixels of the film, row by row from the window's top left.

    std::vector<Color4d> sum;             ///< Linear radiance, alpha; colour is premultiplied.
    std::vector<Color4d> sum_of_squares;  ///< By channel; empty unless requested.
    std::optional<DataLayers> layers;     ///< Filled by pass 0; absent unless requested.

    /// The first pass in the sums. A film that starts at a pass other than 0 contains a later part
    /// of the same render, and its data layers remain empty.
    std::size_t first_pass = 0;
    /// By tile: the number of passes in the sums of its pixels. The next pass of tile i is
    /// first_pass + passes[i].
    std::vector<std::uint32_t> passes;

    std::vector<std::string> objects;         ///< Names, by object id minus 1.
    std::vector<std::string> picture_layers;  ///< Names of the picture's camera layers.

    /// The tiles that the window touches, row by row; only their pixels inside the window are used.
    [[nodiscard]] std::size_t tile_count() const { return tile_columns() * tile_rows(); }
    [[nodiscard]] Region tile(std::size_t index) const;  ///< Complete, clipped to the picture.
    [[nodiscard]] std::size_t tile_of(std::size_t x, std::size_t y) const;

    /// The index of a pixel of the window in the vectors.
    [[nodiscard]] std::size_t index(std::size_t x, std::size_t y) const {
        return (y - window.y) * window.width + x - window.x;
    }
    /// The number of samples in the sum of a pixel of the window.
    [[nodiscard]] std::uint32_t samples(std::size_t x, std::size_t y) const {
        return passes[tile_of(x, y)];
    }

    /// The mean of the samples of a pixel of the window, premultiplied by alpha; transparent if
    /// there are none.
    [[nodiscard]] Color4f pixel(std::size_t x, std::size_t y) const;
    /// The unbiased estimate of the variance of one sample, by channel; the variance of pixel() is
    /// this divided by the number of samples. Needs sum_of_squares; 0 below two samples.
    [[nodiscard]] Color4d variance(std::size_t x, std::size_t y) const;

private:
    [[nodiscard]] std::size_t tile_columns() const;
    [[nodiscard]] std::size_t tile_rows() const;
};

/// An empty film. A size out of range, a window that is empty or not within the picture, and a film
/// larger than the machine's memory are errors.
[[nodiscard]] Result<Film> make_film(const FilmLayout& layout);

// -------------------------------------------------------------------------------------- files

/// All of these write to a temporary file and then rename it, so the file is complete or unchanged;
/// a failure is an error. NaN is written as 0.

struct PngOptions {
    double exposure = 0.0;  ///< In stops: colour is multiplied by 2^exposure.
    int bits = 8;           ///< Bits per channel: 8 or 16.
};

/// The exposure, in half stops, for a film whose light is far from the range of a screen, as
/// in scenes with physical units: 0 if the median luminance of the non-transparent part is
/// between nearly black (0.004) and a stop above white (2), otherwise the exposure that makes it
/// middle grey (0.18).
[[nodiscard]] double automatic_exposure(const Film& film);

/// sRGB with straight alpha; values above white are clipped. For a region, the file contains
/// only the window.
[[nodiscard]] Diagnostics write_png(const Film& film, const std::filesystem::path& file,
                                    const PngOptions& options = {});

/// Linear floats, every layer in one part, names as in docs/rendering.md. The display window is the
/// picture, the data window that of the film.
[[nodiscard]] Diagnostics write_exr(const Film& film, const std::filesystem::path& file);

/// By the file extension, .png or .exr; the options apply to PNG.
[[nodiscard]] Diagnostics write(const Film& film, const std::filesystem::path& file,
                                const PngOptions& options = {});

/// The errors of write() that are known before rendering: an unknown extension, a folder that
/// does not exist or is not writable.
[[nodiscard]] Diagnostics check_output(const std::filesystem::path& file);

}  // namespace balcony::render
