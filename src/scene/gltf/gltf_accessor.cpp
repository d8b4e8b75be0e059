// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>
#include <limits>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include "scene/gltf/gltf_document.hpp"

namespace balcony::scene {

namespace {

// glTF's numbers of the component types.
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
    if (type == "MAT4") {
        return 16;
    }
    const bool vector =
        type.size() == 4 && type.starts_with("VEC") && type[3] >= '2' && type[3] <= '4';
    if (!vector) {
        throw PartError{
            fmt::format("its accessor type {} is not valid for a vertex", in_quotes(type))};
    }
    return static_cast<std::size_t>(type[3] - '0');
}

template <class T>
T value_at(const std::uint8_t* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

// glTF 2.0, section 3.11: the integers of a normalised accessor represent value / maximum, and the
// most negative one also represents -1.
template <class Stored>
float number_of(Stored value, bool normalized) {
    const auto number = static_cast<float>(value);
    if constexpr (std::is_integral_v<Stored>) {
        constexpr auto maximum = static_cast<float>(std::numeric_limits<Stored>::max());
        return normalized ? std::max(number / maximum, -1.0F) : number;
    }
    return number;
}

// Calls an action with a value of the component type.
template <class Action>
void with_component(std::size_t component, Action action) {
    switch (static_cast<Component>(component)) {
        case Component::signed_byte: return action(std::int8_t{});
        case Component::unsigned_byte: return action(std::uint8_t{});
        case Component::signed_short: return action(std::int16_t{});
        case Component::unsigned_short: return action(std::uint16_t{});
        case Component::unsigned_int: return action(std::uint32_t{});
        case Component::single_float: return action(float{});
    }
}

}  // namespace

GltfAccessor::GltfAccessor(std::size_t component, std::size_t components, std::size_t count,
                           bool normalized)
    : count_(count),
      component_(component),
      component_size_(size_of(component)),
      components_(components),
      normalized_(normalized) {}

void GltfAccessor::place(std::span<const std::uint8_t> bytes, std::size_t offset,
                         std::size_t stride) {
    const std::size_t size = element_size();
    const bool fits = offset <= bytes.size() &&
                      (count_ == 0 || (size <= bytes.size() - offset &&
                                       count_ - 1 <= (bytes.size() - offset - size) / stride));
    if (!fits) {
        throw PartError{"an accessor extends past the end of its buffer view"};
    }
    bytes_ = bytes.subspan(offset);
    stride_ = stride;
}

void GltfAccessor::replace(const GltfAccessor& indices, const GltfAccessor& values) {
    std::vector<std::uint32_t> elements(indices.count());
    indices.read_integers(elements);
    for (std::size_t i = 0; i < elements.size(); ++i) {
        if (elements[i] >= count_) {
            throw PartError{"a sparse accessor replaces an element past its end"};
        }
        replaced_[elements[i]] = values.at(i);
    }
}

const std::uint8_t* GltfAccessor::at(std::size_t element) const {
    assert(element < count_);
    // Elements without bytes are zero.
    static constexpr std::array<std::uint8_t, 64> zero{};
    if (!replaced_.empty()) {
        if (const auto found = replaced_.find(element); found != replaced_.end()) {
            return found->second;
        }
    }
    return bytes_.empty() ? zero.data() : bytes_.data() + element * stride_;
}

template <class Stored>
void GltfAccessor::read_as(std::span<const std::uint32_t> elements, float* numbers) const {
    for (const std::uint32_t element : elements) {
        const std::uint8_t* const bytes = at(element);
        for (std::size_t c = 0; c < components_; ++c) {
            *numbers++ = number_of(value_at<Stored>(bytes + c * sizeof(Stored)), normalized_);
        }
    }
}

void GltfAccessor::read(std::span<const std::uint32_t> elements, float* numbers) const {
    with_component(component_, [&](auto stored) { read_as<decltype(stored)>(elements, numbers); });
}

template <class Stored>
void GltfAccessor::read_as(std::span<std::uint32_t> integers) const {
    if constexpr (std::is_unsigned_v<Stored>) {
        for (std::size_t i = 0; i < integers.size(); ++i) {
            integers[i] = value_at<Stored>(at(i));
        }
    } else {
        throw PartError{"its indices are not unsigned integers"};
    }
}

void GltfAccessor::read_integers(std::span<std::uint32_t> integers) const {
    assert(integers.size() == count_);
    with_component(component_, [&](auto stored) { read_as<decltype(stored)>(integers); });
}

// The location of an accessor's parts is in the file's JSON.

GltfAccessor GltfDocument::read_accessor(const Json& json) {
    const std::size_t count = count_in(json, "count", 0);
    GltfAccessor accessor(count_in(json, "componentType", 0), components_of(text_in(json, "type")),
                          count, flag_in(json, "normalized"));
    if (const auto view_index = index_in(json, "bufferView")) {
        const Json& view_json = element(root_, "bufferViews", *view_index);
        const std::size_t stride = count_in(view_json, "byteStride", accessor.element_size());
        accessor.place(view(*view_index), count_in(json, "byteOffset", 0),
                       std::max<std::size_t>(stride, 1));
    } else if (count > size_) {
        throw PartError{"an accessor without a buffer view has more elements than the file bytes"};
    }
    const Json& sparse = member(json, "sparse");
    if (sparse.is_object()) {
        const std::size_t replaced = count_in(sparse, "count", 0);
        sparse_elements_.take(replaced);
        const auto part = [&](const char* key, std::size_t component, std::size_t components) {
            const Json& place = member(sparse, key);
            GltfAccessor found(component, components, replaced, accessor.is_normalized());
            found.place(view(count_in(place, "bufferView", SIZE_MAX)),
                        count_in(place, "byteOffset", 0), found.element_size());
            return found;
        };
        accessor.replace(
            part("indices", count_in(member(sparse, "indices"), "componentType", 0), 1),
            part("values", count_in(json, "componentType", 0), accessor.components()));
    }
    return accessor;
}

const GltfAccessor& GltfDocument::accessor(std::size_t index, std::size_t components) {
    import_.check_stop();
    auto known = accessors_.find(index);
    if (known == accessors_.end()) {
        known = accessors_.emplace(index, read_accessor(element(root_, "accessors", index))).first;
    }
    if (known->second.components() != components) {
        throw PartError{fmt::format("an accessor has {} where {} are required",
                                    counted(known->second.components(), "component"), components)};
    }
    return known->second;
}

}  // namespace balcony::scene
