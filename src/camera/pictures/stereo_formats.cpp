// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The views of both eyes in one picture.

#include "balcony/stereo.hpp"

#include <algorithm>
#include <cmath>

#include "balcony/make_stage.hpp"

namespace balcony::camera {

namespace {

constexpr std::array stereo_rows = {
    Named{StereoFormat::side_by_side, "side_by_side",
          "twice as wide, the left eye's picture on the left"},
    Named{StereoFormat::cross_eyed, "cross_eyed",
          "twice as wide, the left eye's picture on the right"},
    Named{StereoFormat::top_bottom, "top_bottom", "twice as high, the left eye's picture on top"},
    Named{StereoFormat::anaglyph, "anaglyph",
          "for red and cyan glasses, in colours that ghost least"},
    Named{StereoFormat::anaglyph_color, "anaglyph_color",
          "for red and cyan glasses, in the full colours"},
    Named{StereoFormat::anaglyph_grey, "anaglyph_grey", "for red and cyan glasses, in grey"},
    Named{StereoFormat::left, "left", "the left eye's picture alone"},
    Named{StereoFormat::right, "right", "the right eye's picture alone"},
};

constexpr std::array<double, 3> no_light{0.0, 0.0, 0.0};
constexpr std::array<double, 3> luminance_weights{0.2126, 0.7152, 0.0722};  // Rec. 709.

/// The colours that an eye contributes to an anaglyph.
std::optional<ColorMatrix> channels_of(StereoFormat format, bool left) {
    switch (format) {
        case StereoFormat::anaglyph:
            return left ? ColorMatrix{{{0.437, 0.449, 0.164},
                                       {-0.062, -0.062, -0.024},
                                       {-0.048, -0.050, -0.017}}}
                        : ColorMatrix{{{-0.011, -0.032, -0.007},
                                       {0.377, 0.761, 0.009},
                                       {-0.026, -0.093, 1.234}}};
        case StereoFormat::anaglyph_color:
            return left ? ColorMatrix{{{1.0, 0.0, 0.0}, no_light, no_light}}
                        : ColorMatrix{{no_light, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
        case StereoFormat::anaglyph_grey:
            return left ? ColorMatrix{{luminance_weights, no_light, no_light}}
                        : ColorMatrix{{no_light, luminance_weights, luminance_weights}};
        default: return std::nullopt;
    }
}

/// The corners of an eye's place, as fractions from the top left.
std::array<double, 4> place_of(StereoFormat format, bool left) {
    switch (format) {
        case StereoFormat::side_by_side:
            return left ? std::array{0.0, 0.0, 0.5, 1.0} : std::array{0.5, 0.0, 1.0, 1.0};
        case StereoFormat::cross_eyed: return place_of(StereoFormat::side_by_side, !left);
        case StereoFormat::top_bottom:
            return left ? std::array{0.0, 0.0, 1.0, 0.5} : std::array{0.0, 0.5, 1.0, 1.0};
        default: return {0.0, 0.0, 1.0, 1.0};
    }
}

Result<Picture> seen_by(const Picture& picture, const StereoPair& pair, bool left) {
    const StageEntry* row = catalogue().find(StageKind::stereo_view, "stereo");
    std::vector<NamedValue> values{
        {"separation", pair.separation}, {"side", left ? -1.0 : 1.0}, {"baseline", pair.baseline}};
    if (pair.convergence) {
        values.push_back({"convergence", *pair.convergence});
    }
    if (pair.merge) {
        values.push_back({"merge", Tuple{radians((*pair.merge)[0]), radians((*pair.merge)[1])}});
    }
    StageResult stage = make_stage(*row, values);
    return stage ? picture.with_stereo(std::static_pointer_cast<const StereoView>(*stage))
                 : Result<Picture>(std::move(stage.diagnostics));
}

Result<Layer> layer_of(const Picture& picture, StereoFormat format, const StereoPair& pair,
                       bool left) {
    Result<Picture> seen = seen_by(picture, pair, left);
    if (!seen) {
        return std::move(seen.diagnostics);
    }
    const Camera* camera = seen->only_camera();
    Layer layer{left ? "left" : "right", camera != nullptr
                                             ? decltype(Layer::content)(*camera)
                                             : std::make_shared<const Picture>(*seen)};
    const auto [x, y, right, bottom] = place_of(format, left);
    if (right - x < 1.0 || bottom - y < 1.0) {
        Result<PictureArrangerPointer> place =
            make_stage<PictureArranger>("place", {{"from", {x, y}}, {"to", {right, bottom}}});
        if (!place) {
            return std::move(place.diagnostics);
        }
        layer.arrangers.push_back(std::move(*place));
    }
    layer.fit = picture.parts().fit;
    layer.channels = channels_of(format, left);
    return layer;
}

}  // namespace

Names<StereoFormat> stereo_formats() { return Names<StereoFormat>(stereo_rows); }

Result<Picture> stereo_picture(const Picture& picture, StereoFormat format,
                               const StereoPair& pair) {
    if (format == StereoFormat::left || format == StereoFormat::right) {
        return seen_by(picture, pair, format == StereoFormat::left);
    }
    Picture::Parts parts;
    parts.name = picture.name();
    for (const bool left : {true, false}) {
        Result<Layer> layer = layer_of(picture, format, pair, left);
        if (!layer) {
            return std::move(layer.diagnostics);
        }
        parts.layers.push_back(std::move(*layer));
    }
    parts.layers.back().blend = parts.layers.back().channels ? BlendMode::add : BlendMode::normal;
    const auto [x, y, right, bottom] = place_of(format, true);
    const double columns = std::round(1.0 / (right - x));
    const double lines = std::round(1.0 / (bottom - y));
    if (const auto& size = picture.parts().size) {
        parts.size = std::array{(*size)[0] * static_cast<std::size_t>(columns),
                                (*size)[1] * static_cast<std::size_t>(lines)};
    }
    parts.aspect = picture.aspect() * columns / lines;
    parts.fit = Fit::stretch;
    return Picture::make(std::move(parts));
}

}  // namespace balcony::camera
