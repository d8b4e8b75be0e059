// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What Python texts for arrays share: functions of NumPy, which other libraries have under the same
// names.

#include <set>
#include <string>
#include <string_view>

#include "bridge/text/text_export.hpp"

namespace balcony::bridge {

/// A library of arrays. In its texts LIB is its name in Python.
struct ArrayLibrary {
    std::string_view name;     ///< "np"
    std::string_view imports;  ///< Lines that import it.
    std::string_view arrays;   ///< What it calls its arrays.
    /// What the comment of a function says about derivatives: lines of their own.
    std::string_view derivatives{};
    const Spellings& spellings;
    std::string_view number_of_condition;  ///< As Dialect has it.
    std::string_view guarded{};            ///< As Dialect has it.
    /// Before a function that computes rays, and before its parameters x and y.
    std::string_view decorator{};
    std::string_view parameters{};
    /// Definitions that all texts need: _arrays(), which makes arrays of numbers for formulas;
    /// _rays(), which calls formulas with arrays of one shape; and _vector().
    std::string_view helpers;
    std::string_view table;   ///< An array of the numbers {0}.
    std::string_view whole;   ///< Behind an array: as indices.
    std::string_view like{};  ///< Behind an array: as precise as an array {0}.
    /// Definitions that the inverse needs: _doubles(), _indices(), _count() and _order(). Behind it
    /// may stand more.
    std::string_view inverse_helpers;
    std::string_view searching{};  ///< Before a function that searches.
    std::string_view finding =
        "$";  ///< How the names of functions that search begin; $ is the camera's.
    std::string_view behind_inverse{};
};

/// The operations that all these libraries write alike.
inline constexpr Spellings array_spellings = spellings({
    function(Op::modulo, "_modulo", "def _modulo(a, b):\n    return a - b * LIB.floor(a / b)\n\n"),
    function(Op::minimum, "_minimum", "def _minimum(a, b):\n    return LIB.where(b < a, b, a)\n\n"),
    function(Op::maximum, "_maximum", "def _maximum(a, b):\n    return LIB.where(a < b, b, a)\n\n"),
    standard(Op::power, "power"),
    standard(Op::arcsine, "arcsin"),
    standard(Op::arccosine, "arccos"),
    standard(Op::arctangent, "arctan"),
    standard(Op::arctangent2, "arctan2"),
    standard(Op::inverse_hyperbolic_sine, "arcsinh"),
    standard(Op::inverse_hyperbolic_cosine, "arccosh"),
    standard(Op::inverse_hyperbolic_tangent, "arctanh"),
    symbol(Op::logical_and, "&"),
    symbol(Op::logical_or, "|"),
    standard(Op::logical_not, "logical_not"),
    standard(Op::is_finite, "isfinite"),
    standard(Op::select, "where"),
});

/// A number of Python.
[[nodiscard]] std::string python_number(double value);

/// The words of Python and the names that texts in it need, without those of libraries.
[[nodiscard]] const std::set<std::string_view>& python_words();

/// The definitions of a listing as lines of a function, each section after its comment.
[[nodiscard]] std::string python_definitions(const Listing& listing);

/// The inputs of formulas in the order of a function's parameters.
[[nodiscard]] std::string python_inputs(bool lens, const ParameterNames& parameters);

/// A table as a global array and a function that looks into it; an array of the numbers {0}.
[[nodiscard]] std::string python_tables(const Listing& listing, std::string_view array);

/// The module of a camera: a function that gives its rays, and with footprints the inverse.
[[nodiscard]] std::string array_module(const ArrayLibrary& library, const ExportSource& source,
                                       CameraFormulas formulas);

}  // namespace balcony::bridge
