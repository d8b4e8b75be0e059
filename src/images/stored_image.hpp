// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "balcony/images.hpp"

namespace balcony::images {

/// What readers of all formats do alike: they refuse rows that an image does not have, and turn one
/// that is stored otherwise than it is seen.
class StoredImage : public ImageFile {
public:
    [[nodiscard]] std::size_t width() const final {
        return rows_are_columns() ? stored_.height : stored_.width;
    }
    [[nodiscard]] std::size_t height() const final {
        return rows_are_columns() ? stored_.width : stored_.height;
    }
    [[nodiscard]] std::size_t channels() const final { return stored_.channels; }

    void turn_upright() final;

    [[nodiscard]] std::optional<Diagnostic> read_rows(std::size_t begin, std::size_t end,
                                                      std::span<float> values) final;
    [[nodiscard]] std::optional<Diagnostic> read_rows(std::size_t begin, std::size_t end,
                                                      std::span<std::uint8_t> values) final;

protected:
    struct Form {
        std::size_t width = 0;
        std::size_t height = 0;
        std::size_t channels = 0;
        int orientation = 1;  ///< As EXIF and TIFF count it; 1 is as it is stored.
    };
    /// Of the image in the file; to be set before it is read.
    Form stored_;

    /// What read_rows() fills.
    using Values = std::variant<std::span<float>, std::span<std::uint8_t>>;
    /// Reads the rows [begin, end) of the file, which it has. May throw, as guarded() allows.
    [[nodiscard]] virtual std::optional<Diagnostic> read_stored(std::size_t begin, std::size_t end,
                                                                const Values& values) = 0;

private:
    [[nodiscard]] bool rows_are_columns() const { return orientation_ >= 5; }
    template <class Value>
    [[nodiscard]] std::optional<Diagnostic> read(std::size_t begin, std::size_t end,
                                                 std::span<Value> values);
    template <class Value>
    [[nodiscard]] std::optional<Diagnostic> turn();

    int orientation_ = 1;
    // The whole image upright, once it is read and stored otherwise.
    std::variant<std::vector<std::uint8_t>, std::vector<float>> turned_;
};

}  // namespace balcony::images
