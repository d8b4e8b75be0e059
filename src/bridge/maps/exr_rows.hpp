// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// An EXR file of 32-bit floats without compression, written row by row through a stream.

#include <cstddef>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "bridge/maps/in_order.hpp"

namespace balcony::bridge {

class ExrRows {
public:
    using Attributes = std::vector<std::pair<std::string, std::string>>;

    ExrRows(std::ostream& stream, std::size_t width, std::size_t height,
            std::vector<std::string> channels, const Attributes& attributes = {});
    ~ExrRows();
    ExrRows(const ExrRows&) = delete;
    ExrRows& operator=(const ExrRows&) = delete;

    /// The next rows, pixel by pixel, with all channels of a pixel together. False if the stream
    /// has failed.
    [[nodiscard]] bool write(const RowSpan& rows, const float* values);
    /// After the last row: completes the file. False if the stream has failed.
    [[nodiscard]] bool finish();

private:
    struct State;
    std::ostream& stream_;
    std::unique_ptr<State> state_;
};

}  // namespace balcony::bridge
