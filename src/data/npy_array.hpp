// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "balcony/base.hpp"
#include "balcony/npy.hpp"

namespace balcony::data {

/// An array of three dimensions in the bytes of a file of NumPy, which must outlive it.
class NpyArray {
public:
    /// `name` is that of the file, for messages.
    [[nodiscard]] static Result<NpyArray> read(std::string_view bytes, const std::string& name);

    [[nodiscard]] const std::array<std::size_t, 3>& shape() const { return shape_; }
    [[nodiscard]] double operator()(std::size_t i, std::size_t j, std::size_t k) const;

private:
    NpyHeader header_;
    std::string_view numbers_;
    std::array<std::size_t, 3> shape_{};
    std::array<std::size_t, 3> stride_{};  // In numbers.
};

}  // namespace balcony::data
