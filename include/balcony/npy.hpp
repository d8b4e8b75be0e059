// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Headers of arrays of NumPy (.npy), as
// https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html describes them.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/base.hpp"

namespace balcony {

[[nodiscard]] bool is_npy(std::string_view bytes);

/// What is known of the numbers in a file.
struct NpyHeader {
    std::vector<std::size_t> shape;
    std::size_t size = 0;         ///< Of the header, in bytes: the numbers begin behind it.
    std::size_t number_size = 8;  ///< 4 or 8 bytes, floating point.
    bool swapped = false;         ///< The byte order is not that of the machine.
    bool by_columns = false;      ///< The first index changes fastest, as in Fortran.

    /// From the beginning of a file, with all of its header. `name` is that of the file, for
    /// messages.
    [[nodiscard]] static Result<NpyHeader> read(std::string_view bytes, const std::string& name);
    /// The number in `number_size` bytes.
    [[nodiscard]] double number_at(const char* bytes) const;
};

/// The header of an array that is written row by row in the byte order of the machine.
/// `number_size` is 4 or 8; `least` is the least size of the header, a multiple of 64, so that a
/// longer shape has room later. With the kind 'u', they are unsigned integers of 1 to 8 bytes.
[[nodiscard]] std::string npy_header(std::span<const std::size_t> shape, std::size_t number_size,
                                     std::size_t least = 0, char kind = 'f');

}  // namespace balcony
