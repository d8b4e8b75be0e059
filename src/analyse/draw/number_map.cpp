// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analyse/draw/bitmap.hpp"
#include "analyse/draw/color_scale.hpp"
#include "analyse/draw/legend.hpp"
#include "balcony/drawing.hpp"

namespace balcony::analyse {

namespace {

// From the smallest to the largest finite number, and logarithmic if these are positive.
std::optional<ColorScale> scale_of(const NumberMap& map) {
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (const std::optional<double>& one : map.numbers) {
        if (one && std::isfinite(*one)) {
            least = std::min(least, *one);
            most = std::max(most, *one);
        }
    }
    if (!(least <= most)) {
        return std::nullopt;
    }
    if (most - least <= 1e-6 * std::abs(most)) {
        const double margin = most != 0.0 ? 0.05 * std::abs(most) : 1.0;
        least -= margin;
        most += margin;
    }
    return ColorScale(least, most,
                      least > 0.0 ? ColorScale::Spacing::logarithmic : ColorScale::Spacing::linear);
}

struct Box {
    std::size_t x, y, width, height;

    [[nodiscard]] bool meets(const Box& other) const {
        return x < other.x + other.width && other.x < x + width && y < other.y + other.height &&
               other.y < y + height;
    }
};

/// Where a pixel is between the middles of two cells of a row, or beyond the last.
class Between {
public:
    Between(std::size_t pixel, std::size_t pixels, std::size_t cells)
        : at_((static_cast<double>(pixel) + 0.5) / static_cast<double>(pixels) *
                  static_cast<double>(cells) -
              0.5),
          last_(cells - 1) {}

    /// Both cells with the shares of a linear function.
    [[nodiscard]] std::array<std::pair<std::size_t, double>, 2> parts() const {
        if (last_ == 0) {
            return {{{0, 1.0}, {0, 0.0}}};
        }
        const std::size_t first = std::min(static_cast<std::size_t>(std::max(at_, 0.0)), last_ - 1);
        const double share = at_ - static_cast<double>(first);
        return {{{first, 1.0 - share}, {first + 1, share}}};
    }
    [[nodiscard]] std::size_t nearest() const {
        return std::min(static_cast<std::size_t>(std::max(at_ + 0.5, 0.0)), last_);
    }

private:
    double at_;
    std::size_t last_;
};

class MapPainter {
public:
    explicit MapPainter(const NumberMap& map)
        : map_(map),
          scale_(scale_of(map)),
          legend_{map.title, scale_, {}},
          width_(std::max(map.width, min_width)),
          height_(std::max<std::size_t>(width_ * map.height / map.width, 1)) {
        add_swatch(
            map.unknown, [](const std::optional<double>& one) { return one && std::isinf(*one); },
            unknown_color);
        add_swatch(
            map.missing, [](const std::optional<double>& one) { return !one; }, missing_color);
    }

    Image paint() {
        Bitmap bitmap(width_, height_ + height_of(legend_), white);
        places_.resize(width_ * height_);
        for (std::size_t y = 0; y < height_; ++y) {
            for (std::size_t x = 0; x < width_; ++x) {
                const std::optional<double> place = place_of(x, y);
                bitmap.fill(x, y, 1, 1, place ? sequential_color(*place) : color_without(x, y));
                places_[y * width_ + x] = place.value_or(std::nan(""));
            }
        }
        if (scale_) {
            for (const ColorScale::Tick& tick : scale_->ticks(10.0)) {
                add_contour(tick, bitmap);
            }
        }
        write_legend(legend_, height_, bitmap);
        return bitmap.take();
    }

private:
    static constexpr std::size_t min_width = 800;
    static constexpr Color missing_color{128, 128, 128};
    static constexpr Color unknown_color{200, 30, 110};

    template <class Is>
    void add_swatch(const std::string& meaning, const Is& is, const Color& color) {
        if (std::any_of(map_.numbers.begin(), map_.numbers.end(), is)) {
            legend_.swatches.push_back({color, meaning});
        }
    }

    [[nodiscard]] Color color_without(std::size_t x, std::size_t y) const {
        const std::size_t column = Between(x, width_, map_.columns).nearest();
        const std::size_t row = Between(y, height_, map_.rows).nearest();
        return map_.numbers[row * map_.columns + column] ? unknown_color : missing_color;
    }

    /// Where on the scale a pixel is, linear between the middles of cells and beyond them; that of
    /// the nearest cell where one of the cells around it has no number.
    [[nodiscard]] std::optional<double> place_of(std::size_t x, std::size_t y) const {
        const Between column(x, width_, map_.columns);
        const Between row(y, height_, map_.rows);
        const auto cell = [&](std::size_t c, std::size_t r) -> std::optional<double> {
            const std::optional<double>& number = map_.numbers[r * map_.columns + c];
            return number && std::isfinite(*number) ? std::optional(scale_->position(*number))
                                                    : std::nullopt;
        };
        double sum = 0.0;
        for (const auto& [r, by_row] : row.parts()) {
            for (const auto& [c, by_column] : column.parts()) {
                const std::optional<double> place = cell(c, r);
                if (!place) {
                    return cell(column.nearest(), row.nearest());
                }
                sum += by_row * by_column * *place;
            }
        }
        return sum;
    }

    /// A line where the numbers pass that of the tick, with its text where there is room, to the
    /// right of the middle if it can be.
    void add_contour(const ColorScale::Tick& tick, Bitmap& bitmap) {
        const double level = scale_->position(tick.value);
        std::vector<std::array<std::size_t, 2>> contour;
        for (std::size_t y = 0; y + 1 < height_; ++y) {
            for (std::size_t x = 0; x + 1 < width_; ++x) {
                const double here = places_[y * width_ + x];
                const double right = places_[y * width_ + x + 1];
                const double below = places_[(y + 1) * width_ + x];
                if ((here < level && (right >= level || below >= level)) ||
                    (here >= level && (right < level || below < level))) {
                    bitmap.fill(x, y, 2, 2, black);
                    contour.push_back({x, y});
                }
            }
        }
        const auto rank = [&](const std::array<std::size_t, 2>& at) {
            const auto [x, y] = at;
            const std::size_t off = 2 * y > height_ ? 2 * y - height_ : height_ - 2 * y;
            return off + (2 * x < width_ ? height_ : 0);
        };
        std::stable_sort(contour.begin(), contour.end(),
                         [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
        constexpr std::size_t margin = 4;
        const std::size_t text_width = Bitmap::text_width(tick.text, legend_text_size);
        const std::size_t text_height = Bitmap::text_height(legend_text_size);
        for (const auto& [x, y] : contour) {
            const Box box{x - std::min(x, text_width / 2 + margin),
                          y - std::min(y, text_height / 2 + margin), text_width + 2 * margin,
                          text_height + 2 * margin};
            const bool fits = box.x + box.width <= width_ && box.y + box.height <= height_ &&
                              std::none_of(labels_.begin(), labels_.end(),
                                           [&](const Box& other) { return box.meets(other); });
            if (fits) {
                bitmap.fill(box.x, box.y, box.width, box.height, white);
                bitmap.write(box.x + margin, box.y + margin, tick.text, black, legend_text_size);
                labels_.push_back(box);
                return;
            }
        }
    }

    const NumberMap& map_;
    std::optional<ColorScale> scale_;
    Legend legend_;
    std::size_t width_;
    std::size_t height_;
    std::vector<double> places_;  ///< On the scale, by pixel.
    std::vector<Box> labels_;
};

}  // namespace

Image paint(const NumberMap& map) {
    assert(map.width > 0 && map.height > 0 && map.columns > 0 && map.rows > 0);
    assert(map.numbers.size() == map.columns * map.rows);
    return MapPainter(map).paint();
}

}  // namespace balcony::analyse
