// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Handles: what a hand can move of a camera's text. What a handle is follows from the type of a
// stage's parameter in the catalogue, so every stage has handles.
//
//     EditedText::handles() ─▶ Handle ─▶ EditedText::moved() ─▶ TextEdits
//
// A number in a stage may be written as a formula of a parameter, a let or a literal: tan(fov/2).
// A hand moves the one literal, or parameter, that it is made of.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/catalogue.hpp"

namespace balcony::lang {

/// What the numbers of a handle are.
enum class HandleKind : std::uint8_t {
    number,           ///< Any number.
    size,             ///< A number that is not negative: a length, a factor.
    count,            ///< A whole number.
    angle,            ///< An angle.
    interval,         ///< Two ends of a range of u or v: from left to right or from bottom to top.
    parameter_point,  ///< A point (u, v).
    picture_point,    ///< A point of the picture, as fractions from its top left corner.
    picture_region,   ///< Its top left and its bottom right corner, as such points.
    space_point,      ///< A point or a vector in space.
    direction,        ///< A vector of any length except 0.
};
/// "number", "size", ...
[[nodiscard]] std::string_view name_of(HandleKind kind);

/// A number of a handle.
struct HandleNumber {
    double value = 0.0;  ///< In radians if it is an angle.
    bool is_angle = false;
    camera::Range limits{};  ///< The values that it may have in its stage.
    /// Whether a hand can move it: not where it depends on the time, on several parameters or on
    /// what only the stage knows.
    bool moves = false;
    /// The parameter of the camera that it is made of: a value of View::change() moves it if it
    /// stays open. Empty if it is a let's or stands in the stage itself.
    std::string parameter{};
    /// The literal that moves with it, as bytes [begin, end) of the text; empty if it is not in
    /// this text, where moved() adds it.
    std::size_t begin = 0;
    std::size_t end = 0;
};

struct Handle {
    HandleKind kind = HandleKind::number;
    std::string statement{};  ///< Its keyword: "eye", "warp", "place", ...
    std::string stage{};      ///< Its name; empty where a statement has no stage.
    std::string parameter{};  ///< The first one of the stage that it is about; "u" or "v" of a map.
    std::size_t index = 0;    ///< Its number among those of the same list of points.
    std::string meaning{};    ///< One line; may be empty.
    /// The stage in the text, or the statement if it has none, as bytes [begin, end); empty if they
    /// are those of another text, that of the camera that this one is made of.
    std::size_t begin = 0;
    std::size_t end = 0;
    /// One, or as many as the kind has: x and y, u and v; x, y and z; two points of a region.
    std::vector<HandleNumber> numbers{};
};

/// Another value for a number of a handle.
struct HandleMove {
    std::size_t number = 0;  ///< Its index in Handle::numbers.
    double value = 0.0;      ///< In radians if it is an angle.
    /// By how much the smallest movement of the hand changes it, which decides on the digits that
    /// are written; 0 is a thousandth of what it was.
    double step = 0.0;
};

/// Another value for a parameter of a camera.
struct ParameterMove {
    std::string parameter;
    double value = 0.0;  ///< In radians if it is an angle.
    double step = 0.0;   ///< As HandleMove::step. Without one, all digits are written.
};

/// The time of a value that changes from key to key.
struct KeyTime {
    double time = 0.0;         ///< In seconds.
    double frame = 1.0 / 24;   ///< A key that is less than half of this away is the one meant.
    bool begins_keys = false;  ///< Numbers that do not change get keys.
};

/// The keys of a parameter that the text writes out as times and numbers: keys((0, 1), (2, 5)).
struct ParameterKeys {
    std::string parameter;
    std::vector<double> times{};  ///< In seconds.
};

}  // namespace balcony::lang
