// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "page/textures.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "balcony/images.hpp"

namespace balcony::page {

namespace {

using Bytes = std::vector<std::uint8_t>;

/// The type of a file that browsers read; empty for other files.
std::string_view type_of(std::span<const std::uint8_t> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()),
                                std::min<std::size_t>(bytes.size(), 12));
    return text.starts_with("\x89PNG")                            ? "image/png"
           : text.starts_with("\xff\xd8\xff")                     ? "image/jpeg"
           : text.starts_with("RIFF") && text.substr(8) == "WEBP" ? "image/webp"
                                                                  : "";
}

// Pixels of three or four channels, of an image of any number of them.
Bytes spread(const Bytes& values, std::size_t from, std::size_t to) {
    Bytes made;
    made.reserve(values.size() / from * to);
    for (std::size_t i = 0; i < values.size(); i += from) {
        const bool is_grey = from < 3;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            made.push_back(values[i + (is_grey ? 0 : channel)]);
        }
        if (to == 4) {
            made.push_back(values[i + from - 1]);
        }
    }
    return made;
}

// The means of squares of pixels, of which those at the border may have fewer.
images::Raster reduced(const Bytes& pixels, std::size_t width, std::size_t height,
                       std::size_t channels, std::size_t side, Bytes& into) {
    const std::size_t step = (std::max(width, height) + side - 1) / side;
    const std::size_t columns = (width + step - 1) / step;
    const std::size_t rows = (height + step - 1) / step;
    into.clear();
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
            std::array<std::size_t, 4> sum{};
            std::size_t count = 0;
            for (std::size_t y = row * step; y < std::min(height, (row + 1) * step); ++y) {
                for (std::size_t x = column * step; x < std::min(width, (column + 1) * step); ++x) {
                    for (std::size_t c = 0; c < channels; ++c) {
                        sum[c] += pixels[(y * width + x) * channels + c];
                    }
                    ++count;
                }
            }
            for (std::size_t c = 0; c < channels; ++c) {
                into.push_back(static_cast<std::uint8_t>((sum[c] + count / 2) / count));
            }
        }
    }
    return {columns, rows, channels, std::span<const std::uint8_t>(into)};
}

struct Picture {
    Bytes bytes;
    std::string_view type;
};

// The image as it is, if a browser reads it and it is small enough, otherwise another file.
Result<Picture> picture_of(const scene::Texture& texture, std::size_t side) {
    Bytes bytes = *texture.bytes;
    if (bytes.empty()) {
        std::ifstream stream(texture.file, std::ios::binary);
        bytes.assign(std::istreambuf_iterator<char>(stream), {});
    }
    const Result<std::unique_ptr<images::ImageFile>> image =
        images::ImageFile::open(texture.file, bytes);
    if (!image) {
        return image.diagnostics;
    }
    images::ImageFile& file = **image;
    const std::string_view type = type_of(bytes);
    if (!type.empty() && std::max(file.width(), file.height()) <= side) {
        return Picture{std::move(bytes), type};
    }
    Bytes values(file.width() * file.height() * file.channels());
    if (auto failure = file.read_rows(0, file.height(), values)) {
        return std::move(*failure);
    }
    const bool has_alpha = file.channels() == 2 || file.channels() == 4;
    const std::size_t channels = has_alpha ? 4 : 3;
    Bytes small;
    const images::Raster raster = reduced(spread(values, file.channels(), channels), file.width(),
                                          file.height(), channels, side, small);
    const bool is_jpeg = type == "image/jpeg";
    Result<Bytes> encoded = images::encode(raster, is_jpeg ? "jpeg" : "png");
    if (!encoded) {
        return std::move(encoded.diagnostics);
    }
    return Picture{std::move(*encoded), is_jpeg ? "image/jpeg" : "image/png"};
}

std::string_view name_of(scene::Wrap wrap) {
    return wrap == scene::Wrap::repeat ? "repeat" : wrap == scene::Wrap::clamp ? "clamp" : "mirror";
}

}  // namespace

std::set<scene::TextureIndex> shown_textures(const scene::Scene& scene) {
    std::set<scene::TextureIndex> shown;
    for (const scene::Instance& instance : scene.instances) {
        const scene::Mesh& mesh = *scene.meshes[instance.mesh.value()];
        const scene::Material& material = scene.materials[mesh.material.value()];
        for (const scene::TextureUse* use : shown_uses(material)) {
            if (use->valid()) {
                shown.insert(use->index);
            }
        }
    }
    return shown;
}

std::array<const scene::TextureUse*, 4> shown_uses(const scene::Material& material) {
    return {&material.base_color_texture, &material.opacity_texture, &material.emission_texture,
            &material.normal_texture};
}

Result<nlohmann::json> add_textures(const scene::Scene& scene,
                                    const std::set<scene::TextureIndex>& textures, std::size_t side,
                                    Blob& blob) {
    Diagnostics found;
    nlohmann::json all = nlohmann::json::array();
    for (const scene::TextureIndex index : textures) {
        const scene::Texture& texture = scene.textures[index.value()];
        Result<Picture> picture = picture_of(texture, side);
        if (!picture) {
            found.push_back(
                warning(fmt::format("texture '{}' is white in the page: {}", texture.name,
                                    picture.diagnostics.front().message)));
            all.push_back(nullptr);
            continue;
        }
        const std::size_t begin = blob.add_bytes(picture->bytes);
        all.push_back({{"begin", begin},
                       {"size", picture->bytes.size()},
                       {"type", picture->type},
                       {"wrap", {name_of(texture.wrap_u), name_of(texture.wrap_v)}},
                       {"interpolated", texture.interpolated}});
    }
    return {std::move(all), std::move(found)};
}

}  // namespace balcony::page
