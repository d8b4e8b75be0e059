// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfStringVectorAttribute.h>
#include <fmt/format.h>

#include "balcony/bands.hpp"
#include "balcony/film.hpp"
#include "balcony/output_file.hpp"
#include "render/film/cryptomatte.hpp"
#include "render/film/displayed_pixel.hpp"
#include "render/film/layer_rows.hpp"
#include "render/film/tile_image.hpp"

namespace balcony::render {

namespace {

// Some channels of the file, whose values are computed together.
struct Group {
    std::vector<std::string> names;
    void (*read)(const Film& film, std::size_t x, std::size_t y, float* channels);
};

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

// The picture, its part that is not light, and the layers.
std::vector<Group> groups_of(const Film& film) {
    std::vector<Group> groups{
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

Imf::Header make_header(const Film& film, const Region& window, const std::vector<Group>& groups) {
    const auto box = [](const Region& region) {
        const Imath::V2i first(static_cast<int>(region.x), static_cast<int>(region.y));
        const Imath::V2i size(static_cast<int>(region.width), static_cast<int>(region.height));
        return Imath::Box2i(first, first + size - Imath::V2i(1, 1));
    };
    Imf::Header header(box({0, 0, film.width, film.height}), box(window));
    header.compression() = Imf::ZIP_COMPRESSION;
    header.zipCompressionLevel() = 2;
    for (const Group& group : groups) {
        for (const std::string& name : group.names) {
            header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        }
    }
    add_attributes(film, header);
    return header;
}

// Some rows at a time, by pixel.
void write_pixels(const Film& film, const std::vector<Group>& groups, Imf::OutputFile& output) {
    constexpr std::size_t rows_at_once = 64;
    const Region& window = film.window;
    std::size_t channels = 0;
    for (const Group& group : groups) {
        channels += group.names.size();
    }
    std::vector<float> values(window.width * rows_at_once * channels);
    for (std::size_t first = 0; first < window.height; first += rows_at_once) {
        const Region band{window.x, window.y + first, window.width,
                          std::min(rows_at_once, window.height - first)};
        Imf::FrameBuffer buffer;
        std::size_t channel = 0;
        for (const Group& group : groups) {
            for_each_pixel(band, [&](std::size_t i, std::size_t x, std::size_t y) {
                group.read(film, x, y, values.data() + i * channels + channel);
            });
            for (const std::string& name : group.names) {
                // OpenEXR addresses pixels from the picture's top left, so the base of a slice is
                // before the current band.
                const std::size_t stride = channels * sizeof(float);
                const auto before =
                    static_cast<std::ptrdiff_t>((band.y * band.width + band.x) * stride);
                buffer.insert(name,
                              Imf::Slice(Imf::FLOAT,
                                         reinterpret_cast<char*>(values.data() + channel) - before,
                                         stride, stride * band.width));
                ++channel;
            }
        }
        std::replace_if(
            values.begin(), values.end(), [](float value) { return std::isnan(value); }, 0.0F);
        output.setFrameBuffer(buffer);
        output.writePixels(static_cast<int>(band.height));
    }
}

}  // namespace

// The parts exist from the first band on.
struct BandedFile::State {
    State(const std::filesystem::path& path, const Region& region)
        : name(path.string()), window(region), output(path), stream(output.stream()) {}

    // The reason of a failure is the stream's, or else OpenEXR's.
    [[nodiscard]] Diagnostics failure(const std::exception& failed) {
        return {output.stream()
                    ? error(fmt::format("'{}' cannot be written: {}", name, failed.what()))
                    : output.failure()};
    }

    std::string name;
    Region window;
    OutputFile output;
    ExrStream stream;
    std::vector<Group> groups;
    std::unique_ptr<Imf::OutputFile> exr;
};

BandedFile::BandedFile(const std::filesystem::path& file, const Region& window)
    : state_(std::make_unique<State>(file, window)) {}
BandedFile::BandedFile(BandedFile&&) noexcept = default;
BandedFile::~BandedFile() = default;

Diagnostics BandedFile::add(const Film& band) {
    try {
        if (!state_->exr) {
            state_->groups = groups_of(band);
            state_->exr = std::make_unique<Imf::OutputFile>(
                state_->stream, make_header(band, state_->window, state_->groups));
        }
        write_pixels(band, state_->groups, *state_->exr);
    } catch (const std::exception& failed) {
        return state_->failure(failed);
    }
    return {};
}

Diagnostics BandedFile::commit() {
    try {
        state_->exr.reset();
    } catch (const std::exception& failed) {
        return state_->failure(failed);
    }
    return state_->output.commit();
}

Diagnostics write_exr(const Film& film, const std::filesystem::path& file) {
    BandedFile output(file, film.window);
    if (Diagnostics found = output.add(film); has_errors(found)) {
        return found;
    }
    return output.commit();
}

}  // namespace balcony::render
