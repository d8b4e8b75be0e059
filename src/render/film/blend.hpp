// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// How layers join: colours in linear light, premultiplied by alpha.

#include <Imath/ImathColor.h>

#include "balcony/picture.hpp"

namespace balcony::render {

using Imath::Color4f;

/// What is drawn at a point so far. Its colour's alpha is that of the scene, 0 where a ray meets
/// nothing; presence tells how much of the point is drawn at all, by a layer that covers it and has
/// a ray. Both colour and alpha are premultiplied by it.
struct Drawn {
    Color4f color{0.0F};
    float presence = 0.0F;
};

/// A source on what is below it, by the formulas of the W3C's "Compositing and Blending Level 1"
/// for source-over with a blend mode. Multiply, darken, lighten, difference, add and subtract take
/// colours of any brightness; the others are made for 0 to 1 and take brighter ones as 1. In mode
/// normal the source stays as it is.
[[nodiscard]] Color4f blended(camera::BlendMode mode, const Color4f& below, const Color4f& source);

/// Mixes what the source makes of what is below it into that, by a coverage from 0 to 1. A source
/// in mode normal that covers a point hides all that is below, also where its scene is empty.
[[nodiscard]] Drawn composed(const Drawn& below, const Drawn& source, float coverage,
                             camera::BlendMode mode);

}  // namespace balcony::render
