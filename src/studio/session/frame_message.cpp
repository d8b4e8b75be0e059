// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "studio/session/frame_message.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "balcony/images.hpp"
#include "balcony/names.hpp"
#include "lsp/rpc.hpp"

namespace balcony::studio {

namespace {

using Picture = std::vector<std::uint8_t>;

constexpr std::array qualities{
    Named{live::Quality::coarse, "coarse"}, Named{live::Quality::preview, "preview"},
    Named{live::Quality::paths, "paths"}, Named{live::Quality::denoised, "denoised"}};

/// sRGB, as render::display_pixels().
struct Pixels {
    std::size_t width;
    std::size_t height;
    const Picture& bytes;
};

std::optional<Picture> encoded(const Pixels& pixels, std::string_view format) {
    Result<Picture> made = images::encode({.width = pixels.width,
                                           .height = pixels.height,
                                           .channels = 3,
                                           .samples = std::span<const std::uint8_t>(pixels.bytes)},
                                          format);
    return std::move(made.value);
}

// The length of the head, the head, and the picture. The head gets its size and its format.
std::vector<std::uint8_t> message(nlohmann::json head, const Pixels& pixels, bool is_jpeg) {
    const std::string_view format = is_jpeg ? "jpeg" : "png";
    const std::optional<Picture> file = encoded(pixels, format);
    const Picture& picture = file ? *file : pixels.bytes;
    head["width"] = pixels.width;
    head["height"] = pixels.height;
    head["format"] = file ? format : "rgb";
    const std::string text = lsp::text_of(head);
    std::vector<std::uint8_t> made;
    made.reserve(4 + text.size() + picture.size());
    for (unsigned shift = 0; shift < 32; shift += 8) {
        made.push_back(static_cast<std::uint8_t>(text.size() >> shift));
    }
    made.insert(made.end(), text.begin(), text.end());
    made.insert(made.end(), picture.begin(), picture.end());
    return made;
}

}  // namespace

std::vector<std::uint8_t> frame_message(const live::Frame& frame) {
    return message({{"kind", "frame"},
                    {"change", frame.change},
                    {"quality", Names<live::Quality>(qualities)[frame.quality].name},
                    {"samples", frame.samples},
                    {"seconds", frame.seconds}},
                   {frame.width, frame.height, frame.pixels},
                   frame.quality == live::Quality::coarse);
}

std::vector<std::uint8_t> thumbnail_message(const live::Thumbnail& thumbnail) {
    return message({{"kind", "thumbnail"}, {"name", thumbnail.camera}},
                   {thumbnail.width, thumbnail.height, thumbnail.pixels}, true);
}

}  // namespace balcony::studio
