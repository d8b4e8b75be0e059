// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What textures are computed with: an antialiased canvas, colours, noise. A colour is linear
// Rec. 709, 1 is white.

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <vector>

#include <Imath/ImathVec.h>

#include "balcony/scene.hpp"

namespace balcony::plates {

using Imath::V2d;
using Imath::V3d;
using Color = V3d;

struct Painting {
    int width = 0;                     ///< Pixels.
    int height = 0;                    ///< Pixels.
    std::vector<std::uint8_t> pixels;  ///< Three bytes a pixel, rows from the top.
    scene::TextureEncoding encoding = scene::TextureEncoding::srgb;
};

/// One of the sub-samples of a pixel.
struct Sample {
    V2d point;  ///< y up from -1 (bottom) to 1 (top), x right from -aspect to aspect.
    int index;  ///< Which of the pixel's samples: 0 to samples_per_pixel - 1.
};

inline constexpr int samples_per_axis = 3;
inline constexpr int samples_per_pixel = samples_per_axis * samples_per_axis;

/// Where a painter is asked: at all samples of a pixel, or at its centre only, for a smooth texture
/// whose painter takes long.
enum class Sampling : std::uint8_t { antialiased, centre };

using Painter = std::function<Color(const Sample&)>;

/// Computes a picture: samples_per_pixel samples a pixel, averaged in linear light, or one. The
/// painter is called from several threads at once; the result does not depend on their number.
[[nodiscard]] Painting paint(int width, int height, const Painter& painter,
                             scene::TextureEncoding encoding = scene::TextureEncoding::srgb,
                             Sampling sampling = Sampling::antialiased);

/// The picture as a PNG file; empty if it could not be encoded.
[[nodiscard]] std::vector<std::uint8_t> to_png(const Painting& painting);

/// The colour that a style sheet writes #rrggbb.
[[nodiscard]] Color from_srgb(std::uint32_t rrggbb);

[[nodiscard]] inline Color mix(const Color& from, const Color& to, double t) {
    return from + (to - from) * t;
}

/// 0 below from, 1 above to, a cubic without kinks between.
[[nodiscard]] double smooth_step(double from, double to, double x);

/// A run of colours, evenly spaced over [0, 1] and mixed in Oklab (B. Ottosson, 2020), where equal
/// steps look equal.
class Gradient {
public:
    /// Colours as from_srgb takes them; a cyclic gradient returns to the first one at 1.
    explicit Gradient(std::initializer_list<std::uint32_t> colors, bool cyclic = false);

    /// Outside [0, 1] a cyclic gradient repeats, another one keeps its end colours.
    [[nodiscard]] Color operator()(double t) const;

private:
    std::vector<V3d> stops_;  // Oklab
    bool cyclic_;
};

/// A number in [0, 1) that looks random, one for each lattice point and seed.
[[nodiscard]] double lattice_noise(int x, int y, std::uint32_t seed);

/// Smooth value noise in [-1, 1] with features of size 1.
[[nodiscard]] double noise(const V2d& point, std::uint32_t seed);

/// Sum of octaves of noise, each of half the size and half the height of the one before.
[[nodiscard]] double fractal_noise(V2d point, int octaves, std::uint32_t seed);

}  // namespace balcony::plates
