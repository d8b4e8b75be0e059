// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/blend.hpp"

#include <algorithm>
#include <cmath>

namespace balcony::render {

namespace {

using camera::BlendMode;

float clamped(float value) { return std::clamp(value, 0.0F, 1.0F); }

float screen(float below, float source) { return below + source - below * source; }

float hard_light(float below, float source) {
    return source <= 0.5F ? below * 2.0F * source : screen(below, 2.0F * source - 1.0F);
}

float soft_light(float below, float source) {
    if (source <= 0.5F) {
        return below - (1.0F - 2.0F * source) * below * (1.0F - below);
    }
    const float lifted =
        below <= 0.25F ? ((16.0F * below - 12.0F) * below + 4.0F) * below : std::sqrt(below);
    return below + (2.0F * source - 1.0F) * (lifted - below);
}

float color_dodge(float below, float source) {
    return below <= 0.0F ? 0.0F : source >= 1.0F ? 1.0F : std::min(1.0F, below / (1.0F - source));
}

float color_burn(float below, float source) {
    return below >= 1.0F    ? 1.0F
           : source <= 0.0F ? 0.0F
                            : 1.0F - std::min(1.0F, (1.0F - below) / source);
}

// One channel of two colours that are not premultiplied.
float blended_channel(BlendMode mode, float below, float source) {
    switch (mode) {
        case BlendMode::normal: return source;
        case BlendMode::multiply: return below * source;
        case BlendMode::darken: return std::min(below, source);
        case BlendMode::lighten: return std::max(below, source);
        case BlendMode::difference: return std::abs(below - source);
        case BlendMode::add: return below + source;
        case BlendMode::subtract: return std::max(below - source, 0.0F);
        default: break;
    }
    const float b = clamped(below);
    const float s = clamped(source);
    switch (mode) {
        case BlendMode::screen: return screen(b, s);
        case BlendMode::overlay: return hard_light(s, b);
        case BlendMode::hard_light: return hard_light(b, s);
        case BlendMode::soft_light: return soft_light(b, s);
        case BlendMode::color_dodge: return color_dodge(b, s);
        case BlendMode::color_burn: return color_burn(b, s);
        default: return b + s - 2.0F * b * s;  // exclusion
    }
}

}  // namespace

Color4f blended(BlendMode mode, const Color4f& below, const Color4f& source, float below_other,
                float source_other) {
    if (mode == BlendMode::normal) {
        return source;
    }
    const float source_alone = 1.0F - below.a - below_other;
    const float below_alone = 1.0F - source.a - source_other;
    if (below.a <= 0.0F || source.a <= 0.0F) {
        return source_alone * source + below_alone * below;
    }
    const auto channel = [&](float b, float s) {
        return s * source_alone + b * below_alone +
               below.a * source.a * blended_channel(mode, b / below.a, s / source.a);
    };
    return {channel(below.r, source.r), channel(below.g, source.g), channel(below.b, source.b),
            source.a * source_alone + below.a * below_alone + source.a * below.a};
}

Drawn with_channels(const Drawn& drawn, const camera::ColorMatrix& channels) {
    const auto of = [&channels](const Color4f& c) {
        const auto sum = [&c](const std::array<double, 3>& weights) {
            return static_cast<float>(weights[0] * c.r + weights[1] * c.g + weights[2] * c.b);
        };
        return Color4f(sum(channels[0]), sum(channels[1]), sum(channels[2]), c.a);
    };
    return {of(drawn.light), of(drawn.display), of(drawn.mirrored), drawn.presence};
}

Drawn composed(const Drawn& below, const Drawn& source, float coverage, BlendMode mode) {
    const float share = coverage * source.presence;
    const float presence = below.presence + share - below.presence * share;
    if (mode == BlendMode::normal) {
        return {(1.0F - share) * below.light + coverage * source.light,
                (1.0F - share) * below.display + coverage * source.display,
                (1.0F - share) * below.mirrored + coverage * source.mirrored, presence};
    }
    const Color4f light =
        blended(mode, below.light, source.light, below.display.a, source.display.a);
    const Color4f display = blended(mode, below.display, source.display);
    const Color4f mirrored =
        source.mirrored + (1.0F - source.light.a - source.display.a) * below.mirrored;
    return {(1.0F - coverage) * below.light + coverage * light,
            (1.0F - coverage) * below.display + coverage * display,
            (1.0F - coverage) * below.mirrored + coverage * mirrored, presence};
}

}  // namespace balcony::render
