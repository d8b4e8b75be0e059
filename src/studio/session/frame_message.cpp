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

namespace balcony::studio {

namespace {

using Picture = std::vector<std::uint8_t>;

constexpr std::array qualities{
    Named{live::Quality::coarse, "coarse"}, Named{live::Quality::preview, "preview"},
    Named{live::Quality::paths, "paths"}, Named{live::Quality::denoised, "denoised"}};

std::optional<Picture> as_jpeg(const live::Frame& frame) {
    constexpr int quality = 85;
    const std::unique_ptr<void, int (*)(tjhandle)> compressor(tjInitCompress(), tjDestroy);
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    const bool is_made =
        compressor && tjCompress2(compressor.get(), frame.pixels.data(),
                                  static_cast<int>(frame.width), 0, static_cast<int>(frame.height),
                                  TJPF_RGB, &bytes, &size, TJSAMP_444, quality, 0) == 0;
    const std::unique_ptr<unsigned char, void (*)(unsigned char*)> freed(bytes, tjFree);
    return is_made ? std::optional(Picture(bytes, bytes + size)) : std::nullopt;
}

std::optional<Picture> as_png(const live::Frame& frame) {
    Result<Picture> made = images::encode({.width = frame.width,
                                           .height = frame.height,
                                           .channels = 3,
                                           .samples = std::span<const std::uint8_t>(frame.pixels)},
                                          "png");
    return std::move(made.value);
}

}  // namespace

std::vector<std::uint8_t> frame_message(const live::Frame& frame) {
    const bool moves = frame.quality == live::Quality::coarse;
    const std::optional<Picture> encoded = moves ? as_jpeg(frame) : as_png(frame);
    const Picture& picture = encoded ? *encoded : frame.pixels;
    const nlohmann::json head{{"kind", "frame"},
                              {"change", frame.change},
                              {"quality", Names<live::Quality>(qualities)[frame.quality].name},
                              {"width", frame.width},
                              {"height", frame.height},
                              {"samples", frame.samples},
                              {"seconds", frame.seconds},
                              {"format", !encoded ? "rgb"
                                         : moves  ? "jpeg"
                                                  : "png"}};
    const std::string text = head.dump();
    std::vector<std::uint8_t> message;
    message.reserve(4 + text.size() + picture.size());
    for (unsigned shift = 0; shift < 32; shift += 8) {
        message.push_back(static_cast<std::uint8_t>(text.size() >> shift));
    }
    message.insert(message.end(), text.begin(), text.end());
    message.insert(message.end(), picture.begin(), picture.end());
    return message;
}

}  // namespace balcony::studio
