// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The part of a map projection that depends on one variable, and its inverse: y by latitude, or the
// distance from a centre.

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "balcony/emitter.hpp"

namespace balcony::camera::maps {

/// An interval.
struct Interval {
    double first = 0.0, last = 0.0;
};

/// An angle of the sphere, a coordinate of the map and a second quantity, as functions of one
/// parameter. They are not numbers where the map has no point.
struct AngleFunctions {
    using Function = std::function<double(double parameter)>;

    Function coordinate;  ///< Increases or decreases throughout.
    Function second;
    Interval parameters;           ///< Where they are defined.
    Function angle{};              ///< Without it, the parameter is the angle.
    std::vector<double> breaks{};  ///< Parameters within where another formula begins.
    double shift = 0.0;            ///< An angle from which tangents may be measured.
};

/// The angle and the second quantity by the coordinate: a closed form where it is one of the usual
/// functions, otherwise tables of polynomials of degree 7 that agree with the given functions
/// within table_error.
class Profile {
public:
    struct Values {
        Expr angle, second;
    };
    static constexpr double table_error = 2e-11;

    /// Nothing if the coordinate is infinite at an end without a closed form, or if no table is
    /// close enough.
    [[nodiscard]] static std::optional<Profile> make(const AngleFunctions& functions);

    /// Requires that the map has such a coordinate.
    [[nodiscard]] Values operator()(Expr coordinate, Emitter& emit) const;

private:
    struct ClosedForm;
    struct Tables;

    static const ClosedForm* closed_form(const AngleFunctions& functions, Profile& profile);
    bool second_by_cosine(const AngleFunctions& functions);

    Interval angles_;
    double shift_ = 0.0;
    /// closed form of the coordinate: outer(coordinate) = scale * inner(angle) + offset
    const ClosedForm* form_ = nullptr;
    double scale_ = 1.0, offset_ = 0.0;
    /// The second quantity is constant + by_cosine cos(angle), if it is not in a table.
    double constant_ = 0.0, by_cosine_ = 0.0;
    std::shared_ptr<const Tables> tables_;  ///< Null without a table.
};

}  // namespace balcony::camera::maps
