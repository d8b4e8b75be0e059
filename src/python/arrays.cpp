// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "python/arrays.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace balcony::python {

namespace py = pybind11;

namespace {

std::string shape_text(const py::array& array) {
    std::vector<py::ssize_t> sides(array.shape(), array.shape() + array.ndim());
    return fmt::format("({}{})", fmt::join(sides, ", "), sides.size() == 1 ? "," : "");
}

// An array of rows, whose type is one of some kinds of NumPy.
py::array checked(const py::object& argument, const std::string& name, std::string_view kinds,
                  std::string_view needed, const std::vector<std::size_t>& columns) {
    const auto given = py::array::ensure(argument);
    if (!given) {
        throw py::type_error(fmt::format("'{}' is no array of {}", name, needed));
    }
    if (kinds.find(given.dtype().kind()) == std::string_view::npos) {
        throw py::type_error(fmt::format("'{}' has the type {}, but {} are needed", name,
                                         std::string(py::str(given.dtype())), needed));
    }
    const auto last =
        given.ndim() == 0 ? 0U : static_cast<std::size_t>(given.shape(given.ndim() - 1));
    const bool fits = std::find(columns.begin(), columns.end(), last) != columns.end() &&
                      (given.ndim() == 1 || given.ndim() == 2);
    if (!fits) {
        throw py::value_error(fmt::format("'{}' has the shape {}, but (n, {}) is needed", name,
                                          shape_text(given), fmt::join(columns, ") or (n, ")));
    }
    return given;
}

// The same numbers, one after the other in memory.
template <class Number>
py::array_t<Number> packed(const py::array& given) {
    return py::array_t<Number, py::array::c_style | py::array::forcecast>(given);
}

}  // namespace

Rows rows_of(const py::object& argument, const std::string& name,
             const std::vector<std::size_t>& columns) {
    const py::array given = checked(argument, name, "biuf", "real numbers", columns);
    const auto last = static_cast<std::size_t>(given.shape(given.ndim() - 1));
    auto numbers = packed<double>(given);
    const std::size_t count = static_cast<std::size_t>(numbers.size()) / last;
    return {std::move(numbers), count, last};
}

Triples triples_of(const py::object& argument, const std::string& name) {
    auto numbers = packed<std::int64_t>(checked(argument, name, "iu", "whole numbers", {3}));
    const std::size_t count = static_cast<std::size_t>(numbers.size()) / 3;
    return {std::move(numbers), count};
}

}  // namespace balcony::python
