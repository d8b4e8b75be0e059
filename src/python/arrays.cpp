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

}  // namespace

Rows rows_of(const py::object& argument, const std::string& name,
             const std::vector<std::size_t>& columns) {
    const auto given = py::array::ensure(argument);
    if (!given) {
        throw py::error_already_set();
    }
    if (std::string_view("biuf").find(given.dtype().kind()) == std::string_view::npos) {
        throw py::type_error(fmt::format("'{}' has the type {}, but real numbers are needed", name,
                                         std::string(py::str(given.dtype()))));
    }
    const auto last =
        given.ndim() == 0 ? 0U : static_cast<std::size_t>(given.shape(given.ndim() - 1));
    const bool fits = std::find(columns.begin(), columns.end(), last) != columns.end() &&
                      (given.ndim() == 1 || given.ndim() == 2);
    if (!fits) {
        throw py::value_error(fmt::format("'{}' has the shape {}, but (n, {}) is needed", name,
                                          shape_text(given), fmt::join(columns, ") or (n, ")));
    }
    using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
    Numbers numbers = Numbers::ensure(given);
    if (!numbers) {
        throw py::error_already_set();
    }
    const std::size_t count = static_cast<std::size_t>(numbers.size()) / last;
    return {std::move(numbers), count, last};
}

}  // namespace balcony::python
