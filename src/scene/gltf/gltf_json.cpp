// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scene/gltf/gltf_json.hpp"

#include <cmath>

#include <fmt/format.h>

namespace balcony::scene {

namespace {

std::size_t to_index(const Json& value, std::string_view key) {
    if (value.is_number_unsigned()) {
        return value.get<std::size_t>();
    }
    throw PartError{fmt::format("its '{}' is not a non-negative integer", key)};
}

double to_number(const Json& value, std::string_view key) {
    if (value.is_number() && std::isfinite(value.get<double>())) {
        return value.get<double>();
    }
    throw PartError{fmt::format("its '{}' is not a number", key)};
}

const Json& array_in(const Json& value, std::string_view key) {
    const Json& array = member(value, key);
    if (!array.is_array() && !array.is_null()) {
        throw PartError{fmt::format("its '{}' is not an array", key)};
    }
    return array;
}

}  // namespace

const Json& member(const Json& value, std::string_view key) {
    static const Json nothing;
    if (!value.is_object()) {
        return nothing;
    }
    const auto found = value.find(key);
    return found == value.end() ? nothing : *found;
}

const Json& element(const Json& root, std::string_view array, std::size_t index) {
    const Json& elements = member(root, array);
    if (!elements.is_array() || index >= elements.size()) {
        throw PartError{fmt::format("the file has no '{}' with index {}", array, index)};
    }
    return elements[index];
}

std::size_t array_size(const Json& value, std::string_view key) {
    const Json& array = member(value, key);
    return array.is_array() ? array.size() : 0;
}

std::optional<std::size_t> index_in(const Json& value, std::string_view key) {
    const Json& index = member(value, key);
    return index.is_null() ? std::nullopt : std::optional(to_index(index, key));
}

std::size_t count_in(const Json& value, std::string_view key, std::size_t fallback) {
    return index_in(value, key).value_or(fallback);
}

std::vector<std::size_t> indices_in(const Json& value, std::string_view key) {
    std::vector<std::size_t> indices;
    for (const Json& index : array_in(value, key)) {
        indices.push_back(to_index(index, key));
    }
    return indices;
}

double number_in(const Json& value, std::string_view key, double fallback) {
    const Json& number = member(value, key);
    return number.is_null() ? fallback : to_number(number, key);
}

std::vector<double> numbers_in(const Json& value, std::string_view key,
                               std::vector<double> fallback) {
    const Json& array = array_in(value, key);
    if (array.is_null()) {
        return fallback;
    }
    if (array.size() != fallback.size()) {
        throw PartError{fmt::format("its '{}' has {} numbers where {} are required", key,
                                    array.size(), fallback.size())};
    }
    for (std::size_t i = 0; i < fallback.size(); ++i) {
        fallback[i] = to_number(array[i], key);
    }
    return fallback;
}

float to_quantity(double number, std::string_view key) {
    if (!(number >= 0.0 && number <= max_quantity)) {
        throw PartError{fmt::format("its '{}' is not in the range 0 .. {:g}", key, max_quantity)};
    }
    return static_cast<float>(number);
}

float quantity_in(const Json& value, std::string_view key, float fallback) {
    return to_quantity(number_in(value, key, double{fallback}), key);
}

float signed_quantity_in(const Json& value, std::string_view key, float fallback) {
    const double number = number_in(value, key, double{fallback});
    return std::copysign(to_quantity(std::abs(number), key), static_cast<float>(number));
}

Color3f to_color(const std::array<double, 3>& numbers, std::string_view key) {
    return {to_quantity(numbers[0], key), to_quantity(numbers[1], key),
            to_quantity(numbers[2], key)};
}

Color3f color_in(const Json& value, std::string_view key, const Color3f& fallback) {
    const auto numbers = numbers_in(value, key, {fallback.x, fallback.y, fallback.z});
    return to_color({numbers[0], numbers[1], numbers[2]}, key);
}

Color3f scaled(const Color3f& color, float intensity, std::string_view key) {
    const auto channel = [&](float part) {
        static_cast<void>(to_quantity(double{part} * double{intensity}, key));
        return part * intensity;
    };
    return {channel(color.x), channel(color.y), channel(color.z)};
}

std::string_view text_view_in(const Json& value, std::string_view key) {
    const auto* text = member(value, key).get_ptr<const Json::string_t*>();
    return text != nullptr ? std::string_view(*text) : std::string_view();
}

std::string text_in(const Json& value, std::string_view key, std::string_view fallback) {
    return std::string(member(value, key).is_string() ? text_view_in(value, key) : fallback);
}

bool flag_in(const Json& value, std::string_view key) {
    const Json& flag = member(value, key);
    return flag.is_boolean() && flag.get<bool>();
}

}  // namespace balcony::scene
