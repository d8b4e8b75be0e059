// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "dataset/frames/frame_layers.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "balcony/display_file.hpp"
#include "balcony/layer_values.hpp"

namespace balcony::dataset {

namespace {

using render::LayerId;

std::vector<std::size_t> shape_of(const FrameData& data, std::size_t channels) {
    std::vector<std::size_t> shape{data.film->height, data.film->width};
    if (channels > 1) {
        shape.push_back(channels);
    }
    return shape;
}

Result<std::string> rgb(const FrameData& data) {
    const auto bytes = render::encode(*data.film, *render::display_format("rgb.png"), data.display);
    return bytes ? Result<std::string>(std::string(bytes->begin(), bytes->end()))
                 : Result<std::string>(bytes.diagnostics);
}

Result<std::string> radiance(const FrameData& data) {
    const render::LayerValues values = render::color_values(*data.film);
    return npy_bytes(shape_of(data, values.channels), std::span<const float>(values.values));
}

// As the layer of the film has it.
template <LayerId id>
Result<std::string> of_film(const FrameData& data) {
    const auto values = render::layer_values(*data.film, id);
    if (!values) {
        return values.diagnostics;
    }
    return npy_bytes(shape_of(data, values->channels), std::span<const float>(values->values));
}

Result<std::string> ray_map(const FrameData& data) {
    const render::DataLayers& film = *data.film->layers;
    std::vector<float> numbers;
    numbers.reserve(6 * data.pixels());
    for (std::size_t i = 0; i < data.pixels(); ++i) {
        for (const auto& v : {film.origin[i], film.direction[i]}) {
            numbers.insert(numbers.end(), {v.x, v.y, v.z});
        }
    }
    return npy_bytes(shape_of(data, 6), std::span<const float>(numbers));
}

Result<std::string> flow(const FrameData& data) {
    return npy_bytes(shape_of(data, 2), std::span(reinterpret_cast<const float*>(data.flow.data()),
                                                  2 * data.flow.size()));
}

Result<std::string> object(const FrameData& data) {
    return npy_bytes(shape_of(data, 1), std::span<const std::uint32_t>(data.film->layers->object));
}

// That which covers most of the pixel; the first one of equals.
Result<std::string> material(const FrameData& data) {
    std::vector<std::uint32_t> ids(data.pixels(), 0);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        float most = 0.0F;
        for (const auto& entry : data.film->means.materials[i].entries) {
            const bool is_first = entry.coverage == most && entry.id != 0 && entry.id < ids[i];
            if (entry.coverage > most || is_first) {
                most = entry.coverage;
                ids[i] = entry.id;
            }
        }
    }
    return npy_bytes(shape_of(data, 1), std::span<const std::uint32_t>(ids));
}

Result<std::string> valid(const FrameData& data) {
    return npy_bytes(shape_of(data, 1), std::span<const std::uint8_t>(data.film->layers->valid));
}

std::span<const FrameLayer> rows() {
    static const std::array all{
        FrameLayer{{"rgb", ".png", "height x width x 3 or 4, 8 bits",
                    "the picture as a display shows it; all frames of a scene have one exposure"},
                   {},
                   true,
                   rgb},
        FrameLayer{{"radiance", ".npy", "height x width x 4, float32",
                    "linear red, green, blue and alpha, without exposure", false},
                   {},
                   true,
                   radiance},
        FrameLayer{{"rays", ".npy", "height x width x 6, float32",
                    "origin and unit direction of the ray of each pixel's middle, in the world"},
                   {LayerId::origin, LayerId::direction},
                   false,
                   ray_map},
        FrameLayer{{"depth", ".npy", "height x width, float32",
                    "length of the ray up to what it meets, in scene units; infinite where it "
                    "meets nothing"},
                   {LayerId::ray_length},
                   false,
                   of_film<LayerId::ray_length>},
        FrameLayer{{"normal", ".npy", "height x width x 3, float32",
                    "unit normal of what the ray meets, in the world; 0 where it meets nothing"},
                   {LayerId::normal},
                   false,
                   of_film<LayerId::normal>},
        FrameLayer{{"flow", ".npy", "height x width x 2, float32",
                    "from the pixel's middle to where the next frame shows the same point, in "
                    "pixels, x to the right and y down; NaN where it does not"},
                   {LayerId::position, LayerId::ray_length},
                   false,
                   flow},
        FrameLayer{{"object", ".npy", "height x width, uint32",
                    "the object that the ray meets: the index in the scene's list plus 1, or 0"},
                   {LayerId::object},
                   false,
                   object},
        FrameLayer{{"material", ".npy", "height x width, uint32",
                    "the material that covers most of the pixel: the index in the scene's list "
                    "plus 1, or 0"},
                   {LayerId::crypto_material},
                   true,
                   material},
        FrameLayer{{"valid", ".npy", "height x width, uint8", "1 where the camera has a ray"},
                   {LayerId::valid},
                   false,
                   valid},
    };
    return all;
}

}  // namespace

std::span<const LayerInfo> layers() {
    static const std::vector<LayerInfo> infos = [] {
        std::vector<LayerInfo> made;
        for (const FrameLayer& one : rows()) {
            made.push_back(one.info);
        }
        return made;
    }();
    return infos;
}

const FrameLayer& frame_layer(std::string_view name) {
    const auto found = std::find_if(rows().begin(), rows().end(),
                                    [&](const FrameLayer& one) { return one.info.name == name; });
    assert(found != rows().end());
    return *found;
}

}  // namespace balcony::dataset
