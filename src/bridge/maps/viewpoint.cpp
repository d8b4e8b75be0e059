// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>

#include <Imath/ImathMatrix.h>

#include "balcony/st_maps.hpp"

namespace balcony::bridge {

namespace {

struct Line {
    V3d origin, direction;
};

std::vector<Line> sampled_lines(const RayGrid& grid) {
    constexpr std::size_t most = 128;
    const std::size_t columns = std::min(grid.width(), most);
    const std::size_t rows = std::min(grid.height(), most);
    std::vector<Line> lines;
    rays::Scratch scratch;
    rays::RayBatch batch;
    for (std::size_t j = 0; j < rows; ++j) {
        for (std::size_t i = 0; i < columns; ++i) {
            grid.run((2 * i + 1) * grid.width() / (2 * columns),
                     (2 * j + 1) * grid.height() / (2 * rows), 1, 1, scratch, batch);
            if (batch.valid(0)) {
                lines.push_back({batch.origin(0), batch.direction(0)});
            }
        }
    }
    return lines;
}

}  // namespace

// The point p for which the sum of |(I - d dᵀ)(p - o)|² is least: that of (I - d dᵀ), times p, is
// that of (I - d dᵀ) o. Relative to the mean of the origins, so that it is exact far away, and next
// to it where all rays are parallel.
Viewpoint find_viewpoint(const RayGrid& grid) {
    const std::vector<Line> lines = sampled_lines(grid);
    if (lines.empty()) {
        return {};
    }
    const auto count = static_cast<double>(lines.size());
    V3d mean(0.0);
    for (const Line& line : lines) {
        mean += line.origin / count;
    }
    Imath::M33d sum;
    sum.makeIdentity();
    constexpr double parallel = 1e-12;
    sum *= parallel * count;
    V3d right(0.0);
    for (const Line& line : lines) {
        const V3d& d = line.direction;
        const V3d o = line.origin - mean;
        right += o - (d ^ o) * d;
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k) {
                sum[i][k] += (i == k ? 1.0 : 0.0) - d[i] * d[k];
            }
        }
    }
    Viewpoint found;
    found.point = mean + right * sum.inverse();
    std::vector<double> distances;
    for (const Line& line : lines) {
        const V3d to = line.origin - found.point;
        distances.push_back((to % line.direction).length());
        found.spread = std::max(found.spread, to.length());
    }
    std::sort(distances.begin(), distances.end());
    found.largest = distances.back();
    found.median = distances[distances.size() / 2];
    return found;
}

}  // namespace balcony::bridge
