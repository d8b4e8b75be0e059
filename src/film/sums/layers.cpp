// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The table of layers.

#include "balcony/layers.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include "film/sums/cryptomatte.hpp"
#include "film/sums/film_arrays.hpp"
#include "film/sums/layer_rows.hpp"
#include "film/sums/sample_halves.hpp"

namespace balcony::render {

namespace {

// ------------------------------------------------------------------------ values as channels

template <class Number>
requires std::is_arithmetic_v<Number>
void put(Number value, float* channels) { *channels = static_cast<float>(value); }
void put(const Color3f& value, float* channels) { std::copy_n(&value.x, 3, channels); }
void put(const V3f& value, float* channels) { std::copy_n(&value.x, 3, channels); }
void put(const V4f& value, float* channels) { std::copy_n(&value.x, 4, channels); }
void put(const Moments& value, float* channels) { put(value.mean, channels); }

// --------------------------------------------------------------------------- kinds of rows

// The vector of a film that a pointer to a member of one of its parts means.
template <class AnyFilm, class T>
auto* vector_of(AnyFilm& film, std::vector<T> DataLayers::*member) {
    return film.layers ? &((*film.layers).*member) : nullptr;
}
template <class AnyFilm, class T>
auto* vector_of(AnyFilm& film, std::vector<T> MeanLayers::*member) {
    return &(film.means.*member);
}

template <auto Member>
void allocate(Film& film) {
    auto& values = *vector_of(film, Member);
    using Value = typename std::decay_t<decltype(values)>::value_type;
    values.assign(film.window.size(), zero<Value>());
}

template <auto Member>
bool complete(const Film& film) {
    const auto* values = vector_of(film, Member);
    return values != nullptr && values->size() == film.window.size();
}

// A layer with a vector of its own, whose elements are the values.
template <auto Member>
constexpr LayerRow values(const LayerInfo& info) {
    return {info, allocate<Member>, complete<Member>,
            [](const Film& film, std::size_t x, std::size_t y, float* channels) {
                put((*vector_of(film, Member))[film.index(x, y)], channels);
            }};
}

// The same with sums over the samples.
template <auto Member>
constexpr LayerRow sums(const LayerInfo& info) {
    return {info, allocate<Member>, complete<Member>,
            [](const Film& film, std::size_t x, std::size_t y, float* channels) {
                const std::uint32_t samples = std::max(film.samples(x, y), 1U);
                put(V3f((*vector_of(film, Member))[film.index(x, y)] / samples), channels);
            }};
}

// The same with sums over the first half of the samples.
template <auto Member>
constexpr LayerRow halves(const LayerInfo& info) {
    return {info, allocate<Member>, complete<Member>,
            [](const Film& film, std::size_t x, std::size_t y, float* channels) {
                const std::uint32_t samples = first_half_of(std::max(film.samples(x, y), 1U));
                put(V3f(V3d((*vector_of(film, Member))[film.index(x, y)].first) / samples),
                    channels);
            }};
}

using Read = void (*)(const Film& film, std::size_t x, std::size_t y, float* channels);

template <auto Member>
constexpr LayerRow matte(const LayerInfo& info, Read read) {
    return {info, allocate<Member>, complete<Member>, read};
}

// A layer that is computed from the rest of the film.
constexpr LayerRow computed(const LayerInfo& info, Read read) {
    return {info, [](Film&) {}, [](const Film&) { return true; }, read};
}

// --------------------------------------------------------------------------- computed layers

// Texture coordinates as Blender has them: with alpha.
void read_parameters(const Film& film, std::size_t x, std::size_t y, float* channels) {
    const std::size_t at = film.index(x, y);
    channels[0] = film.layers->parameters[at].x;
    channels[1] = film.layers->parameters[at].y;
    channels[2] = film.layers->valid[at];
}

void read_samples(const Film& film, std::size_t x, std::size_t y, float* channels) {
    put(film.samples(x, y), channels);
}

// What is neither emission nor direct light, so that the three add up to the light of the picture.
void read_indirect(const Film& film, std::size_t x, std::size_t y, float* channels) {
    const Color4f light = film.rendered_light(x, y);
    const std::size_t at = film.index(x, y);
    const V3d known = (film.means.emission[at] + film.means.direct[at]) /
                      static_cast<double>(std::max(film.samples(x, y), 1U));
    put(V3f(V3d(V3f(light.r, light.g, light.b)) - known), channels);
}

void read_variance(const Film& film, std::size_t x, std::size_t y, float* channels) {
    const Color4d of_sample = film.variance(x, y);
    const double samples = std::max(film.samples(x, y), 1U);
    put(V3f(V3d(of_sample.r, of_sample.g, of_sample.b) / samples), channels);
}

void read_noisy(const Film& film, std::size_t x, std::size_t y, float* channels) {
    const Color4f light = film.rendered_light(x, y);
    const float values[] = {light.r, light.g, light.b, light.a};
    std::copy_n(values, 4, channels);
}

void read_crypto_object(const Film& film, std::size_t x, std::size_t y, float* channels) {
    read_matte(film.means.objects[film.index(x, y)], film.objects, film.samples(x, y), channels);
}

void read_crypto_material(const Film& film, std::size_t x, std::size_t y, float* channels) {
    read_matte(film.means.materials[film.index(x, y)], film.materials, film.samples(x, y),
               channels);
}

bool has_squares(const Film& film) { return film.sum_of_squares.size() == film.window.size(); }

// ---------------------------------------------------------------------------------- the table

using enum LayerId;
constexpr LayerSampling center = LayerSampling::center;
constexpr LayerSampling mean = LayerSampling::mean;

constexpr LayerRow ray_length_row() {
    LayerRow row = values<&DataLayers::ray_length>(
        {ray_length, "ray_length", "Z",
         "distance from the ray's origin to the first surface, in scene units; infinite if there "
         "is none",
         center, true, 4});
    row.allocate = [](Film& film) {
        film.layers->ray_length.assign(film.window.size(), std::numeric_limits<float>::infinity());
    };
    return row;
}

constexpr LayerRow parameters_row() {
    LayerRow row = computed(
        {parameters, "parameters", "UVA",
         "parameters of the camera's eye object; A is 1 where there is a ray", center, true, 8},
        read_parameters);
    row.allocate = allocate<&DataLayers::parameters>;
    row.complete = complete<&DataLayers::parameters>;
    return row;
}

constexpr LayerRow variance_row() {
    LayerRow row = computed({variance, "variance", "RGB",
                             "estimate of the variance of the picture's light; its root is the "
                             "standard error",
                             LayerSampling::film, false, 32},
                            read_variance);
    row.allocate = [](Film& film) { film.sum_of_squares.assign(film.window.size(), Color4d(0.0)); };
    row.complete = has_squares;
    return row;
}

constexpr LayerRow noisy_row() {
    LayerRow row = computed(
        {noisy, "noisy", "RGBA", "light of the picture as it was rendered; only after denoising",
         LayerSampling::film, false, 0},
        read_noisy);
    row.complete = [](const Film& film) { return film.noisy.size() == film.window.size(); };
    return row;
}

constexpr std::array rows{
    ray_length_row(),
    values<&DataLayers::position>(
        {position, "position", "XYZ", "position of the hit point", center, true, 12}),
    values<&DataLayers::normal>({normal, "normal", "XYZ",
                                 "unit shading normal, on the side that the ray comes from", center,
                                 true, 12}),
    values<&DataLayers::albedo>({albedo, "albedo", "RGB", "base colour", center, true, 12}),
    values<&DataLayers::object>({object, "object", "X",
                                 "id of the object; 0 if there is none. The attribute `objects` "
                                 "lists the names; that of id n is entry n − 1, counted from 0",
                                 center, true, 4}),
    values<&DataLayers::origin>({origin, "origin", "XYZ", "origin of the ray", center, true, 12}),
    values<&DataLayers::direction>(
        {direction, "direction", "XYZ", "unit direction of the ray", center, true, 12}),
    parameters_row(),
    values<&DataLayers::valid>(
        {valid, "valid", "A", "1 where there is a ray, otherwise 0", center, true, 1}),
    values<&DataLayers::layer>({picture_layer, "layer", "X",
                                "the camera layer of the picture, counted from 1 at the back; the "
                                "attribute `layers` lists their names",
                                center, true, 2}),
    computed({samples, "samples", "X", "number of samples of the pixel", LayerSampling::film},
             read_samples),
    values<&DataLayers::magnification>(
        {magnification, "magnification", "X",
         "how large the camera shows the hit point: pixels per scene unit, on a plane across the "
         "ray, the geometric mean over its directions; 0 if nothing is hit",
         center, false, 4}),
    values<&DataLayers::motion>(
        {motion, "motion", "XYZW",
         "how far what is seen moves in the picture, in pixels, x to the right and y up: X and Y "
         "are its place in the previous frame minus that of the pixel, Z and W the place of the "
         "pixel minus that in the next frame",
         center, false, 16}),
    sums<&MeanLayers::emission>(
        {emission, "emission", "RGB",
         "light that comes from emitting surfaces and the environment without any reflection", mean,
         false, 24}),
    sums<&MeanLayers::direct>({direct, "direct", "RGB",
                               "light that one surface reflects or refracts from its source", mean,
                               false, 24}),
    computed({indirect, "indirect", "RGB",
              "the other light: several surfaces reflect or refract it, or it is ambient light",
              mean, false, 0, 1, LayerSet{emission, direct}},
             read_indirect),
    halves<&MeanLayers::direct_half>({direct_half, "direct_half", "RGB",
                                      "`direct` of the first half of the samples, "
                                      "whose difference from `direct` tells its noise",
                                      mean, false, 24, 1, LayerSet{direct}}),
    halves<&MeanLayers::indirect_half>({indirect_half, "indirect_half", "RGB",
                                        "the same for `indirect`", mean, false, 24, 1,
                                        LayerSet{emission, direct}}),
    values<&MeanLayers::albedo>({mean_albedo, "mean_albedo", "RGB",
                                 "base colour, averaged, as denoisers expect it", mean, false, 24}),
    values<&MeanLayers::normal>({mean_normal, "mean_normal", "XYZ",
                                 "normal, averaged, as denoisers expect it", mean, false, 24}),
    values<&MeanLayers::position>(
        {mean_position, "mean_position", "XYZ", "position, averaged", mean, false, 24}),
    matte<&MeanLayers::objects>({crypto_object, "CryptoObject", "RGBA",
                                 "Cryptomatte of the objects: hash, coverage, hash, coverage", mean,
                                 false, sizeof(Matte), Matte::ranks / 2},
                                read_crypto_object),
    matte<&MeanLayers::materials>(
        {crypto_material, "CryptoMaterial", "RGBA", "Cryptomatte of the materials", mean, false,
         sizeof(Matte), Matte::ranks / 2},
        read_crypto_material),
    variance_row(),
    noisy_row(),
};

constexpr auto infos = [] {
    std::array<LayerInfo, rows.size()> made{};
    std::transform(rows.begin(), rows.end(), made.begin(),
                   [](const LayerRow& row) { return row.info; });
    return made;
}();

static_assert([] {
    for (std::size_t i = 0; i < infos.size(); ++i) {
        if (infos[i].id != static_cast<LayerId>(i)) {
            return false;
        }
    }
    return true;
}());

Diagnostic unknown_layer(std::string_view name) {
    if (name == infos[static_cast<std::size_t>(noisy)].name) {
        return error(Kind::usage, fmt::format("the layer '{}' cannot be chosen", name),
                     "a denoised picture has it without being asked");
    }
    std::vector<std::string> names{"default", "all", "none"};
    std::string list = "default, all, none";
    for (const LayerInfo& info : infos) {
        if (info.id != noisy) {
            names.emplace_back(info.name);
            list += fmt::format(", {}", info.name);
        }
    }
    return error(Kind::usage, fmt::format("unknown layer '{}'", name),
                 did_you_mean(name, names, fmt::format("the layers are {}", list)));
}

template <class Condition>
LayerSet layers_with(const Condition& condition) {
    LayerSet found;
    for (const LayerInfo& info : infos) {
        if (condition(info)) {
            found.insert(info.id);
        }
    }
    return found;
}

std::optional<LayerSet> set_of(std::string_view name) {
    if (name == "none") {
        return LayerSet{};
    }
    if (name == "default") {
        return default_layers();
    }
    if (name == "all") {
        return layers_with([](const LayerInfo& info) { return info.id != noisy; });
    }
    const LayerSet named =
        layers_with([&](const LayerInfo& info) { return info.name == name && info.id != noisy; });
    return named.empty() ? std::nullopt : std::optional(named);
}

}  // namespace

std::span<const LayerInfo> layers() { return infos; }

std::span<const LayerRow> layer_rows() { return rows; }

LayerSet default_layers() {
    return layers_with([](const LayerInfo& info) { return info.by_default; });
}

LayerSet with_needs(LayerSet wanted) {
    LayerSet all = wanted;
    for (const LayerInfo& info : infos) {
        if (wanted.contains(info.id)) {
            all.insert(info.needs);
        }
    }
    return all;
}

Result<LayerSet> find_layers(std::string_view list) {
    LayerSet found;
    for (std::size_t begin = 0; begin <= list.size();) {
        const std::size_t end = std::min(list.find(',', begin), list.size());
        const std::string_view name = list.substr(begin, end - begin);
        const std::optional<LayerSet> set = set_of(name);
        if (!set) {
            return unknown_layer(name);
        }
        found.insert(*set);
        begin = end + 1;
    }
    return found;
}

}  // namespace balcony::render
