// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <exception>
#include <iterator>
#include <stdexcept>
#include <vector>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringVectorAttribute.h>
#include <fmt/format.h>

#include "balcony/film.hpp"
#include "balcony/output_file.hpp"
#include "render/film/displayed_pixel.hpp"

namespace balcony::render {

namespace {

// One channel of the file: its name and its value at a pixel.
struct Channel {
    const char* name;
    float (*value)(const Film& film, std::size_t pixel);
};

Color4f picture(const Film& film, std::size_t pixel) {
    return over_background(film, film.pixel(film.window.x + pixel % film.window.width,
                                            film.window.y + pixel / film.window.width));
}

// The part of the picture that is not light.
Color4f display(const Film& film, std::size_t pixel) {
    return picture(film, pixel) - film.light(film.window.x + pixel % film.window.width,
                                             film.window.y + pixel / film.window.width);
}

constexpr Channel picture_channels[] = {
    {"R", [](const Film& f, std::size_t i) { return picture(f, i).r; }},
    {"G", [](const Film& f, std::size_t i) { return picture(f, i).g; }},
    {"B", [](const Film& f, std::size_t i) { return picture(f, i).b; }},
    {"A", [](const Film& f, std::size_t i) { return picture(f, i).a; }},
};

constexpr Channel display_channels[] = {
    {"display.R", [](const Film& f, std::size_t i) { return display(f, i).r; }},
    {"display.G", [](const Film& f, std::size_t i) { return display(f, i).g; }},
    {"display.B", [](const Film& f, std::size_t i) { return display(f, i).b; }},
    {"display.A", [](const Film& f, std::size_t i) { return display(f, i).a; }},
};

constexpr Channel layer_channels[] = {
    {"ray_length.Z", [](const Film& f, std::size_t i) { return f.layers->ray_length[i]; }},
    {"position.X", [](const Film& f, std::size_t i) { return f.layers->position[i].x; }},
    {"position.Y", [](const Film& f, std::size_t i) { return f.layers->position[i].y; }},
    {"position.Z", [](const Film& f, std::size_t i) { return f.layers->position[i].z; }},
    {"normal.X", [](const Film& f, std::size_t i) { return f.layers->normal[i].x; }},
    {"normal.Y", [](const Film& f, std::size_t i) { return f.layers->normal[i].y; }},
    {"normal.Z", [](const Film& f, std::size_t i) { return f.layers->normal[i].z; }},
    {"albedo.R", [](const Film& f, std::size_t i) { return f.layers->albedo[i].x; }},
    {"albedo.G", [](const Film& f, std::size_t i) { return f.layers->albedo[i].y; }},
    {"albedo.B", [](const Film& f, std::size_t i) { return f.layers->albedo[i].z; }},
    {"origin.X", [](const Film& f, std::size_t i) { return f.layers->origin[i].x; }},
    {"origin.Y", [](const Film& f, std::size_t i) { return f.layers->origin[i].y; }},
    {"origin.Z", [](const Film& f, std::size_t i) { return f.layers->origin[i].z; }},
    {"direction.X", [](const Film& f, std::size_t i) { return f.layers->direction[i].x; }},
    {"direction.Y", [](const Film& f, std::size_t i) { return f.layers->direction[i].y; }},
    {"direction.Z", [](const Film& f, std::size_t i) { return f.layers->direction[i].z; }},
    {"parameters.U", [](const Film& f, std::size_t i) { return f.layers->parameters[i].x; }},
    {"parameters.V", [](const Film& f, std::size_t i) { return f.layers->parameters[i].y; }},
    {"valid.A",
     [](const Film& f, std::size_t i) { return static_cast<float>(f.layers->valid[i]); }},
};

constexpr const char* object_channel = "object.ID";
constexpr const char* layer_channel = "layer.ID";

// The stream of an output file for OpenEXR.
class ExrStream final : public Imf::OStream {
public:
    explicit ExrStream(std::ofstream& stream) : Imf::OStream("picture.exr"), stream_(stream) {}

    void write(const char* bytes, int count) override {
        stream_.write(bytes, count);
        require_good();
    }
    std::uint64_t tellp() override { return static_cast<std::uint64_t>(stream_.tellp()); }
    void seekp(std::uint64_t position) override {
        stream_.seekp(static_cast<std::streamoff>(position));
        require_good();
    }

private:
    void require_good() const {
        if (!stream_) {
            throw std::runtime_error("writing failed");
        }
    }

    std::ofstream& stream_;
};

std::vector<Channel> channels_of(const Film& film) {
    std::vector<Channel> channels(std::begin(picture_channels), std::end(picture_channels));
    if (!film.display.empty() || film.background) {
        channels.insert(channels.end(), std::begin(display_channels), std::end(display_channels));
    }
    if (film.layers) {
        channels.insert(channels.end(), std::begin(layer_channels), std::end(layer_channels));
    }
    return channels;
}

Imf::Header make_header(const Film& film, const std::vector<Channel>& channels) {
    const auto box = [](const Region& region) {
        const Imath::V2i first(static_cast<int>(region.x), static_cast<int>(region.y));
        const Imath::V2i size(static_cast<int>(region.width), static_cast<int>(region.height));
        return Imath::Box2i(first, first + size - Imath::V2i(1, 1));
    };
    Imf::Header header(box({0, 0, film.width, film.height}), box(film.window));
    header.compression() = Imf::ZIP_COMPRESSION;
    header.zipCompressionLevel() = 2;
    for (const Channel& channel : channels) {
        header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
    }
    if (film.layers) {
        header.channels().insert(object_channel, Imf::Channel(Imf::UINT));
        header.insert("objects", Imf::StringVectorAttribute(film.objects));
        header.channels().insert(layer_channel, Imf::Channel(Imf::UINT));
        header.insert("layers", Imf::StringVectorAttribute(film.picture_layers));
    }
    return header;
}

// Some rows at a time, by channel.
void write_pixels(const Film& film, const std::vector<Channel>& channels, Imf::OutputFile& output) {
    constexpr std::size_t rows_at_once = 64;
    const std::size_t width = film.window.width;
    const std::size_t plane = width * rows_at_once;
    std::vector<float> values(plane * channels.size());
    std::vector<std::uint32_t> objects(film.layers ? plane : 0);
    std::vector<std::uint32_t> layers(film.layers ? plane : 0);
    for (std::size_t first = 0; first < film.window.height; first += rows_at_once) {
        const std::size_t rows = std::min(rows_at_once, film.window.height - first);
        Imf::FrameBuffer buffer;
        // OpenEXR addresses pixels from the picture's top left, so the base of a slice is before
        // the current rows.
        const auto slice = [&](Imf::PixelType type, void* data) {
            const std::size_t pixels = (film.window.y + first) * width + film.window.x;
            const auto before = static_cast<std::ptrdiff_t>(pixels * sizeof(float));
            return Imf::Slice(type, static_cast<char*>(data) - before, sizeof(float),
                              sizeof(float) * width);
        };
        for (std::size_t c = 0; c < channels.size(); ++c) {
            float* data = values.data() + c * plane;
            for (std::size_t i = 0; i < rows * width; ++i) {
                const float value = channels[c].value(film, first * width + i);
                data[i] = std::isnan(value) ? 0.0F : value;
            }
            buffer.insert(channels[c].name, slice(Imf::FLOAT, data));
        }
        if (film.layers) {
            std::copy_n(film.layers->object.begin() + static_cast<std::ptrdiff_t>(first * width),
                        rows * width, objects.begin());
            buffer.insert(object_channel, slice(Imf::UINT, objects.data()));
            std::copy_n(film.layers->layer.begin() + static_cast<std::ptrdiff_t>(first * width),
                        rows * width, layers.begin());
            buffer.insert(layer_channel, slice(Imf::UINT, layers.data()));
        }
        output.setFrameBuffer(buffer);
        output.writePixels(static_cast<int>(rows));
    }
}

}  // namespace

Diagnostics write_exr(const Film& film, const std::filesystem::path& file) {
    OutputFile output(file);
    try {
        const std::vector<Channel> channels = channels_of(film);
        ExrStream stream(output.stream());
        Imf::OutputFile exr(stream, make_header(film, channels));
        write_pixels(film, channels, exr);
    } catch (const std::exception& failed) {
        return {output.stream()
                    ? error(fmt::format("'{}' cannot be written: {}", file.string(), failed.what()))
                    : output.failure()};
    }
    return output.commit();
}

}  // namespace balcony::render
