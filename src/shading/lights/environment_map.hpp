// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Radiance by direction as an equirectangular picture, and directions chosen in proportion to it.

#include <cstddef>
#include <span>
#include <stop_token>
#include <vector>

#include <Imath/ImathColor.h>
#include <Imath/ImathVec.h>

namespace balcony::render {

/// Directions have z up. The centre of the picture is x, its left side turns to y, and its top is
/// z.
class EnvironmentMap {
public:
    struct Sample {
        Imath::V3f direction;
        float pdf = 0.0F;  ///< By solid angle.
    };

    /// Rows from the top. Radiance is finite and not negative. After a stop, the map is of no use.
    EnvironmentMap(std::size_t width, std::size_t height, std::vector<Imath::Color3f> texels,
                   const std::stop_token& stop = {});

    /// Interpolated between the centres of the pixels.
    [[nodiscard]] Imath::Color3f radiance(const Imath::V3f& direction) const;

    /// A direction chosen by luminance. Only if the map is not black.
    [[nodiscard]] Sample sample(const Imath::V2f& random) const;
    [[nodiscard]] float pdf(const Imath::V3f& direction) const;

    /// Directions are divided into sectors: bands by the angle from z, each cut by longitude.
    static constexpr std::size_t sector_columns = 32;
    static constexpr std::size_t sector_rows = 16;
    static constexpr std::size_t sector_count = sector_columns * sector_rows;
    /// The sector of a direction, below sector_count.
    [[nodiscard]] static std::size_t sector_of(const Imath::V3f& direction);
    /// The probability that sample() finds a direction of a sector.
    [[nodiscard]] float probability(std::size_t sector) const;
    /// A direction of a sector whose probability is not 0, chosen by luminance. The density is that
    /// of sample(), as if any sector could have been chosen.
    [[nodiscard]] Sample sample(std::size_t sector, const Imath::V2f& random) const;

    /// Over all directions.
    [[nodiscard]] const Imath::Color3f& mean() const { return mean_; }
    [[nodiscard]] bool is_black() const { return cumulative_rows_.back() <= 0.0F; }
    [[nodiscard]] bool is_constant() const { return texels_.size() == 1; }

private:
    [[nodiscard]] const Imath::Color3f& texel(std::size_t x, std::size_t y) const {
        return texels_[y * width_ + x];
    }
    void build_distribution(const std::stop_token& stop);
    void accumulate_weights(std::span<const double> weights);
    [[nodiscard]] float density(std::size_t row, std::size_t column) const;

    std::size_t width_;
    std::size_t height_;
    std::vector<Imath::Color3f> texels_;
    Imath::Color3f mean_{0.0F};

    [[nodiscard]] Sample sample_cell(std::size_t row, std::size_t column,
                                     const Imath::V2f& within) const;
    [[nodiscard]] std::span<const float> rows_of(std::size_t sector) const;

    // The distribution of directions is constant in each cell of a grid, which divides each sector
    // evenly. Cumulative probabilities begin at 0.
    std::size_t columns_ = sector_columns;
    std::size_t rows_ = sector_rows;
    std::vector<float> cosines_;             // Of the angle from z, at the borders of rows.
    std::vector<float> cumulative_rows_;     // rows + 1; all 0 if black.
    std::vector<float> cumulative_columns_;  // columns + 1 for each row.
    std::vector<float> sector_rows_;  // rows + 1 for each column of sectors: without the others.
};

}  // namespace balcony::render
