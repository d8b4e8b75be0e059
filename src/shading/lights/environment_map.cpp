// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/lights/environment_map.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "images/luminance.hpp"
#include "shading/lights/choice.hpp"

namespace balcony::render {

namespace {

using Imath::Color3f;
using Imath::V2f;
using Imath::V3f;

using std::numbers::pi_v;
constexpr std::size_t max_columns = 2048;
constexpr std::size_t max_rows = 1024;

// A point of the picture, both coordinates from 0 to 1.
V2f picture_point(const V3f& direction) {
    const float across = std::hypot(direction.x, direction.y);
    return {0.5F - std::atan2(direction.y, direction.x) / (2.0F * pi_v<float>),
            std::atan2(across, direction.z) / pi_v<float>};
}

std::size_t cell_of(float coordinate, std::size_t count) {
    const float scaled = std::max(0.0F, coordinate * static_cast<float>(count));
    return std::min(static_cast<std::size_t>(scaled), count - 1);
}

// The sums of values, scaled to end at 1; all 0 if there is nothing to add. Returns the sum.
double accumulate(std::span<const double> values, std::span<float> cumulative) {
    double total = 0.0;
    for (const double value : values) {
        total += value;
    }
    double sum = 0.0;
    cumulative.front() = 0.0F;
    for (std::size_t i = 0; i < values.size(); ++i) {
        sum += values[i];
        cumulative[i + 1] = total > 0.0 ? static_cast<float>(sum / total) : 0.0F;
    }
    return total;
}

// The next multiple of a number of sectors that is not below a number of pixels.
std::size_t cells_for(std::size_t pixels, std::size_t sectors, std::size_t most) {
    return std::min((pixels + sectors - 1) / sectors * sectors, most);
}

// How many of some pixels lie in one of the cells that divide the same length, or across its
// borders.
std::size_t overlaps(std::size_t cell, std::size_t cells, std::size_t pixels) {
    const std::size_t first = cell * pixels / cells;
    const std::size_t end = ((cell + 1) * pixels + cells - 1) / cells;
    return end - first;
}

}  // namespace

EnvironmentMap::EnvironmentMap(std::size_t width, std::size_t height, std::vector<Color3f> texels,
                               const std::stop_token& stop)
    : width_(width), height_(height), texels_(std::move(texels)) {
    build_distribution(stop);
}

Color3f EnvironmentMap::radiance(const V3f& direction) const {
    if (is_constant()) {
        return texels_.front();
    }
    const V2f point = picture_point(direction);
    const auto width = static_cast<float>(width_);
    // Column 0 follows the last one; rows end at the poles.
    const float x = point.x * width - 0.5F;
    const float y = std::max(0.0F, point.y * static_cast<float>(height_) - 0.5F);
    const float left = std::floor(x);
    const auto x0 = static_cast<std::size_t>(left + width) % width_;
    const auto x1 = (x0 + 1) % width_;
    const auto y0 = std::min(static_cast<std::size_t>(y), height_ - 1);
    const auto y1 = std::min(y0 + 1, height_ - 1);
    const float s = x - left;
    const float t = y - static_cast<float>(y0);
    return (1.0F - t) * ((1.0F - s) * texel(x0, y0) + s * texel(x1, y0)) +
           t * ((1.0F - s) * texel(x0, y1) + s * texel(x1, y1));
}

EnvironmentMap::Sample EnvironmentMap::sample(const V2f& random) const {
    const ChosenCell row = choose_cell(cumulative_rows_, random.x);
    const ChosenCell column = choose_cell(
        std::span(cumulative_columns_).subspan(row.cell * (columns_ + 1), columns_ + 1), random.y);
    return sample_cell(row.cell, column.cell, {row.within, column.within});
}

EnvironmentMap::Sample EnvironmentMap::sample(std::size_t sector, const V2f& random) const {
    const std::size_t columns = columns_ / sector_columns;
    const ChosenCell row = choose_cell(rows_of(sector), random.x);
    const std::size_t at = sector / sector_columns * (rows_ / sector_rows) + row.cell;
    const std::size_t first = sector % sector_columns * columns;
    const ChosenCell column = choose_cell(
        std::span(cumulative_columns_).subspan(at * (columns_ + 1) + first, columns + 1), random.y);
    return sample_cell(at, first + column.cell, {row.within, column.within});
}

EnvironmentMap::Sample EnvironmentMap::sample_cell(std::size_t row, std::size_t column,
                                                   const V2f& within) const {
    const float top = cosines_[row];
    const float band = top - cosines_[row + 1];
    const float z = top - within.x * band;
    const float part = (static_cast<float>(column) + within.y) / static_cast<float>(columns_);
    const float longitude = pi_v<float> * (1.0F - 2.0F * part);
    const float across = std::sqrt(std::max(0.0F, 1.0F - z * z));
    return {{across * std::cos(longitude), across * std::sin(longitude), z}, density(row, column)};
}

float EnvironmentMap::density(std::size_t row, std::size_t column) const {
    const std::size_t first = row * (columns_ + 1) + column;
    const float probability = (cumulative_rows_[row + 1] - cumulative_rows_[row]) *
                              (cumulative_columns_[first + 1] - cumulative_columns_[first]);
    const float band = cosines_[row] - cosines_[row + 1];
    return probability * static_cast<float>(columns_) / (2.0F * pi_v<float> * band);
}

float EnvironmentMap::pdf(const V3f& direction) const {
    const V2f point = picture_point(direction);
    return density(cell_of(point.y, rows_), cell_of(point.x, columns_));
}

std::size_t EnvironmentMap::sector_of(const V3f& direction) {
    const V2f point = picture_point(direction);
    return cell_of(point.y, sector_rows) * sector_columns + cell_of(point.x, sector_columns);
}

// By row of the sector, cumulative.
std::span<const float> EnvironmentMap::rows_of(std::size_t sector) const {
    const std::size_t rows = rows_ / sector_rows;
    return std::span(sector_rows_)
        .subspan(sector % sector_columns * (rows_ + 1) + sector / sector_columns * rows, rows + 1);
}

float EnvironmentMap::probability(std::size_t sector) const {
    const std::span<const float> rows = rows_of(sector);
    return rows.back() - rows.front();
}

// The weight of a cell is its solid angle times the mean of its pixels. That of a pixel is its part
// of the interpolated picture: 3/4 of its own luminance and an eighth of each neighbour's, in both
// dimensions. So no cell with light has probability 0.
void EnvironmentMap::build_distribution(const std::stop_token& stop) {
    columns_ = cells_for(width_, sector_columns, max_columns);
    rows_ = cells_for(height_, sector_rows, max_rows);
    cosines_.resize(rows_ + 1);
    for (std::size_t row = 0; row <= rows_; ++row) {
        cosines_[row] = std::cos(pi_v<float> * static_cast<float>(row) / static_cast<float>(rows_));
    }
    const auto smoothed = [this](std::size_t x, std::size_t y) {
        const std::size_t left = (x + width_ - 1) % width_;
        const std::size_t right = (x + 1) % width_;
        return 0.125F * texel(left, y) + 0.75F * texel(x, y) + 0.125F * texel(right, y);
    };
    // A pixel that lies across a border counts in all of its cells.
    const auto for_each_cell = [this](std::size_t x, std::size_t y, const auto& action) {
        for (std::size_t row = y * rows_ / height_; row * height_ < (y + 1) * rows_; ++row) {
            for (std::size_t column = x * columns_ / width_; column * width_ < (x + 1) * columns_;
                 ++column) {
                action(row * columns_ + column);
            }
        }
    };
    std::vector<double> weights(columns_ * rows_);
    double solid_angle = 0.0;
    Imath::Color3<double> sum(0.0);
    for (std::size_t y = 0; y < height_ && !stop.stop_requested(); ++y) {
        const double step = std::numbers::pi / static_cast<double>(height_);
        const double band =
            std::cos(step * static_cast<double>(y)) - std::cos(step * static_cast<double>(y + 1));
        for (std::size_t x = 0; x < width_; ++x) {
            const Color3f mean = 0.125F * smoothed(x, y > 0 ? y - 1 : y) + 0.75F * smoothed(x, y) +
                                 0.125F * smoothed(x, std::min(y + 1, height_ - 1));
            for_each_cell(x, y, [&](std::size_t cell) {
                weights[cell] += static_cast<double>(luminance(mean));
            });
            sum += band * Imath::Color3<double>(mean);
        }
        solid_angle += band * static_cast<double>(width_);
    }
    mean_ = Color3f(sum / solid_angle);
    for (std::size_t row = 0; row < rows_; ++row) {
        const double band = static_cast<double>(cosines_[row] - cosines_[row + 1]) /
                            static_cast<double>(overlaps(row, rows_, height_));
        for (std::size_t column = 0; column < columns_; ++column) {
            weights[row * columns_ + column] *=
                band / static_cast<double>(overlaps(column, columns_, width_));
        }
    }
    accumulate_weights(weights);
}

void EnvironmentMap::accumulate_weights(std::span<const double> weights) {
    cumulative_columns_.resize(rows_ * (columns_ + 1));
    std::vector<double> row_weights(rows_);
    for (std::size_t row = 0; row < rows_; ++row) {
        row_weights[row] =
            accumulate(weights.subspan(row * columns_, columns_),
                       std::span(cumulative_columns_).subspan(row * (columns_ + 1), columns_ + 1));
    }
    cumulative_rows_.resize(rows_ + 1);
    const double total = accumulate(row_weights, cumulative_rows_);
    sector_rows_.resize(sector_columns * (rows_ + 1));
    const std::size_t columns = columns_ / sector_columns;
    for (std::size_t part = 0; total > 0.0 && part < sector_columns; ++part) {
        double sum = 0.0;
        for (std::size_t row = 0; row < rows_; ++row) {
            for (const double weight : weights.subspan(row * columns_ + part * columns, columns)) {
                sum += weight / total;
            }
            sector_rows_[part * (rows_ + 1) + row + 1] = static_cast<float>(sum);
        }
    }
}

}  // namespace balcony::render
