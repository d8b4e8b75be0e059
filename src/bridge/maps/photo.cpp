// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "bridge/maps/photo.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "balcony/images.hpp"
#include "balcony/photo_arrays.hpp"

namespace balcony::bridge {

namespace {

using images::ImageFile;

Diagnostic no_photo(const std::filesystem::path& file, const Diagnostic& reason) {
    return error(reason.kind,
                 fmt::format("'{}' cannot be read as an image: {}", file.string(), reason.message),
                 reason.remedy);
}

/// How the channels of a file become linear light.
struct PhotoForm {
    std::size_t channels = 0;
    bool linear = false;    ///< The file has linear light.
    bool straight = false;  ///< Its alpha is not multiplied into its colours.

    void add(const float* pixel, std::vector<float>& values) const {
        // Grey, grey and alpha, colour, colour and alpha.
        const bool grey = channels < 3;
        const float alpha = channels % 2 == 0 ? finite(pixel[channels - 1]) : 1.0F;
        for (std::size_t k = 0; k < 3; ++k) {
            const float value = finite(pixel[grey ? 0 : k]);
            if (linear) {
                values.push_back(value * (straight ? alpha : 1.0F));
            } else {
                const bool divide = !straight && alpha > 0.0F;
                values.push_back(linear_from_display(divide ? value / alpha : value) * alpha);
            }
        }
        values.push_back(alpha);
    }

    static float finite(float value) { return std::isfinite(value) ? value : 0.0F; }
};

template <class Number>
Photo::Pixels pixels_of(std::span<const Number> numbers, const PixelForm& form) {
    constexpr bool is_float = std::is_floating_point_v<Number>;
    constexpr float most = is_float ? 1.0F : static_cast<float>(std::numeric_limits<Number>::max());
    assert(numbers.size() == form.width * form.height * form.channels && form.channels >= 1 &&
           form.channels <= 4);
    Photo::Pixels made{.width = form.width,
                       .height = form.height,
                       .deep = !is_float && sizeof(Number) > 1,
                       .linear = is_float};
    made.values.reserve(4 * form.width * form.height);
    const PhotoForm photo{form.channels, is_float, !is_float};
    std::array<float, 4> pixel{};
    for (std::size_t i = 0; i < numbers.size(); i += form.channels) {
        const auto own = numbers.subspan(i, form.channels);
        std::transform(own.begin(), own.end(), pixel.begin(),
                       [](Number number) { return static_cast<float>(number) / most; });
        photo.add(pixel.data(), made.values);
    }
    return made;
}

}  // namespace

Result<Photo> Photo::load(const std::filesystem::path& file) {
    Result<std::unique_ptr<ImageFile>> opened = ImageFile::open(file);
    if (!opened) {
        return no_photo(file, opened.diagnostics.front());
    }
    ImageFile& input = **opened;
    input.turn_upright();
    auto made = std::make_shared<Pixels>();
    made->width = input.width();
    made->height = input.height();
    made->deep = !input.has_bytes() && !input.is_float();
    made->linear = input.is_float();
    made->values.reserve(4 * made->width * made->height);
    const PhotoForm form{input.channels(), input.is_float(),
                         input.unassociated_alpha().has_value()};
    constexpr std::size_t rows_at_once = 64;
    std::vector<float> rows;
    for (std::size_t row = 0; row < made->height; row += rows_at_once) {
        const std::size_t end = std::min(row + rows_at_once, made->height);
        rows.resize((end - row) * made->width * form.channels);
        if (const auto failure = input.read_rows(row, end, rows)) {
            return no_photo(file, *failure);
        }
        for (std::size_t i = 0; i < rows.size(); i += form.channels) {
            form.add(rows.data() + i, made->values);
        }
    }
    return Photo(std::move(made));
}

Photo Photo::of(Pixels pixels) { return Photo(std::make_shared<const Pixels>(std::move(pixels))); }

Photo photo_of(std::span<const std::uint8_t> pixels, const PixelForm& form) {
    return Photo::of(pixels_of(pixels, form));
}
Photo photo_of(std::span<const std::uint16_t> pixels, const PixelForm& form) {
    return Photo::of(pixels_of(pixels, form));
}
Photo photo_of(std::span<const float> pixels, const PixelForm& form) {
    return Photo::of(pixels_of(pixels, form));
}

std::size_t Photo::width() const { return pixels_->width; }
std::size_t Photo::height() const { return pixels_->height; }
bool Photo::is_deep() const { return pixels_->deep; }

}  // namespace balcony::bridge
