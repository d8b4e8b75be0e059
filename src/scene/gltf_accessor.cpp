// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

#include "scene/gltf_document.hpp"

namespace balcony::scene {

namespace {

// The numbers that glTF gives to the kinds of components.
enum class Component : std::uint16_t {
    signed_byte = 5120,
    unsigned_byte = 5121,
    signed_short = 5122,
    unsigned_short = 5123,
    unsigned_int = 5125,
    single_float = 5126,
};

std::size_t size_of(std::size_t component) {
    switch (static_cast<Component>(component)) {
        case Component::signed_byte:
        case Component::unsigned_byte: return 1;
        case Component::signed_short:
        case Component::unsigned_short: return 2;
        case Component::unsigned_int:
        case Component::single_float: return 4;
    }
    throw PartError{fmt::format("its component type {} is unknown", component)};
}

std::size_t components_of(const std::string& type) {
    if (type == "SCALAR") {
        return 1;
    }
    const bool vector =
        type.size() == 4 && type.starts_with("VEC") && type[3] >= '2' && type[3] <= '4';
    if (!vector) {
        throw PartError{fmt::format("its accessor type {} is none for a vertex", in_quotes(type))};
    }
    return static_cast<std::size_t>(type[3] - '0');
}

template <class T>
T value_at(const std::uint8_t* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

// glTF 2.0, section 3.11: the integers of a normalised accessor stand for value / maximum, and the
// most negative one for -1 as well.
float decode(const std::uint8_t* bytes, std::size_t component, bool normalized) {
    const auto scaled = [&](auto value, float maximum) {
        const auto number = static_cast<float>(value);
        return normalized ? std::max(number / maximum, -1.0F) : number;
    };
    switch (static_cast<Component>(component)) {
        case Component::signed_byte: return scaled(value_at<std::int8_t>(bytes), 127.0F);
        case Component::unsigned_byte: return scaled(value_at<std::uint8_t>(bytes), 255.0F);
        case Component::signed_short: return scaled(value_at<std::int16_t>(bytes), 32767.0F);
        case Component::unsigned_short: return scaled(value_at<std::uint16_t>(bytes), 65535.0F);
        case Component::unsigned_int: return scaled(value_at<std::uint32_t>(bytes), 4294967295.0F);
        case Component::single_float: break;
    }
    return value_at<float>(bytes);
}

std::uint32_t decode_integer(const std::uint8_t* bytes, std::size_t component) {
    switch (static_cast<Component>(component)) {
        case Component::unsigned_byte: return value_at<std::uint8_t>(bytes);
        case Component::unsigned_short: return value_at<std::uint16_t>(bytes);
        case Component::unsigned_int: return value_at<std::uint32_t>(bytes);
        default: break;
    }
    throw PartError{"its indices are not unsigned integers"};
}

// Elements without bytes are zero; only sparse accessors have a use for them, and a few bytes of
// JSON must not ask for the whole memory.
constexpr std::size_t max_elements_without_bytes = std::size_t{1} << 24U;

}  // namespace

// Where the elements of an accessor lie: all of them are inside the bytes.
struct GltfDocument::Elements {
    std::span<const std::uint8_t> bytes;
    std::size_t count = 0;
    std::size_t stride = 0;
    std::size_t component = 0;
    std::size_t component_size = 0;
    std::size_t components = 0;

    // Throws PartError unless every element lies in the bytes.
    void check() const {
        const std::size_t size = component_size * components;
        const bool fits =
            count == 0 || (size <= bytes.size() && (count - 1) <= (bytes.size() - size) / stride);
        if (!fits) {
            throw PartError{"an accessor reaches past the end of its buffer view"};
        }
    }

    [[nodiscard]] const std::uint8_t* at(std::size_t element, std::size_t part) const {
        assert(element < count && part < components);
        return bytes.data() + element * stride + part * component_size;
    }
};

GltfDocument::Elements GltfDocument::elements(const Json& accessor) const {
    Elements elements;
    elements.count = count_in(accessor, "count", 0);
    elements.component = count_in(accessor, "componentType", 0);
    elements.component_size = size_of(elements.component);
    elements.components = components_of(text_in(accessor, "type"));
    elements.stride = elements.component_size * elements.components;
    const auto view_index = index_in(accessor, "bufferView");
    if (!view_index) {
        if (elements.count > max_elements_without_bytes) {
            throw PartError{"an accessor has no buffer view"};
        }
        return elements;
    }
    elements.bytes = view(*view_index);
    const Json& view_json = element(root_, "bufferViews", *view_index);
    elements.stride = std::max<std::size_t>(count_in(view_json, "byteStride", elements.stride), 1);
    const std::size_t offset = count_in(accessor, "byteOffset", 0);
    if (offset > elements.bytes.size()) {
        throw PartError{"an accessor reaches past the end of its buffer view"};
    }
    elements.bytes = elements.bytes.subspan(offset);
    elements.check();
    return elements;
}

// Calls sink(index, bytes, component type) for every component that the sparse part replaces.
template <class Sink>
void GltfDocument::replace_sparse(const Json& accessor, std::size_t components,
                                  const Sink& sink) const {
    const Json& sparse = member(accessor, "sparse");
    if (!sparse.is_object()) {
        return;
    }
    const auto part = [&](const char* key, std::size_t component, std::size_t size) {
        const Json& place = member(sparse, key);
        Elements found;
        found.count = count_in(sparse, "count", 0);
        found.component = component;
        found.component_size = size_of(component);
        found.components = size;
        found.stride = found.component_size * size;
        const auto bytes = view(count_in(place, "bufferView", SIZE_MAX));
        found.bytes = bytes.subspan(std::min(count_in(place, "byteOffset", 0), bytes.size()));
        found.check();
        return found;
    };
    const Elements places =
        part("indices", count_in(member(sparse, "indices"), "componentType", 0), 1);
    const Elements values = part("values", count_in(accessor, "componentType", 0), components);
    const std::size_t count = count_in(accessor, "count", 0);
    for (std::size_t i = 0; i < places.count; ++i) {
        const std::size_t place = decode_integer(places.at(i, 0), places.component);
        if (place >= count) {
            throw PartError{"a sparse accessor replaces an element past its end"};
        }
        for (std::size_t k = 0; k < components; ++k) {
            sink(place * components + k, values.at(i, k), values.component);
        }
    }
}

template <class Sink>
void GltfDocument::for_each_component(const Json& accessor, std::size_t components,
                                      const Sink& sink) const {
    const Elements found = elements(accessor);
    if (found.components != components) {
        throw PartError{fmt::format("an accessor has {} where {} belong",
                                    counted(found.components, "component"), components)};
    }
    for (std::size_t i = 0; i < found.count && !found.bytes.empty(); ++i) {
        for (std::size_t k = 0; k < components; ++k) {
            sink(i * components + k, found.at(i, k), found.component);
        }
    }
    replace_sparse(accessor, components, sink);
}

std::size_t GltfDocument::count(std::size_t accessor) const {
    return elements(element(root_, "accessors", accessor)).count;
}

std::vector<float> GltfDocument::floats(std::size_t accessor, std::size_t components) const {
    const Json& json = element(root_, "accessors", accessor);
    const bool normalized = flag_in(json, "normalized");
    std::vector<float> values(count(accessor) * components);
    for_each_component(json, components,
                       [&](std::size_t at, const std::uint8_t* bytes, std::size_t component) {
                           values[at] = decode(bytes, component, normalized);
                       });
    return values;
}

std::vector<std::uint32_t> GltfDocument::integers(std::size_t accessor) const {
    const Json& json = element(root_, "accessors", accessor);
    std::vector<std::uint32_t> values(count(accessor));
    for_each_component(json, 1,
                       [&](std::size_t at, const std::uint8_t* bytes, std::size_t component) {
                           values[at] = decode_integer(bytes, component);
                       });
    return values;
}

}  // namespace balcony::scene
