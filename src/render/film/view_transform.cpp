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

struct Row {
    std::string_view name;
    std::string_view meaning;
    Color3f (*transform)(const Color3f& light);
};

// In the order of the enumerators.
constexpr std::array rows{
    Row{"neutral", "highlights above 0.8 are compressed", neutral},
    Row{"standard", "highlights above 1 are clipped", unchanged},
};

const Row& row_of(ViewTransform view) { return rows[static_cast<std::size_t>(view)]; }

// NaN becomes 0.
float clipped(float value) { return value > 0.0F ? std::min(value, 1.0F) : 0.0F; }

}  // namespace

std::string_view name_of(ViewTransform view) { return row_of(view).name; }

std::string_view meaning_of(ViewTransform view) { return row_of(view).meaning; }

std::optional<ViewTransform> find_view_transform(std::string_view name) {
    const auto* const row =
        std::find_if(rows.begin(), rows.end(), [name](const Row& one) { return one.name == name; });
    return row != rows.end() ? std::optional(static_cast<ViewTransform>(row - rows.begin()))
                             : std::nullopt;
}

std::vector<std::string> view_transform_names() {
    std::vector<std::string> names;
    for (const Row& row : rows) {
        names.emplace_back(row.name);
    }
    return names;
}

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
