// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Parameters of several families of stages: their rows in the catalogue, and the values made of
// the numbers.

#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "balcony/catalogue.hpp"

namespace balcony::camera {

using Pair = std::array<Scalar, 2>;
using Triple = std::array<Scalar, 3>;

inline ParameterPoint parameter_point_of(const Pair& t, const Emitter& emit) {
    return {emit(t[0]), emit(t[1])};
}

inline ObjectPoint point_of(const Triple& t, const Emitter& emit) {
    return {emit(t[0]), emit(t[1]), emit(t[2])};
}

inline ObjectVector vector_of(const Triple& t, const Emitter& emit) {
    return {emit(t[0]), emit(t[1]), emit(t[2])};
}

inline ObjectVector to_unit_length(const ObjectVector& a) { return (1.0 / sqrt(dot(a, a))) * a; }

/// The numbers x, y and z of a stage with these three parameters.
inline Triple xyz_of(const Arguments& a) { return {a.number("x"), a.number("y"), a.number("z")}; }

inline std::vector<StageParameter> operator+(std::vector<StageParameter> first,
                                             const std::vector<StageParameter>& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

/// An optional number in a range.
inline StageParameter number_parameter(std::string_view name, double value,
                                       std::string_view meaning, const Range& range = {}) {
    return {.name = name,
            .type = NumberParameter{.default_value = value, .range = range},
            .meaning = meaning};
}

/// An optional number above 0.
inline StageParameter positive_parameter(std::string_view name, double value,
                                         std::string_view meaning) {
    return number_parameter(name, value, meaning, {.minimum = 0.0, .excludes_minimum = true});
}

/// An optional angle.
inline StageParameter angle_parameter(std::string_view name, double value,
                                      std::string_view meaning) {
    return {.name = name,
            .type = NumberParameter{.unit = Unit::angle, .default_value = value},
            .meaning = meaning};
}

/// A word; the first of the choices is the default.
inline StageParameter choice_parameter(std::string_view name, std::vector<std::string_view> choices,
                                       std::string_view meaning) {
    return {
        .name = name, .type = ChoiceParameter{.choices = std::move(choices)}, .meaning = meaning};
}

/// An optional point or vector in PCS.
inline StageParameter pair_parameter(std::string_view name, std::array<double, 2> value,
                                     std::string_view meaning) {
    return {.name = name,
            .type = PairParameter{.unit = Unit::either, .default_value = value},
            .meaning = meaning};
}

/// An optional point or vector in OCS.
inline StageParameter triple_parameter(std::string_view name, std::array<double, 3> value,
                                       std::string_view meaning) {
    return {.name = name, .type = TripleParameter{.default_value = value}, .meaning = meaning};
}

/// A curve that the stage is made of.
inline StageParameter curve_parameter(std::string_view name, std::string_view meaning) {
    return {.name = name,
            .type = NestedStageParameter{.kind = StageKind::object_generator, .dimension = 1},
            .meaning = meaning};
}

}  // namespace balcony::camera
