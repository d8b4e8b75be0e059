// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <utility>

#include "balcony/images.hpp"

namespace balcony::images {

namespace {

/// An image whose first stored row or column is not its top row or left column.
class UprightImage final : public ImageFile {
public:
    explicit UprightImage(std::unique_ptr<ImageFile> stored)
        : stored_(std::move(stored)), orientation_(stored_->orientation()) {}

    std::size_t width() const override {
        return rows_are_columns() ? stored_->height() : stored_->width();
    }
    std::size_t height() const override {
        return rows_are_columns() ? stored_->width() : stored_->height();
    }
    std::size_t channels() const override { return stored_->channels(); }
    std::vector<std::string> channel_names() const override { return stored_->channel_names(); }
    bool is_whole_picture() const override { return stored_->is_whole_picture(); }
    bool is_float() const override { return stored_->is_float(); }
    bool has_bytes() const override { return stored_->has_bytes(); }
    std::optional<std::size_t> unassociated_alpha() const override {
        return stored_->unassociated_alpha();
    }
    int orientation() const override { return 1; }

    std::optional<Diagnostic> read_rows(std::size_t begin, std::size_t end,
                                        std::span<float> values) override {
        return read(begin, end, values, floats_);
    }
    std::optional<Diagnostic> read_rows(std::size_t begin, std::size_t end,
                                        std::span<std::uint8_t> values) override {
        return read(begin, end, values, bytes_);
    }

private:
    [[nodiscard]] bool rows_are_columns() const { return orientation_ >= 5; }
    [[nodiscard]] bool is_one_of(std::initializer_list<int> orientations) const {
        return std::find(orientations.begin(), orientations.end(), orientation_) !=
               orientations.end();
    }

    template <class Value>
    std::optional<Diagnostic> read(std::size_t begin, std::size_t end, std::span<Value> values,
                                   std::vector<Value>& all) {
        if (begin >= end || end > height() ||
            values.size() != (end - begin) * width() * channels()) {
            return error(Kind::internal, "rows that an image does not have are read");
        }
        if (all.empty()) {
            std::vector<Value> decoded(width() * height() * channels());
            if (auto failure = stored_->read_rows(0, stored_->height(), std::span(decoded))) {
                return failure;
            }
            all = std::move(decoded);
        }
        auto to = values.begin();
        for (std::size_t y = begin; y < end; ++y) {
            for (std::size_t x = 0; x < width(); ++x) {
                const auto from = all.begin() + static_cast<std::ptrdiff_t>(place(x, y));
                to = std::copy_n(from, channels(), to);
            }
        }
        return std::nullopt;
    }

    // The first value of the pixel that is seen at (x, y).
    [[nodiscard]] std::size_t place(std::size_t x, std::size_t y) const {
        const std::size_t across = rows_are_columns() ? y : x;
        const std::size_t down = rows_are_columns() ? x : y;
        const std::size_t column = is_one_of({2, 3, 7, 8}) ? stored_->width() - 1 - across : across;
        const std::size_t row = is_one_of({3, 4, 6, 7}) ? stored_->height() - 1 - down : down;
        return (row * stored_->width() + column) * channels();
    }

    std::unique_ptr<ImageFile> stored_;
    int orientation_;
    std::vector<float> floats_;  // As they are stored; empty until they are read.
    std::vector<std::uint8_t> bytes_;
};

}  // namespace

std::unique_ptr<ImageFile> upright(std::unique_ptr<ImageFile> image) {
    if (image->orientation() == 1) {
        return image;
    }
    return std::make_unique<UprightImage>(std::move(image));
}

}  // namespace balcony::images
