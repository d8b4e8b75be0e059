// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "data/npy_array.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace balcony::data {

Result<NpyArray> NpyArray::read(std::string_view bytes, const std::string& name) {
    Result<NpyHeader> header = NpyHeader::read(bytes, name);
    if (!header) {
        return header.diagnostics;
    }
    if (header->shape.size() != 3) {
        return error(fmt::format("the array in '{}' has the shape ({})", name,
                                 fmt::join(header->shape, ", ")),
                     {}, "give it the shape (height, width, columns)");
    }
    NpyArray made;
    made.header_ = std::move(*header);
    made.numbers_ = bytes.substr(made.header_.size);
    std::copy(made.header_.shape.begin(), made.header_.shape.end(), made.shape_.begin());
    // The product may exceed any number.
    std::size_t left = made.numbers_.size() / made.header_.number_size;
    for (const std::size_t length : made.shape_) {
        left = length == 0 ? 0 : left / length;
    }
    if (left == 0) {
        return error(fmt::format("'{}' ends before its {} x {} x {} numbers do", name,
                                 made.shape_[0], made.shape_[1], made.shape_[2]),
                     {}, "write it again with numpy.save");
    }
    const auto [rows, columns, depth] = made.shape_;
    made.stride_ = made.header_.by_columns ? std::array<std::size_t, 3>{1, rows, rows * columns}
                                           : std::array<std::size_t, 3>{columns * depth, depth, 1};
    return made;
}

double NpyArray::operator()(std::size_t i, std::size_t j, std::size_t k) const {
    const std::size_t at = i * stride_[0] + j * stride_[1] + k * stride_[2];
    return header_.number_at(numbers_.data() + at * header_.number_size);
}

}  // namespace balcony::data
