// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Film: the sums of a render, by pixel, and output files.
//
// A film has the data window of a picture: the whole picture, or a region. It counts passes by
// tile, so that tiles may have different numbers of samples, and so that a stopped render
// can continue. Films are plain data owned by the caller; a job (render.hpp) adds passes to them.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Imath/ImathColor.h>
#include <Imath/ImathVec.h>

#include "balcony/base.hpp"
#include "balcony/display_file.hpp"
#include "balcony/layers.hpp"
#include "balcony/names.hpp"

namespace balcony::render {

using Imath::Color3f;
using Imath::Color4f;
using Color4d = Imath::Color4<double>;
using Imath::V2f;
using Imath::V3d;
using Imath::V3f;
using Imath::V4f;

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
    /// What it shares with another one; without pixels if that is nothing.
    [[nodiscard]] Region intersection(const Region& other) const {
        const std::size_t left = std::max(x, other.x);
        const std::size_t top = std::max(y, other.y);
        return {left, top, std::max(left, std::min(x + width, other.x + other.width)) - left,
                std::max(top, std::min(y + height, other.y + other.height)) - top};
    }
    bool operator==(const Region&) const = default;
};

/// The contents of a film.
struct FilmLayout {
    std::size_t width = 1280;  ///< Of the picture, in pixels: 1 to 2^20.
    std::size_t height = 720;
    std::optional<Region> window{};  ///< The data window; by default the whole picture.
    bool data_layers = true;         ///< Include default_layers(), 79 bytes per pixel.
    LayerSet layers{};               ///< Further layers; LayerInfo::bytes per pixel.
    bool second_moment = false;      ///< Include Film::sum_of_squares, 32 bytes per pixel.
};

/// Data of each pixel's centre, unfiltered, row by row from the window's top left. If
/// several layers of a picture are visible, the front one with a coverage of at least one half
/// applies. World coordinates are those of the scene, even if the camera has other axes. Unless
/// noted, a value is 0 where there is no ray or nothing was hit. All but `valid` may be empty.
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
    /// How large the camera shows the place of the hit: pixels per scene unit, on a plane across
    /// the ray; the geometric mean over its directions.
    std::vector<float> magnification;
    /// How far what is seen moves in the picture, in pixels, x to the right and y up: its place a
    /// frame earlier minus that of the pixel, and that of the pixel minus its place a frame later.
    std::vector<V4f> motion;
};

/// The running mean of a value over the samples of a pixel, with its spread.
struct Moments {
    V3f mean{0.0F};
    V3f squares{0.0F};  ///< The sum of the squared differences from the mean.

    /// The sample with number `count`, from 1: Welford, "Note on a Method for Calculating Corrected
    /// Sums of Squares and Products" (1962).
    void add(const V3f& sample, std::uint32_t count) {
        const V3f difference = sample - mean;
        mean += difference / static_cast<float>(count);
        squares += difference * (sample - mean);
    }
};

/// The light of a pixel in the first of two halves of its samples.
struct HalfSum {
    V3f first{0.0F};  ///< The sum over that half.
    V3f even{0.0F};   ///< The sum over all, up to the last power of two below their number.
};

/// The shares of a pixel that the most visible objects (or materials) cover.
struct Matte {
    struct Entry {
        std::uint32_t id = 0;   ///< Index into Film::objects (or materials) plus 1; 0 if unused.
        float coverage = 0.0F;  ///< The sum over the samples.
    };
    static constexpr std::size_t ranks = 6;
    std::array<Entry, ranks> entries;  ///< In no order.

    /// Adds the coverage of one sample. Of more than six ids, the one with the least is lost.
    void add(std::uint32_t id, float coverage);
};

/// Of each pixel, from all passes, filtered like the picture. If several camera layers contribute,
/// each has the weight that it has in blend mode normal. Vectors may be empty.
struct MeanLayers {
    std::vector<V3d> emission;  ///< Sums of light that came from its source to the camera directly.
    std::vector<V3d> direct;    ///< Sums of light that one surface reflected or refracted.
    /// Of the first surface with a non-zero opacity, or of what such a mirror or clear glass shows
    /// where paths are traced; 0 where there is none.
    std::vector<Moments> albedo;
    std::vector<Moments> normal;
    std::vector<Moments> position;
    std::vector<Matte> objects;
    std::vector<Matte> materials;
    std::vector<HalfSum> direct_half;
    std::vector<HalfSum> indirect_half;

    [[nodiscard]] bool any() const {
        return !(emission.empty() && direct.empty() && albedo.empty() && normal.empty() &&
                 position.empty() && objects.empty() && materials.empty() && direct_half.empty() &&
                 indirect_half.empty());
    }
};

/// The tiles of a picture: a grid from its top left. Those at the right and bottom border may be
/// smaller.
inline constexpr std::size_t tile_width = 64;
inline constexpr std::size_t tile_height = 32;

/// A picture under construction. make_film() sizes the vectors; a job fills them. What reads a film
/// as a whole checks the sizes; where they are wrong, it is an error of Kind::internal.
struct Film {
    std::size_t width = 0;  ///< Width of the picture.
    std::size_t height = 0;
    Region window;  ///< The pixels of the film, row by row from the window's top left.

    std::vector<Color4d> sum;             ///< Linear radiance, alpha; colour is premultiplied.
    std::vector<Color4d> sum_of_squares;  ///< Of `sum`, by channel; empty unless requested.
    /// Display colours: frames and leader lines. They are linear and premultiplied like `sum`, but
    /// exposure does not apply to them: 1 is the white of the display. Empty if there are none.
    std::vector<Color4d> display;
    /// The factors of the background that mirrors reflect, by colour; alpha is 0. Empty if no
    /// material is a mirror.
    std::vector<Color4d> mirrored;

    /// The display colour behind the picture, from the settings of the job; transparent if empty.
    /// It is not in the sums.
    std::optional<Color3f> background{};
    Color3f ambient{0.0F};  ///< The ambient radiance: what mirrors reflect without a background.

    LayerSet layer_set;                ///< The layers that an EXR file of the film has.
    std::optional<DataLayers> layers;  ///< Filled by pass 0; absent unless requested.
    MeanLayers means;
    /// After denoise(): the sums as they were rendered, while `sum` is that of the denoised
    /// picture.
    std::vector<Color4d> noisy;

    /// The first pass in the sums. A film that starts at a pass other than 0 contains a later part
    /// of the same render, and its data layers remain empty.
    std::size_t first_pass = 0;
    /// By tile: the number of passes in the sums of its pixels. The next pass of tile i is
    /// first_pass + passes[i].
    std::vector<std::uint32_t> passes;

    /// Of adaptive sampling: the number of samples by pixel, and the sums when a pixel had half as
    /// many, at the last power of two. Empty if all pixels of a tile have its passes.
    std::vector<std::uint32_t> pixel_passes;
    std::vector<Color4d> first_half;
    /// The radiance shown as white, to which noise is relative; 0 until it is known.
    double white = 0.0;

    std::vector<std::string> objects;         ///< Names, by object id minus 1.
    std::vector<std::string> materials;       ///< Names, by material id minus 1.
    std::vector<std::string> picture_layers;  ///< Names of the picture's camera layers.

    /// The tiles that the window touches, row by row; only their pixels inside the window are used.
    [[nodiscard]] std::size_t tile_count() const { return tile_columns() * tile_rows(); }
    /// Complete, clipped to the picture; without pixels if there is no such tile.
    [[nodiscard]] Region tile(std::size_t index) const;
    [[nodiscard]] std::size_t tile_of(std::size_t x, std::size_t y) const;

    /// The index of a pixel of the window in the vectors.
    [[nodiscard]] std::size_t index(std::size_t x, std::size_t y) const {
        return (y - window.y) * window.width + x - window.x;
    }
    /// The number of samples in the sum of a pixel; 0 outside the window.
    [[nodiscard]] std::uint32_t samples(std::size_t x, std::size_t y) const {
        return !window.contains(x, y) ? 0
               : pixel_passes.empty() ? passes[tile_of(x, y)]
                                      : pixel_passes[index(x, y)];
    }

    /// The mean of the samples of a pixel, premultiplied by alpha; transparent if there are none,
    /// as outside the window. The background is seen in mirrors only.
    [[nodiscard]] Color4f pixel(std::size_t x, std::size_t y) const;
    [[nodiscard]] Color4f light(std::size_t x, std::size_t y) const;  ///< Without display colours.
    [[nodiscard]] Color4f display_color(std::size_t x, std::size_t y) const;  ///< Only these.
    /// light() as it was rendered, whether the film is denoised or not.
    [[nodiscard]] Color4f rendered_light(std::size_t x, std::size_t y) const;
    /// The light of surfaces, without what mirrors reflect of the background.
    [[nodiscard]] Color4f surface_light(std::size_t x, std::size_t y) const;
    /// The unbiased estimate of the variance of one sample, by channel; the variance of
    /// surface_light() as rendered is this divided by the number of samples. 0 below two samples
    /// and without sum_of_squares.
    [[nodiscard]] Color4d variance(std::size_t x, std::size_t y) const;

private:
    [[nodiscard]] Color4f with_mirrored(const Color4f& own, std::size_t x, std::size_t y) const;
    [[nodiscard]] Color4f mean(const std::vector<Color4d>& sums, std::size_t x,
                               std::size_t y) const;
    [[nodiscard]] std::size_t tile_columns() const;
    [[nodiscard]] std::size_t tile_rows() const;
};

/// An empty film. A size out of range, a window that is empty or not within the picture, and a film
/// larger than the machine's memory are errors.
[[nodiscard]] Result<Film> make_film(const FilmLayout& layout);

// -------------------------------------------------------------------------------------- files

/// All of these write to a temporary file and then rename it, so the file is complete or unchanged;
/// a failure is an error. NaN is written as 0.

/// How exposed light becomes a display colour. The names are those of other programs.
enum class ViewTransform : std::uint8_t {
    /// Unchanged up to 0.8; above, the highlights are compressed below 1 and lose saturation: the
    /// compression of the Khronos PBR Neutral Tone Mapper (2024).
    neutral,
    standard,  ///< Unchanged up to 1, and clipped above.
    /// Middle grey is unchanged, highlights are compressed up to white at 16, by channel: the curve
    /// of Hable, "Uncharted 2: HDR Lighting" (2010).
    filmic,
    /// Middle grey is unchanged; from 10 stops below it to 6.5 above, light is compressed along a
    /// sigmoid, and bright saturated light turns white: after Sobotka's AgX (2022).
    agx,
};

[[nodiscard]] Names<ViewTransform> view_transforms();

/// The display colour of exposed light, linear, from 0 to 1 in each channel.
[[nodiscard]] Color3f displayed(ViewTransform view, const Color3f& light);

struct DisplayOptions {
    double exposure = 0.0;      ///< In stops: light is multiplied by 2^exposure.
    std::optional<int> bits{};  ///< Bits per channel: 8 or 16, by default those of the format.
    ViewTransform view = ViewTransform::neutral;
    /// Whether files with 8 bits are dithered: pixels with light are rounded up or down by an
    /// ordered pattern, so that their mean over an area is exact and gradients have no bands.
    /// Colours that have an exact level, and pixels without light, such as frames, are rounded to
    /// the nearest level.
    bool dither = true;
    double dpi = 0.0;  ///< Pixels per inch of the print; 0 if that is not known.
};

/// The exposure, in quarter stops, for a film whose light is far from the range of a screen, as in
/// scenes with physical units. Of the luminance of the light, without black parts, it is 0 if the
/// median is between nearly black (0.01) and a stop above white (2), and the 95th percentile at
/// most two stops above white (4). Otherwise, it makes the median middle grey (0.18), or up to two
/// stops less if the 95th percentile would exceed white. Display colours and the background do not
/// count. 0 for a film whose vectors do not have the size of its window.
[[nodiscard]] double automatic_exposure(const Film& film);

/// The bytes of a PNG, JPEG, WebP or TIFF file: light after exposure and view transform, display
/// colours as they are, over the film's background; sRGB with straight alpha, or in front of black
/// in a format without alpha. For a region, the file contains only the window.
[[nodiscard]] Result<std::vector<std::uint8_t>> encode(const Film& film,
                                                       const DisplayFormat& format,
                                                       const DisplayOptions& options = {});

/// Linear floats, every layer in one part, names as in docs/layers.md, over the film's background.
/// The display window is the picture, the data window that of the film.
[[nodiscard]] Diagnostics write_exr(const Film& film, const std::filesystem::path& file);

/// By the file extension, .exr or that of a format for display, to which the options apply.
[[nodiscard]] Diagnostics write(const Film& film, const std::filesystem::path& file,
                                const DisplayOptions& options = {});

/// The errors of write() that are known before rendering: an unknown extension, a folder that
/// does not exist or is not writable.
[[nodiscard]] Diagnostics check_output(const std::filesystem::path& file);

}  // namespace balcony::render
