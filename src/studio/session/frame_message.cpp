// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "studio/session/frame_message.hpp"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <turbojpeg.h>
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

std::optional<Picture> as_jpeg(const Pixels& pixels) {
    constexpr int quality = 85;
    const std::unique_ptr<void, int (*)(tjhandle)> compressor(tjInitCompress(), tjDestroy);
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    const bool is_made = compressor && tjCompress2(compressor.get(), pixels.bytes.data(),
                                                   static_cast<int>(pixels.width), 0,
                                                   static_cast<int>(pixels.height), TJPF_RGB,
                                                   &bytes, &size, TJSAMP_444, quality, 0) == 0;
    const std::unique_ptr<unsigned char, void (*)(unsigned char*)> freed(bytes, tjFree);
    return is_made ? std::optional(Picture(bytes, bytes + size)) : std::nullopt;
}

std::optional<Picture> as_png(const Pixels& pixels) {
    Result<Picture> made = images::encode({.width = pixels.width,
                                           .height = pixels.height,
                                           .channels = 3,
                                           .samples = std::span<const std::uint8_t>(pixels.bytes)},
                                          "png");
    return std::move(made.value);
}

// The length of the head, the head, and the picture. The head gets its size and its format.
std::vector<std::uint8_t> message(nlohmann::json head, const Pixels& pixels, bool is_jpeg) {
    const std::optional<Picture> encoded = is_jpeg ? as_jpeg(pixels) : as_png(pixels);
    const Picture& picture = encoded ? *encoded : pixels.bytes;
    head["width"] = pixels.width;
    head["height"] = pixels.height;
    head["format"] = !encoded ? "rgb" : is_jpeg ? "jpeg" : "png";
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
