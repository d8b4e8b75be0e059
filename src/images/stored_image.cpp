// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "images/stored_image.hpp"

#include <algorithm>
#include <utility>

#include "images/image_checks.hpp"
#include "images/sample_values.hpp"

namespace balcony::images {

namespace {

struct Place {
    std::size_t x;
    std::size_t y;
};

// TIFF 6.0, section 8: where the file has what is seen at a place.
Place stored_place(Place seen, int orientation, std::size_t width, std::size_t height) {
    const auto [x, y] = seen;
    switch (orientation) {
        case 2: return {width - 1 - x, y};
        case 3: return {width - 1 - x, height - 1 - y};
        case 4: return {x, height - 1 - y};
        case 5: return {y, x};
        case 6: return {y, height - 1 - x};
        case 7: return {width - 1 - y, height - 1 - x};
        case 8: return {width - 1 - y, x};
        default: return seen;
    }
}

}  // namespace

void StoredImage::turn_upright() {
    const bool is_known = 1 <= stored_.orientation && stored_.orientation <= 8;
    orientation_ = is_known ? stored_.orientation : 1;
}

std::optional<Diagnostic> StoredImage::read_rows(std::size_t begin, std::size_t end,
                                                 std::span<float> values) {
    return guarded([&] { return read(begin, end, values); });
}

std::optional<Diagnostic> StoredImage::read_rows(std::size_t begin, std::size_t end,
                                                 std::span<std::uint8_t> values) {
    return guarded([&] { return read(begin, end, values); });
}

template <class Value>
std::optional<Diagnostic> StoredImage::read(std::size_t begin, std::size_t end,
                                            std::span<Value> values) {
    const std::size_t row = width() * channels();
    if (begin > end || end > height() || values.size() != (end - begin) * row) {
        return error(Kind::internal, "rows that it does not have are asked for");
    }
    if (orientation_ == 1) {
        return read_stored(begin, end, values);
    }
    const bool is_turned = std::visit([](const auto& all) { return !all.empty(); }, turned_);
    if (auto failure = is_turned     ? std::nullopt
                       : has_bytes() ? turn<std::uint8_t>()
                                     : turn<float>()) {
        return failure;
    }
    std::visit(
        [&](const auto& all) {
            copy_samples(std::span(all).subspan(begin * row, values.size()), values);
        },
        turned_);
    return std::nullopt;
}

template <class Value>
std::optional<Diagnostic> StoredImage::turn() {
    std::vector<Value> stored(width() * height() * channels());
    if (auto failure = read_stored(0, stored_.height, std::span(stored))) {
        return failure;
    }
    std::vector<Value> turned;
    turned.reserve(stored.size());
    for (std::size_t y = 0; y < height(); ++y) {
        for (std::size_t x = 0; x < width(); ++x) {
            const Place at = stored_place({x, y}, orientation_, stored_.width, stored_.height);
            const auto pixel = stored.begin() + static_cast<std::ptrdiff_t>(
                                                    (at.y * stored_.width + at.x) * channels());
            turned.insert(turned.end(), pixel, pixel + static_cast<std::ptrdiff_t>(channels()));
        }
    }
    turned_ = std::move(turned);
    return std::nullopt;
}

}  // namespace balcony::images
