// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/ray_arrays.hpp"

#include <algorithm>
#include <vector>

#include "base/parallel_for.hpp"

namespace balcony::bridge {

namespace {

using rays::RayBatch;
using rays::V3d;

// A part of a picture whose rays stay in the cache until they are written.
constexpr std::size_t side = 64;
constexpr std::size_t points_at_once = side * side;

void put(const V3d& vector, double* at) {
    at[0] = vector.x;
    at[1] = vector.y;
    at[2] = vector.z;
}

// Ray i of a batch as ray `to` of the arrays.
void put_ray(const RayBatch& rays, std::size_t i, const RayArrays& arrays, std::size_t to) {
    const bool valid = rays.valid(i);
    const auto put_if_valid = [&](double* array, std::size_t numbers, std::size_t first,
                                  const V3d& vector) {
        if (array != nullptr) {
            put(valid ? vector : V3d(0.0), array + numbers * to + first);
        }
    };
    put_if_valid(arrays.origins, 3, 0, rays.origin(i));
    put_if_valid(arrays.directions, 3, 0, rays.direction(i));
    if (arrays.valid != nullptr) {
        arrays.valid[to] = valid ? 1 : 0;
    }
    if (arrays.parameters != nullptr) {
        const Imath::V2d parameters = valid ? rays.parameters(i) : Imath::V2d(0.0);
        arrays.parameters[2 * to] = parameters.x;
        arrays.parameters[2 * to + 1] = parameters.y;
    }
    if (arrays.footprints != nullptr) {
        put_if_valid(arrays.footprints, 12, 0, rays.origin_by_x(i));
        put_if_valid(arrays.footprints, 12, 3, rays.origin_by_y(i));
        put_if_valid(arrays.footprints, 12, 6, rays.direction_by_x(i));
        put_if_valid(arrays.footprints, 12, 9, rays.direction_by_y(i));
    }
    if (arrays.times != nullptr) {
        arrays.times[to] = valid ? rays.time(i) : 0.0;
    }
}

void fill_rows(const RayGrid& grid, std::size_t first, std::size_t count, const RayArrays& arrays) {
    rays::Scratch scratch;
    RayBatch rays;
    for (std::size_t x = 0; x < grid.width(); x += side) {
        const std::size_t width = std::min(side, grid.width() - x);
        grid.run(x, first, width, count, scratch, rays);
        for (std::size_t row = 0; row < count; ++row) {
            for (std::size_t column = 0; column < width; ++column) {
                put_ray(rays, row * width + column, arrays,
                        (first + row) * grid.width() + x + column);
            }
        }
    }
}

void fill_points(const RayGrid& grid, std::span<const Imath::V2d> points, std::size_t first,
                 const RayArrays& arrays) {
    std::vector<double> x;
    std::vector<double> y;
    for (const Imath::V2d& point : points) {
        x.push_back(point.x);
        y.push_back(point.y);
    }
    rays::Scratch scratch;
    RayBatch rays;
    grid.run_at(x, y, scratch, rays);
    for (std::size_t i = 0; i < points.size(); ++i) {
        put_ray(rays, i, arrays, first + i);
    }
}

// Calls visit(first, count) for parts of a number of things.
template <class Visit>
bool for_each_part(std::size_t size, std::size_t part, const std::stop_token& stop,
                   const Visit& visit) {
    parallel_for((size + part - 1) / part, [&](std::size_t i) {
        if (!stop.stop_requested()) {
            visit(i * part, std::min(part, size - i * part));
        }
    });
    return !stop.stop_requested();
}

}  // namespace

bool fill(const RayGrid& grid, const RayArrays& arrays, const std::stop_token& stop) {
    return for_each_part(grid.height(), side, stop, [&](std::size_t first, std::size_t count) {
        fill_rows(grid, first, count, arrays);
    });
}

bool fill(const RayGrid& grid, std::span<const Imath::V2d> points, const RayArrays& arrays,
          const std::stop_token& stop) {
    return for_each_part(points.size(), points_at_once, stop,
                         [&](std::size_t first, std::size_t count) {
                             fill_points(grid, points.subspan(first, count), first, arrays);
                         });
}

}  // namespace balcony::bridge
