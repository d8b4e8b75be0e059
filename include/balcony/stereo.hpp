// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Stereo pictures: what both eyes see of any picture, arranged in one.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/picture.hpp"

namespace balcony::camera {

/// How a picture shows what the eyes see.
enum class StereoFormat : std::uint8_t {
    left,            ///< The picture of the left eye alone.
    right,           ///< The picture of the right eye alone.
    side_by_side,    ///< Twice as wide: the left eye's picture on the left.
    cross_eyed,      ///< Twice as wide: the left eye's picture on the right.
    top_bottom,      ///< Twice as high: the left eye's picture on top.
    anaglyph,        ///< For red and cyan glasses, red on the left: colours by least squares.
    anaglyph_color,  ///< Likewise; red of the left eye's picture, green and blue of the other.
    anaglyph_grey,   ///< Likewise; the luminances of both pictures.
};

[[nodiscard]] Names<StereoFormat> stereo_formats();

/// The parameters of the stage `stereo`, as in the catalogue.
struct StereoPair {
    double separation = 0.064;            ///< In scene units, above 0.
    std::optional<double> convergence{};  ///< In scene units, above 0.
    std::string baseline = "auto";
    std::optional<std::array<double, 2>> merge{};  ///< In radians.
};

/// What both eyes see of a picture. Halves have the size and the aspect of the picture, and each
/// of them fits its picture into a place of another aspect as the picture itself does. It is an
/// error if a number is out of its range, or if a camera of the picture is a view of a stereo pair
/// already.
///
/// The weights of `anaglyph` are those of E. Dubois, "A projection method to generate anaglyph
/// stereo images" (2001), for red and cyan glasses, in linear light.
[[nodiscard]] Result<Picture> stereo_picture(const Picture& picture, StereoFormat format,
                                             const StereoPair& pair = {});

}  // namespace balcony::camera
