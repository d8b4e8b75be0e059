// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>

#include "balcony/film.hpp"

namespace balcony::render {

namespace {

// The compression of highlights of the Khronos PBR Neutral Tone Mapper
// (github.com/KhronosGroup/ToneMapping, 2024), without its offset, which is meant for the Fresnel
// reflection of image-based light: so dark and middle tones are unchanged.
Color3f neutral(const Color3f& light) {
    constexpr float start = 0.8F;
    constexpr float room = 1.0F - start;
    constexpr float desaturation = 0.15F;
    const float peak = std::max({light.x, light.y, light.z});
    if (peak <= start) {
        return light;
    }
    const float compressed = 1.0F - room * room / (peak - start + room);
    const float saturation = 1.0F / (desaturation * (peak - compressed) + 1.0F);
    return saturation * (compressed / peak) * light + Color3f((1.0F - saturation) * compressed);
}

Color3f unchanged(const Color3f& light) { return light; }

template <class Curve>
Color3f by_channel(const Color3f& color, const Curve& curve) {
    return {curve(color.x), curve(color.y), curve(color.z)};
}

// The curve of Hable, "Uncharted 2: HDR Lighting" (GDC 2010), by channel, with his constants for
// shoulder, line and toe. The light is scaled so that middle grey remains middle grey (0.18) when
// light of 16 is white.
Color3f filmic(const Color3f& light) {
    constexpr float white = 16.0F;
    constexpr float scale = 3.70178F;
    const auto curve = [](float x) {
        constexpr float shoulder = 0.15F;
        constexpr float line = 0.50F;
        constexpr float line_angle = 0.10F;
        constexpr float toe = 0.20F;
        constexpr float toe_numerator = 0.02F;
        constexpr float toe_denominator = 0.30F;
        // His sum of two fractions with a common denominator, so that black is exactly black.
        constexpr float toe_angle = toe_numerator / toe_denominator;
        return x * (shoulder * (1.0F - toe_angle) * x + line * (line_angle - toe_angle)) /
               (x * (shoulder * x + line) + toe * toe_denominator);
    };
    const float brightest = curve(scale * white);
    return by_channel(light, [&](float value) {
        return value < white ? curve(scale * value) / brightest : 1.0F;
    });
}

// After Sobotka's AgX (github.com/sobotka/AgX, 2022): in primaries that are nearer to white, so
// that bright saturated light loses its colour instead of changing its hue, the logarithm of the
// light passes a sigmoid. It has middle grey (0.18) as its pivot, where its slope is that of AgX,
// and ends 10 stops below (black) and 6.5 above (white).
class Agx {
public:
    static Color3f display(const Color3f& light) {
        const Color3f inside = saturation * light + Color3f((1.0F - saturation) * mean(light));
        const Color3f shown = by_channel(inside, [](float value) {
            constexpr float encoding = 2.4F;
            return std::pow(std::max(sigmoid(value), 0.0F), encoding);
        });
        return by_channel(shown, [grey = mean(shown)](float value) {
            return (value - (1.0F - saturation) * grey) / saturation;
        });
    }

private:
    static constexpr float saturation = 0.765F;
    static constexpr float middle_grey = 0.18F;
    static constexpr float stops_below = 10.0F;
    static constexpr float stops_above = 6.5F;

    static float mean(const Color3f& color) { return (color.x + color.y + color.z) / 3.0F; }

    // From 0 to 1, for the power 2.4 of a display.
    static float sigmoid(float light) {
        constexpr float pivot = 0.489435F;  // 0.18^(1/2.4)
        const float stops = std::clamp(std::log2(light / middle_grey), -stops_below, stops_above);
        return stops < 0.0F ? pivot - part(-stops, stops_below, pivot)
                            : pivot + part(stops, stops_above, 1.0F - pivot);
    }

    // One half of the sigmoid, from 0 with the slope of the pivot to (width, height).
    static float part(float x, float width, float height) {
        constexpr float power = 1.5F;
        constexpr float slope = 2.4F / (stops_below + stops_above);
        const float bend = std::pow(slope * width / height, power) - 1.0F;
        return slope * x / std::pow(1.0F + bend * std::pow(x / width, power), 1.0F / power);
    }
};

struct ViewRow : Named<ViewTransform> {
    Color3f (*transform)(const Color3f& light);
};

// In the order of the enumerators.
constexpr std::array view_rows{
    ViewRow{{ViewTransform::neutral, "neutral", "highlights above 0.8 are compressed"}, neutral},
    ViewRow{{ViewTransform::standard, "standard", "highlights above 1 are clipped"}, unchanged},
    ViewRow{{ViewTransform::filmic, "filmic", "soft highlights and shadows of film, white at 16"},
            filmic},
    ViewRow{{ViewTransform::agx, "agx", "bright saturated light turns white, as in AgX"},
            Agx::display},
};

constexpr auto view_names = names_in<ViewTransform>(view_rows);

const ViewRow& row_of(ViewTransform view) { return view_rows[static_cast<std::size_t>(view)]; }

// NaN becomes 0.
float clipped(float value) { return value > 0.0F ? std::min(value, 1.0F) : 0.0F; }

}  // namespace

Names<ViewTransform> view_transforms() { return Names<ViewTransform>(view_names); }

Color3f displayed(ViewTransform view, const Color3f& light) {
    const float brightest = 1e30F;  // Its square and quotients remain finite.
    const auto held = [brightest](float value) {
        return value > 0.0F ? std::min(value, brightest) : 0.0F;
    };
    const Color3f color =
        row_of(view).transform(Color3f(held(light.x), held(light.y), held(light.z)));
    return {clipped(color.x), clipped(color.y), clipped(color.z)};
}

}  // namespace balcony::render
