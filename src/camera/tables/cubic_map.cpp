// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/tables/cubic_map.hpp"

#include <array>
#include <cstdint>

namespace balcony::camera {

namespace {

using expr::Table;

// A point in the square of a valid pixel depends on pixels up to two away.
constexpr std::size_t reach = 2;

/// The pixels of a map with a border of `reach` around them.
class Padded {
public:
    explicit Padded(const PixelMap& map)
        : columns_(map.width + 2 * reach),
          rows_(map.height + 2 * reach),
          known_(columns_ * rows_, 0),
          channels_(map.channels.size(), std::vector<double>(columns_ * rows_, 0.0)) {
        for (std::size_t y = 0; y < map.height; ++y) {
            for (std::size_t x = 0; x < map.width; ++x) {
                const std::size_t from = y * map.width + x;
                const std::size_t to = (y + reach) * columns_ + x + reach;
                known_[to] = map.valid[from];
                for (std::size_t k = 0; known_[to] != 0 && k < channels_.size(); ++k) {
                    channels_[k][to] = map.channels[k][from];
                }
            }
        }
        for (std::size_t ring = 0; ring < reach; ++ring) {
            extend();
        }
    }

    [[nodiscard]] std::vector<double> take(std::size_t channel) {
        return std::move(channels_[channel]);
    }

private:
    /// A step to a neighbour.
    struct Step {
        std::ptrdiff_t x, y;
    };
    static constexpr std::array steps{Step{1, 0}, Step{-1, 0}, Step{0, 1},  Step{0, -1},
                                      Step{1, 1}, Step{1, -1}, Step{-1, 1}, Step{-1, -1}};
    static constexpr std::size_t steps_along_axes = 4;

    // Gives values to the pixels next to known ones.
    void extend() {
        std::vector<std::uint8_t> known = known_;
        for (std::size_t y = 0; y < rows_; ++y) {
            for (std::size_t x = 0; x < columns_; ++x) {
                if (known_[y * columns_ + x] == 0) {
                    known[y * columns_ + x] = extrapolate(x, y) ? 1 : 0;
                }
            }
        }
        known_ = std::move(known);
    }

    // The mean of polynomials through up to three known pixels in a line: of the highest degree
    // that any line permits, along rows and columns rather than diagonals.
    bool extrapolate(std::size_t x, std::size_t y) {
        for (std::size_t count = 3; count > 0; --count) {
            const std::span all(steps);
            if (mean_over(all.first(steps_along_axes), count, x, y) ||
                mean_over(all.subspan(steps_along_axes), count, x, y)) {
                return true;
            }
        }
        return false;
    }

    bool mean_over(std::span<const Step> directions, std::size_t count, std::size_t x,
                   std::size_t y) {
        static constexpr std::array<std::array<double, 3>, 3> weights{
            {{1.0, 0.0, 0.0}, {2.0, -1.0, 0.0}, {3.0, -3.0, 1.0}}};
        std::size_t lines = 0;
        const std::size_t at = y * columns_ + x;
        for (const Step& step : directions) {
            if (known_along(step, x, y) < count) {
                continue;
            }
            ++lines;
            for (std::vector<double>& channel : channels_) {
                double value = 0.0;
                for (std::size_t i = 0; i < count; ++i) {
                    value += weights[count - 1][i] * channel[index(x, y, step, i + 1)];
                }
                channel[at] += (value - channel[at]) / static_cast<double>(lines);
            }
        }
        return lines > 0;
    }

    // How many of the next three pixels are known, without a gap.
    [[nodiscard]] std::size_t known_along(const Step& step, std::size_t x, std::size_t y) const {
        for (std::size_t i = 1; i <= 3; ++i) {
            const auto distance = static_cast<std::ptrdiff_t>(i);
            const std::ptrdiff_t column = static_cast<std::ptrdiff_t>(x) + distance * step.x;
            const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(y) + distance * step.y;
            if (column < 0 || row < 0 || column >= static_cast<std::ptrdiff_t>(columns_) ||
                row >= static_cast<std::ptrdiff_t>(rows_) || known_[index(x, y, step, i)] == 0) {
                return i - 1;
            }
        }
        return 3;
    }

    [[nodiscard]] std::size_t index(std::size_t x, std::size_t y, const Step& step,
                                    std::size_t count) const {
        const auto by = static_cast<std::ptrdiff_t>(count) *
                        (step.y * static_cast<std::ptrdiff_t>(columns_) + step.x);
        return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(y * columns_ + x) + by);
    }

    std::size_t columns_;
    std::size_t rows_;
    std::vector<std::uint8_t> known_;
    std::vector<std::vector<double>> channels_;
};

// Constant in each cell: pixel i is the cell from i to i + 1.
std::shared_ptr<const Table> pixel_table(std::size_t width, std::size_t height, std::size_t border,
                                         std::vector<double> values) {
    const auto axis = [border](std::size_t length) {
        return Table::Axis{-static_cast<double>(border), static_cast<double>(length + border),
                           length + 2 * border, 0};
    };
    return std::make_shared<const Table>(Table{{axis(height), axis(width)}, std::move(values)});
}

/// A place between pixel centres along an axis, and the weights of the four pixels around it.
struct KeysWeights {
    explicit KeysWeights(Expr place) : first(floor(place)) {
        const Expr r = place - first;
        weights = {r * (r * (1.0 - 0.5 * r) - 0.5), 1.0 + r * r * (1.5 * r - 2.5),
                   r * (r * (2.0 - 1.5 * r) + 0.5), r * r * (0.5 * r - 0.5)};
    }
    // The middle of the cell of pixel i of the four.
    [[nodiscard]] Expr cell(std::size_t i) const { return first + (static_cast<double>(i) - 0.5); }

    Expr first;
    std::array<Expr, 4> weights;
};

}  // namespace

CubicMap::CubicMap(const PixelMap& map)
    : width_(static_cast<double>(map.width)),
      height_(static_cast<double>(map.height)),
      valid_(pixel_table(map.width, map.height, 0, {map.valid.begin(), map.valid.end()})) {
    Padded padded(map);
    for (std::size_t i = 0; i < map.channels.size(); ++i) {
        channels_.push_back(pixel_table(map.width, map.height, reach, padded.take(i)));
    }
}

std::vector<Expr> CubicMap::operator()(const ParameterPoint& p, Emitter& emit) const {
    Graph& graph = emit.graph();
    // In pixels from the top left corner.
    const Expr x = p.u * width_;
    const Expr y = (1.0 - p.v) * height_;
    // Rounding leaves no gap at the border.
    constexpr double slack = 1e-9;
    const auto within = [](Expr place, double length) {
        return -slack * length <= place && place <= (1.0 + slack) * length;
    };
    emit.require(within(x, width_) && within(y, height_));
    emit.require(0.5 < graph.lookup(valid_, std::array{y, x}));

    const KeysWeights along_x(x - 0.5);
    const KeysWeights along_y(y - 0.5);
    std::vector<Expr> values;
    for (const auto& channel : channels_) {
        Expr value = emit(0.0);
        for (std::size_t j = 0; j < 4; ++j) {
            Expr row = emit(0.0);
            for (std::size_t i = 0; i < 4; ++i) {
                row = row + along_x.weights[i] *
                                graph.lookup(channel, std::array{along_y.cell(j), along_x.cell(i)});
            }
            value = value + along_y.weights[j] * row;
        }
        values.push_back(value);
    }
    return values;
}

}  // namespace balcony::camera
