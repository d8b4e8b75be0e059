// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Compositing of layers: colours in linear light, premultiplied by alpha.

#include <Imath/ImathColor.h>

#include "balcony/picture.hpp"

namespace balcony::render {

using Imath::Color4f;

/// The composited colour at a point: light of the scene, which is exposed later, and display
/// colours, which are not. The alpha of the light is that of the scene, 0 where a ray hits nothing;
/// presence is the fraction of the point that is drawn, by a layer that covers it and has a ray.
/// Colours and alphas are premultiplied by it.
struct Drawn {
    Color4f light{0.0F};
    Color4f display{0.0F};
    Color4f mirrored{0.0F};  ///< The factors of the background in mirrors.
    float presence = 0.0F;
};

/// A source over a backdrop, by the formulas of the W3C's "Compositing and Blending Level 1"
/// for source-over with a blend mode. Multiply, darken, lighten, difference, add and subtract take
/// colours of any brightness; the others are defined for 0 to 1 and clamp brighter ones to 1. In
/// mode normal the result is the source. `below_other` and `source_other` are the alphas of what
/// covers the point but takes no part in the mode.
[[nodiscard]] Color4f blended(camera::BlendMode mode, const Color4f& below, const Color4f& source,
                              float below_other = 0.0F, float source_other = 0.0F);

/// With colours that are made of the channels of these.
[[nodiscard]] Drawn with_channels(const Drawn& drawn, const camera::ColorMatrix& channels);

/// Interpolates between the backdrop and the blended source by a coverage from 0 to 1. A source
/// in mode normal that covers a point hides everything below, even where its scene is empty. The
/// other modes blend light with light and display colours with each other; where one of the two
/// covers the other, the display colour is kept.
[[nodiscard]] Drawn composed(const Drawn& below, const Drawn& source, float coverage,
                             camera::BlendMode mode);

}  // namespace balcony::render
