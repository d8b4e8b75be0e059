// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Parameters that stages of several families have: their rows in the catalogue, and what is made of
// the numbers.

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

/// The numbers x, y and z of a stage that has them as three parameters.
inline Triple xyz_of(const Arguments& a) { return {a.number("x"), a.number("y"), a.number("z")}; }

/// A number that may be left out.
inline StageParameter number_parameter(std::string_view name, double value,
                                       std::string_view meaning) {
    return {.name = name, .default_value = {value}, .meaning = meaning};
}

/// A number above 0 that may be left out.
inline StageParameter positive_parameter(std::string_view name, double value,
                                         std::string_view meaning) {
    return {.name = name,
            .default_value = {value},
            .minimum = 0.0,
            .excludes_minimum = true,
            .meaning = meaning};
}

/// A point or vector of PCS that may be left out.
inline StageParameter pair_parameter(std::string_view name, std::vector<double> value,
                                     std::string_view meaning) {
    return {.name = name,
            .type = ParameterType::pair,
            .unit = Unit::parameter,
            .default_value = std::move(value),
            .meaning = meaning};
}

/// A point or vector of OCS that may be left out.
inline StageParameter triple_parameter(std::string_view name, std::vector<double> value,
                                       std::string_view meaning) {
    return {.name = name,
            .type = ParameterType::triple,
            .default_value = std::move(value),
            .meaning = meaning};
}

}  // namespace balcony::camera
