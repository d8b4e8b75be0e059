// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The loops over the pixels of a row are plain, so that the compiler vectorises them.

#include "film/denoise/surface_filter.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

#include "images/luminance.hpp"

namespace balcony::render {

namespace {

// Rows are filtered in pieces, whose sums stay in the cache.
constexpr std::size_t piece = 128;
using Piece = std::array<float, piece>;

void add_weighted(float* __restrict sums, const float* __restrict weights,
                  const float* __restrict values, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) {
        sums[k] += weights[k] * values[k];
    }
}

}  // namespace

// Pixels of a row, each with the pixel at the same offset.
struct SurfaceFilter::Row {
    std::size_t here = 0;  // The index of the first one.
    std::size_t there = 0;
    std::size_t count = 0;

    // The part of `count` pixels from (x, y) on whose neighbours at the offset (right, down) are
    // within the canvas, and the number of the first one.
    static std::pair<Row, std::size_t> within(const Canvas& canvas, std::size_t x, std::size_t y,
                                              std::size_t count, std::ptrdiff_t right,
                                              std::ptrdiff_t down) {
        const auto width = static_cast<std::ptrdiff_t>(canvas.width);
        const auto column = static_cast<std::ptrdiff_t>(x);
        const auto row = static_cast<std::ptrdiff_t>(y) + down;
        const std::ptrdiff_t begin = std::max(column, -right);
        const std::ptrdiff_t end =
            std::min(column + static_cast<std::ptrdiff_t>(count), width - right);
        if (row < 0 || row >= static_cast<std::ptrdiff_t>(canvas.height) || begin >= end) {
            return {};
        }
        const auto here = static_cast<std::ptrdiff_t>(y) * width + begin;
        return {
            {static_cast<std::size_t>(here), static_cast<std::size_t>(here + down * width + right),
             static_cast<std::size_t>(end - begin)},
            static_cast<std::size_t>(begin - column)};
    }
};

SurfaceFilter::SurfaceFilter(Surfaces surfaces, const Canvas& canvas)
    : surfaces_(std::move(surfaces)),
      canvas_(canvas),
      sensitivity_(canvas.size()),
      importance_(canvas.size()) {
    find_sensitivities();
    find_importances();
}

// Light that is divided by the albedo counts by the albedo, such that what pixels have together is
// kept. A pixel that shows a surface only in part counts by that part.
void SurfaceFilter::find_importances() {
    constexpr float least = 0.02F;
    const std::array<Plane, 3>& albedo = surfaces_.albedo;
    for_each_pixel(canvas_, [&](std::size_t i) {
        importance_[i] =
            std::max(luminance(Imath::Color3f(albedo[0][i], albedo[1][i], albedo[2][i])), least);
    });
}

// The squared differences of normals and of albedos, and the squared sine of the angle between the
// surface and the way from one point to the other, relative to the square of what is tolerated.
void SurfaceFilter::add_distances(const Row& row, float* __restrict distances) const {
    constexpr float per_normal = 20.0F;
    constexpr float per_slope = 50.0F;
    constexpr float per_albedo = 30.0F;
    const auto pointers = [](const std::array<Plane, 3>& planes, std::size_t at) {
        return std::array{planes[0].data() + at, planes[1].data() + at, planes[2].data() + at};
    };
    const auto [nx, ny, nz] = pointers(surfaces_.normal, row.here);
    const auto [mx, my, mz] = pointers(surfaces_.normal, row.there);
    const auto [ar, ag, ab] = pointers(surfaces_.albedo, row.here);
    const auto [br, bg, bb] = pointers(surfaces_.albedo, row.there);
    const auto [px, py, pz] = pointers(surfaces_.position, row.here);
    const auto [qx, qy, qz] = pointers(surfaces_.position, row.there);
    const auto square = [](float v) { return v * v; };
    for (std::size_t k = 0; k < row.count; ++k) {
        const float turn = square(mx[k] - nx[k]) + square(my[k] - ny[k]) + square(mz[k] - nz[k]);
        const float tint = square(br[k] - ar[k]) + square(bg[k] - ag[k]) + square(bb[k] - ab[k]);
        const float x = qx[k] - px[k];
        const float y = qy[k] - py[k];
        const float z = qz[k] - pz[k];
        const float length = square(nx[k]) + square(ny[k]) + square(nz[k]);
        const float rise = square(x * nx[k] + y * ny[k] + z * nz[k]);
        const float slope = rise / ((x * x + y * y + z * z) * std::max(length, 0.01F) + 1e-20F);
        distances[k] += per_normal * turn + per_albedo * tint + per_slope * slope;
    }
}

// A pixel at an edge, which shows a mixture of surfaces, resembles no other one closely. Distances
// are relative to that of its third nearest neighbour, so that it still has some.
void SurfaceFilter::find_sensitivities() {
    for_each_row(canvas_, [&](std::size_t y) {
        for (std::size_t x = 0; x < canvas_.width; x += piece) {
            std::array<Piece, 3> least;
            for (Piece& each : least) {
                each.fill(std::numeric_limits<float>::max());
            }
            for (std::ptrdiff_t down = -1; down <= 1; ++down) {
                for (std::ptrdiff_t right = -1; right <= 1; ++right) {
                    const auto [row, begin] =
                        Row::within(canvas_, x, y, std::min(piece, canvas_.width - x), right, down);
                    if (row.here == row.there) {
                        continue;
                    }
                    Piece distances{};
                    add_distances(row, distances.data());
                    for (std::size_t k = 0; k < row.count; ++k) {
                        float other = distances[k];
                        for (Piece& each : least) {
                            const float smaller = std::min(each[begin + k], other);
                            other = std::max(each[begin + k], other);
                            each[begin + k] = smaller;
                        }
                    }
                }
            }
            for (std::size_t k = 0; k < std::min(piece, canvas_.width - x); ++k) {
                const float third = std::min({least[2][k], 1e6F});
                sensitivity_[y * canvas_.width + x + k] = 1.0F / (1.0F + third);
            }
        }
    });
}

namespace {

void add_light_distances(const Guide& guide, std::size_t here, std::size_t there, std::size_t count,
                         float* __restrict distances) {
    constexpr float rounding = 1e-10F;
    const float spread = guide.tolerance * guide.tolerance;
    const float* const a = guide.value.data() + here;
    const float* const b = guide.value.data() + there;
    const float* const a_variance = guide.variance.data() + here;
    const float* const b_variance = guide.variance.data() + there;
    for (std::size_t k = 0; k < count; ++k) {
        const float difference = a[k] - b[k];
        distances[k] += difference * difference /
                        (spread * (a_variance[k] + b_variance[k]) +
                         rounding * (a[k] * a[k] + b[k] * b[k]) + 1e-30F);
    }
}

// About exp(-distance), and 0 from 8 on.
void find_weights(const float* __restrict distances, float factor, std::size_t count,
                  float* __restrict weights) {
    for (std::size_t k = 0; k < count; ++k) {
        float root = std::max(1.0F - 0.125F * distances[k], 0.0F);
        root *= root;
        root *= root;
        weights[k] = factor * root * root;
    }
}

}  // namespace

Stack SurfaceFilter::filtered(const Stack& images, std::size_t spacing, const Guide* guide) const {
    constexpr std::array kernel{0.375F, 0.25F, 0.0625F};
    constexpr std::ptrdiff_t reach = 2;
    const auto step = static_cast<std::ptrdiff_t>(spacing);
    Stack made;
    made.fill(Plane(canvas_.size()));
    const auto filter_piece = [&](std::size_t x, std::size_t y) {
        const std::size_t count = std::min(piece, canvas_.width - x);
        Piece total{};
        std::array<Piece, std::tuple_size_v<Stack>> sums{};
        for (std::ptrdiff_t down = -reach; down <= reach; ++down) {
            for (std::ptrdiff_t right = -reach; right <= reach; ++right) {
                const auto [row, begin] =
                    Row::within(canvas_, x, y, count, step * right, step * down);
                Piece distances{};
                add_distances(row, distances.data());
                for (std::size_t k = 0; k < row.count; ++k) {
                    distances[k] *= sensitivity_[row.here + k];
                }
                if (guide != nullptr) {
                    add_light_distances(*guide, row.here, row.there, row.count, distances.data());
                }
                Piece weights;
                find_weights(distances.data(),
                             kernel[static_cast<std::size_t>(std::abs(down))] *
                                 kernel[static_cast<std::size_t>(std::abs(right))],
                             row.count, weights.data());
                for (std::size_t k = 0; k < row.count; ++k) {
                    weights[k] *= importance_[row.there + k];
                    total[begin + k] += weights[k];
                }
                for (std::size_t image = 0; image < images.size(); ++image) {
                    add_weighted(sums[image].data() + begin, weights.data(),
                                 images[image].data() + row.there, row.count);
                }
            }
        }
        for (std::size_t image = 0; image < images.size(); ++image) {
            for (std::size_t k = 0; k < count; ++k) {
                made[image][y * canvas_.width + x + k] = sums[image][k] / total[k];
            }
        }
    };
    for_each_row(canvas_, [&](std::size_t y) {
        for (std::size_t x = 0; x < canvas_.width; x += piece) {
            filter_piece(x, y);
        }
    });
    return made;
}

}  // namespace balcony::render
