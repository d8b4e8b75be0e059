// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Arrays of NumPy.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <Imath/ImathVec.h>
#include <pybind11/numpy.h>

namespace balcony::python {

using Shape = std::vector<pybind11::ssize_t>;

/// An array of the numbers of a vector, which are not copied.
template <class Number>
[[nodiscard]] pybind11::array_t<Number> array_of(std::vector<Number>&& numbers,
                                                 const Shape& shape) {
    auto kept = std::make_unique<std::vector<Number>>(std::move(numbers));
    Number* const data = kept->data();
    const pybind11::capsule owner(
        kept.release(), [](void* memory) { delete static_cast<std::vector<Number>*>(memory); });
    return pybind11::array_t<Number>(shape, data, owner);
}

/// Numbers in rows, of an argument with this name: an array of the shape (n, columns), or one row,
/// of any type of real numbers and any layout. Raises TypeError or ValueError. The second is n.
struct Rows {
    pybind11::array_t<double> array;
    std::size_t count = 0;
    std::size_t columns = 0;

    [[nodiscard]] std::span<const Imath::V2d> points() const {
        return {reinterpret_cast<const Imath::V2d*>(array.data()), count};
    }
    [[nodiscard]] std::span<const Imath::V3d> places() const {
        return {reinterpret_cast<const Imath::V3d*>(array.data()), count};
    }
};
[[nodiscard]] Rows rows_of(const pybind11::object& argument, const std::string& name,
                           const std::vector<std::size_t>& columns);

/// The same for whole numbers in rows of three. Those beyond 2^63 become negative.
struct Triples {
    pybind11::array_t<std::int64_t> array;
    std::size_t count = 0;

    [[nodiscard]] std::span<const std::array<std::int64_t, 3>> triangles() const {
        return {reinterpret_cast<const std::array<std::int64_t, 3>*>(array.data()), count};
    }
};
[[nodiscard]] Triples triples_of(const pybind11::object& argument, const std::string& name);

}  // namespace balcony::python
