// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Arrays of NumPy (.npy), as
// https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html describes them.

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "balcony/base.hpp"

namespace balcony::data {

[[nodiscard]] bool is_npy(std::string_view bytes);

/// An array of three dimensions in the bytes of a file, which must outlive it.
class NpyArray {
public:
    /// Reads floating point numbers of 4 or 8 bytes in either byte order, row by row or column by
    /// column. `name` is that of the file, for messages.
    [[nodiscard]] static Result<NpyArray> read(std::string_view bytes, const std::string& name);

    [[nodiscard]] const std::array<std::size_t, 3>& shape() const { return shape_; }
    [[nodiscard]] double operator()(std::size_t i, std::size_t j, std::size_t k) const;

private:
    std::string_view numbers_;
    std::array<std::size_t, 3> shape_{};
    std::array<std::size_t, 3> stride_{};  // In numbers.
    std::size_t size_ = 8;                 // Of a number, in bytes.
    bool swapped_ = false;                 // The byte order is not that of the machine.
};

}  // namespace balcony::data
