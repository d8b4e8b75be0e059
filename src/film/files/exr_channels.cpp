// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "film/files/exr_channels.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <span>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfStringVectorAttribute.h>
#include <fmt/format.h>

#include "film/display/displayed_pixel.hpp"
#include "film/sums/cryptomatte.hpp"
#include "film/sums/layer_rows.hpp"
#include "film/sums/tile_image.hpp"

namespace balcony::render {

namespace {

void put(const Color4f& color, float* channels) {
    const float values[] = {color.r, color.g, color.b, color.a};
    std::copy_n(values, 4, channels);
}

Color4f picture(const Film& film, std::size_t x, std::size_t y) {
    return over_background(film, film.pixel(x, y));
}

std::vector<std::string> channel_names(const LayerInfo& layer) {
    std::vector<std::string> names;
    for (std::size_t level = 0; level < layer.levels; ++level) {
        for (const char letter : layer.channels) {
            names.push_back(layer.levels == 1
                                ? fmt::format("{}.{}", layer.name, letter)
                                : fmt::format("{}{:02}.{}", layer.name, level, letter));
        }
    }
    return names;
}

void add_attributes(const Film& film, Imf::Header& header) {
    const auto add = [&](LayerId id, std::span<const std::string> names) {
        if (film.layer_set.contains(id)) {
            const std::string_view name = layers()[static_cast<std::size_t>(id)].name;
            for (const auto& [key, value] : matte_attributes(name, names)) {
                header.insert(key, Imf::StringAttribute(value));
            }
        }
    };
    add(LayerId::crypto_object, film.objects);
    add(LayerId::crypto_material, film.materials);
    if (film.layer_set.contains(LayerId::object)) {
        header.insert("objects", Imf::StringVectorAttribute(film.objects));
    }
    if (film.layer_set.contains(LayerId::picture_layer)) {
        header.insert("layers", Imf::StringVectorAttribute(film.picture_layers));
    }
}

}  // namespace

std::vector<ChannelGroup> channel_groups(const Film& film) {
    std::vector<ChannelGroup> groups{
        {{"R", "G", "B", "A"}, [](const Film& f, std::size_t x, std::size_t y, float* channels) {
             put(picture(f, x, y), channels);
         }}};
    if (!film.display.empty() || film.background) {
        groups.push_back({{"display.R", "display.G", "display.B", "display.A"},
                          [](const Film& f, std::size_t x, std::size_t y, float* channels) {
                              put(picture(f, x, y) - f.light(x, y), channels);
                          }});
    }
    for (const LayerRow& row : layer_rows()) {
        if (film.layer_set.contains(row.info.id) && row.complete(film)) {
            groups.push_back({channel_names(row.info), row.read});
        }
    }
    return groups;
}

Imf::Header exr_header(const Film& film, const Region& window,
                       const std::vector<ChannelGroup>& groups) {
    const auto box = [](const Region& region) {
        const Imath::V2i first(static_cast<int>(region.x), static_cast<int>(region.y));
        const Imath::V2i size(static_cast<int>(region.width), static_cast<int>(region.height));
        return Imath::Box2i(first, first + size - Imath::V2i(1, 1));
    };
    Imf::Header header(box({0, 0, film.width, film.height}), box(window));
    header.compression() = Imf::ZIP_COMPRESSION;
    header.zipCompressionLevel() = 2;
    for (const ChannelGroup& group : groups) {
        for (const std::string& name : group.names) {
            header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        }
    }
    add_attributes(film, header);
    return header;
}

ChannelValues::ChannelValues(const std::vector<ChannelGroup>& groups) : groups_(&groups) {
    for (const ChannelGroup& group : groups) {
        channels_ += group.names.size();
    }
}

std::size_t ChannelValues::rows_at_once(std::size_t width) const {
    constexpr std::size_t most_rows = 64;
    constexpr std::size_t most_values = (std::size_t{64} << 20U) / sizeof(float);
    return std::clamp(most_values / (width * channels_), std::size_t{1}, most_rows);
}

Diagnostic exr_failure(const std::filesystem::path& file, const std::exception& failed) {
    const bool out_of_memory = dynamic_cast<const std::bad_alloc*>(&failed) != nullptr;
    return error(Kind::environment,
                 fmt::format("'{}' cannot be written: {}", file.string(),
                             out_of_memory ? "out of memory" : failed.what()),
                 out_of_memory ? "make the picture smaller, or omit layers" : "");
}

Imf::FrameBuffer ChannelValues::read(const Film& film, const Region& region) {
    values_.resize(region.size() * channels_);
    Imf::FrameBuffer buffer;
    std::size_t channel = 0;
    for (const ChannelGroup& group : *groups_) {
        for_each_pixel(region, [&](std::size_t i, std::size_t x, std::size_t y) {
            group.read(film, x, y, values_.data() + i * channels_ + channel);
        });
        for (const std::string& name : group.names) {
            // OpenEXR addresses pixels from the picture's top left, so the base of a slice is
            // before the region.
            const std::size_t stride = channels_ * sizeof(float);
            const auto before =
                static_cast<std::ptrdiff_t>((region.y * region.width + region.x) * stride);
            buffer.insert(
                name,
                Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values_.data() + channel) - before,
                           stride, stride * region.width));
            ++channel;
        }
    }
    std::replace_if(
        values_.begin(), values_.end(), [](float value) { return std::isnan(value); }, 0.0F);
    return buffer;
}

}  // namespace balcony::render
